#include "out/route_files.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "support.hpp"
#include "xml_balance.hpp"

namespace alate {
namespace {

using Json = nlohmann::json;
using test::Flight;
using test::to_write;

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> cells{""};
  for (const char c : line) c == separator ? static_cast<void>(cells.emplace_back()) : cells.back().push_back(c);
  return cells;
}

TEST(RouteCsv, HasOneHeaderLineAndOneLineAState) {
  Flight flight;
  flight.find_route();
  flight.result.plan.route.states[1].position.x() = 5000.1 + 0.2;
  std::istringstream csv(route_csv(to_write(flight)));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "leg,kind,x_m,y_m,z_m,lat,lon,amsl_m,agl_m,heading_deg,point_id");
  std::vector<std::vector<std::string>> rows;
  while (std::getline(csv, line)) rows.push_back(split(line, ','));
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) EXPECT_EQ(row.size(), 11U);
  EXPECT_EQ(rows[0][1], "start");
  EXPECT_EQ(std::stod(rows[1][2]), 5000.1 + 0.2);
  EXPECT_NEAR(std::stod(rows[0][9]), 45, 1e-12);
  EXPECT_EQ(rows[2][10], "");
  EXPECT_EQ(rows[3][10], "7");
}

TEST(RouteCsv, LeavesPlacesEmptyInALocalFrameWithoutGround) {
  Flight flight;
  flight.find_route();
  flight.site.frame = Frame::local();
  flight.site.ground = std::monostate{};
  std::istringstream csv(route_csv(to_write(flight)));
  std::string line;
  std::getline(csv, line);
  std::getline(csv, line);
  const auto row = split(line, ',');
  EXPECT_EQ(row[5] + row[6] + row[8], "");
  EXPECT_EQ(row[7], "150");
}

TEST(RouteCsv, PointsAlongTheTangentAtTheEndOfAnArc) {
  Flight flight;
  Route& route = flight.result.plan.route;
  route.states.push_back({.position = {0, 0, 100}, .leg = LegKind::start});
  // A right turn from north to east about (100, 0).
  route.states.push_back({.position = {100, 100, 100}, .leg = LegKind::arc});
  route.states[1].arc = Arc{.center = {100, 0}, .radius_m = 100, .angle_rad = kPi / 2};
  EXPECT_NEAR(route_points(flight.site, route)[1].heading_rad, kPi / 2, 1e-12);
  // The drawn line follows the circle.
  for (const Vec3& at : drawn_line(route)) EXPECT_NEAR((at.head<2>() - Vec2{100, 0}).norm(), 100, 1e-9);
  EXPECT_GT(drawn_line(route).size(), 15U);
}

TEST(RouteCsv, DrawsATiltedArcAsItIsFlown) {
  Flight flight;
  Route& route = flight.result.plan.route;
  route.states.push_back({.position = {0, 0, 100}, .leg = LegKind::start});
  // From north straight up.
  route.states.push_back({.position = {0, 100, 200}, .leg = LegKind::arc});
  route.states[1].arc =
      Arc{.center = {0, 0}, .radius_m = 100, .angle_rad = kPi / 2, .plane = ArcPlane{200, Vec3::UnitX()}};
  for (const Vec3& at : drawn_line(route)) EXPECT_NEAR((at - Vec3{0, 0, 200}).norm(), 100, 1e-9);
  EXPECT_GT(drawn_line(route).size(), 15U);
}

TEST(RouteGeoJson, FollowsRfc7946) {
  Flight flight;
  flight.find_route();
  const Json json = Json::parse(route_geojson(to_write(flight)));
  EXPECT_EQ(json["type"], "FeatureCollection");
  EXPECT_FALSE(json.contains("crs"));
  EXPECT_TRUE(json.contains("datum"));
  EXPECT_NE(json["notice"].get<std::string>().find("not clearance to fly"), std::string::npos);
  const Json& line = json["features"][0]["geometry"];
  EXPECT_EQ(line["type"], "LineString");
  ASSERT_EQ(line["coordinates"].size(), 4U);
  EXPECT_NEAR(line["coordinates"][0][0], 9.81, 0.01);  // longitude first
  EXPECT_NEAR(line["coordinates"][0][1], 46.81, 0.01);
  EXPECT_EQ(line["coordinates"][0][2], 150);
}

/// What GDAL reads from a route file: the vertices of its first line.
std::vector<std::array<double, 3>> line_by_gdal(const std::string& name, const std::string& text) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / name;
  test::write_text(file, text);
  GDALAllRegister();
  const std::unique_ptr<GDALDataset> data(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR));
  std::vector<std::array<double, 3>> vertices;
  if (!data) return vertices;
  for (auto* layer : data->GetLayers()) {
    for (const auto& feature : *layer) {
      const auto* geometry = feature->GetGeometryRef();
      if (!vertices.empty() || wkbFlatten(geometry->getGeometryType()) != wkbLineString) continue;
      for (const OGRPoint& p : *geometry->toLineString()) vertices.push_back({p.getX(), p.getY(), p.getZ()});
    }
  }
  return vertices;
}

TEST(RouteFiles, AreReadByGdalAsTheyWereWritten) {
  Flight flight;
  flight.find_route();
  const RouteToWrite route = to_write(flight);
  for (const auto& [name, text] : {std::pair{"route.kml", route_kml(route)}, {"route.geojson", route_geojson(route)}}) {
    const auto line = line_by_gdal(name, text);
    ASSERT_EQ(line.size(), route.points.size()) << name;
    for (std::size_t i = 0; i < line.size(); ++i) {
      EXPECT_NEAR(line[i][0], route.points[i].geo->lon_deg, 1e-8) << name;
      EXPECT_NEAR(line[i][1], route.points[i].geo->lat_deg, 1e-8) << name;
      EXPECT_NEAR(line[i][2], route.points[i].state.position.z(), 1e-3) << name;
    }
  }
}

TEST(RouteKml, IsWellFormedWhateverTheNames) {
  Flight flight;
  flight.find_route();
  flight.site.threats[0].name = "<script>alert(1)</script> & \x01";
  flight.site.threats.push_back({.name = "tower",
                                 .shape = Threat::Shape::cylinder,
                                 .center = {2000, 2000, 0},
                                 .radius_m = 200,
                                 .floor_m = 0,
                                 .top_m = 400});
  const std::string kml = route_kml(to_write(flight));
  EXPECT_EQ(test::xml_fault(kml), "");
  EXPECT_EQ(kml.find("<script"), std::string::npos);
  EXPECT_NE(kml.find("&lt;script&gt;alert(1)&lt;/script&gt;"), std::string::npos);
  EXPECT_NE(kml.find("<altitudeMode>absolute"), std::string::npos);
  EXPECT_NE(kml.find("not clearance to fly"), std::string::npos);
}

TEST(RouteGeoJson, HasNoLineForASinglePoint) {
  Flight flight;
  flight.find_route();
  flight.result.plan.route.states.resize(1);
  const Json json = Json::parse(route_geojson(to_write(flight)));
  for (const Json& feature : json["features"]) EXPECT_EQ(feature["geometry"]["type"], "Point");
}

}  // namespace
}  // namespace alate
