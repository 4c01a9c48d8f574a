// Spheres, routes and their projection.
#include <gtest/gtest.h>

#include "out/xml_balance.hpp"
#include "study/intrusion.hpp"
#include "study/page/camera.hpp"
#include "study/page/scene_view.hpp"

namespace alate {
namespace {

Threat sphere(const Vec3& center, double radius, const std::string& name = "S") {
  return {.name = name, .center = center, .radius_m = radius};
}

Route straight(std::initializer_list<Vec3> points) {
  Route route;
  for (const Vec3& point : points) route.states.push_back({.position = point});
  route.states.front().leg = LegKind::start;
  return route;
}

TEST(Intrusion, SeesWhatLiesBetweenNodes) {
  const Route route = straight({{0, 0, 0}, {4, 0, 0}, {8, 0, 0}});
  const Intrusion depth = deepest_intrusion(sphere({2, 1, 0}, 2), route);
  EXPECT_DOUBLE_EQ(depth.along_legs, 1);
  EXPECT_DOUBLE_EQ(depth.at_nodes, 2 - std::sqrt(5.0));
}

TEST(Intrusion, LeavesOutTheStartAtNodesOnly) {
  const Route route = straight({{0, 0, 0}, {4, 0, 0}});
  const Intrusion depth = deepest_intrusion(sphere({0, 0, 0}, 1), route);
  EXPECT_DOUBLE_EQ(depth.along_legs, 1);
  EXPECT_DOUBLE_EQ(depth.at_nodes, -3);
}

TEST(Camera, KeepsLengthsAcrossTheView) {
  for (const double azimuth : {0.0, 1.0, 4.0}) {
    const Camera camera(azimuth, radians(30));
    const Vec3 point{1.5, -2, 0.7};
    const Vec2 seen = camera.project(point);
    EXPECT_NEAR(seen.squaredNorm() + camera.depth(point) * camera.depth(point), point.squaredNorm(), 1e-12);
    EXPECT_GT(camera.project(Vec3::UnitZ()).y(), 0) << "up is up";
    EXPECT_NEAR(camera.project(Vec3::UnitZ()).x(), 0, 1e-12);
    EXPECT_GT(camera.depth(direction_of(azimuth)), 0) << "what is on the viewer's side is nearer";
  }
  const Camera from_south(kPi, 0);
  EXPECT_NEAR(from_south.project(Vec3::UnitX()).x(), 1, 1e-12) << "east is to the right";
}

Site two_spheres() {
  Site site;
  site.mission = {.start = {0, 0, 0}, .goal = {10, 10, 5}, .tolerance_m = 1};
  site.threats = {sphere({5, 2, 3}, 2, "near <script>"), sphere({2, 8, 3}, 2, "far & away")};
  return site;
}

TEST(Scene, IsWellFormedAndEscaped) {
  const Route route = straight({{0, 0, 0}, {5, 5, 2}, {10, 10, 5}});
  const std::string svg = scene_svg(two_spheres(), {{.route = &route, .css_class = "w0"}}, "a < b");
  EXPECT_EQ(test::xml_fault(svg), "");
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_NE(svg.find("near &lt;script&gt;"), std::string::npos);
}

/// The viewer stands in the south-east.
TEST(Scene, DrawsNearSpheresOverFarOnes) {
  const std::string svg = scene_svg(two_spheres(), {}, "spheres");
  const std::size_t near = svg.find("<title>near");
  const std::size_t far = svg.find("<title>far");
  ASSERT_NE(near, std::string::npos);
  ASSERT_NE(far, std::string::npos);
  EXPECT_LT(far, near);
}

}  // namespace
}  // namespace alate
