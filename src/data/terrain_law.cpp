#include "data/terrain_law.hpp"

#include <algorithm>
#include <cmath>

#include "alate/core/stream.hpp"
#include "data/gradient_noise.hpp"

namespace alate {

namespace {

DrawnTerrain level_ground(int side, float height_m) {
  const auto posts = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  return {.side = side, .posts = std::vector<float>(posts, height_m)};
}

Vec2 nearest_post(const Vec2& place) {
  return kDrawnCell_m * Vec2(std::round(place.x() / kDrawnCell_m), std::round(place.y() / kDrawnCell_m));
}

/// Calls at(column, row, place) for every post.
template <class At>
void for_posts(const DrawnTerrain& terrain, const At& at) {
  for (int row = 0; row < terrain.side; ++row)
    for (int column = 0; column < terrain.side; ++column) at(column, row, terrain.place(column, row));
}

double distance(const Vec2& place, const Vec2& a, const Vec2& b) {
  const Vec2 way = b - a;
  const double t = std::clamp((place - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return std::sqrt((a + t * way - place).squaredNorm());
}

// The canyon.
constexpr double kPlain_m = 800;
constexpr double kBed_m = 500;  ///< Height of the canyon's bed.
constexpr double kHalfBed_m = 60;
constexpr double kWallSlope = 1.5;
constexpr double kBendEvery_m = 750;

/// Cuts a stretch of canyon into the plain.
void carve(DrawnTerrain& terrain, const Vec2& a, const Vec2& b) {
  constexpr double kReach_m = kHalfBed_m + (kPlain_m - kBed_m) / kWallSlope;
  const auto index = [&](double along) {
    return std::clamp(static_cast<int>(along / kDrawnCell_m), 0, terrain.side - 1);
  };
  const int last = terrain.side - 1;
  for (int row = last - index(std::max(a.y(), b.y()) + kReach_m);
       row <= last - index(std::min(a.y(), b.y()) - kReach_m); ++row)
    for (int column = index(std::min(a.x(), b.x()) - kReach_m); column <= index(std::max(a.x(), b.x()) + kReach_m);
         ++column) {
      const double beyond = std::max(0.0, distance(terrain.place(column, row), a, b) - kHalfBed_m);
      float& post = terrain.post(column, row);
      post = std::min(post, static_cast<float>(kBed_m + kWallSlope * beyond));
    }
}

/// A parabola whose tangents meet at `corner`, and a dead end beyond it.
struct Bend {
  Vec2 from, corner, to;
  double dead_end_m = 0;
};

void carve(DrawnTerrain& terrain, const Bend& bend) {
  const auto& [from, corner, to, dead_end_m] = bend;
  constexpr int kPieces = 16;
  Vec2 before = from;
  for (int i = 1; i <= kPieces; ++i) {
    const double t = static_cast<double>(i) / kPieces;
    const Vec2 next = (1 - t) * (1 - t) * from + 2 * t * (1 - t) * corner + t * t * to;
    carve(terrain, before, next);
    before = next;
  }
  const Vec2 way = corner - from;
  carve(terrain, from, corner + dead_end_m / std::sqrt(way.squaredNorm()) * way);
}

DrawnTerrain draw_canyon(int side, std::uint64_t seed) {
  constexpr double kMostSwing_m = 1000;
  constexpr double kDeadEnd_m = 500;
  constexpr double kFromSide_m = 150;
  DrawnTerrain terrain = level_ground(side, static_cast<float>(kPlain_m));
  const double width = terrain.width_m();
  const double swing_m = std::min(kMostSwing_m, width / 5);
  const auto bends = static_cast<std::size_t>(std::max(2.0, std::floor(width / kBendEvery_m)));
  Stream random(seed, 0, 0);
  std::vector<Vec2> corners;
  for (std::size_t i = 0; i <= bends; ++i) {
    const double swing = (i % 2 == 0 ? 1 : -1) * swing_m * (0.5 + random.uniform());
    corners.emplace_back(width * static_cast<double>(i) / static_cast<double>(bends), width / 2 + swing);
  }
  for (std::size_t i = 1; i < bends; ++i) {
    const Vec2 from = i == 1 ? corners[0] : Vec2(0.5 * (corners[i - 1] + corners[i]));
    const Vec2 to = i + 1 == bends ? corners[bends] : Vec2(0.5 * (corners[i] + corners[i + 1]));
    carve(terrain, Bend{from, corners[i], to, kDeadEnd_m * (0.5 + random.uniform())});
  }
  constexpr double kRough_m = 40;
  const GradientNoise rough(250, width, Stream(seed, 1, 0));
  for_posts(terrain, [&](int column, int row, const Vec2& place) {
    float& post = terrain.post(column, row);
    const double depth = kPlain_m - double{post};
    post = static_cast<float>(std::round(double{post} + std::min(kRough_m, 0.3 * depth) * rough(place)));
  });
  const auto inward = [&](const Vec2& end, const Vec2& next) {
    const Vec2 way = next - end;
    return nearest_post(end + kFromSide_m / std::sqrt(way.squaredNorm()) * way);
  };
  terrain.start = inward(corners[0], corners[1]);
  terrain.goal = inward(corners[bends], corners[bends - 1]);
  return terrain;
}

/// Between a twentieth and an eighth of the width from both sides of a corner.
Vec2 lowest_near_corner(const DrawnTerrain& terrain, bool north_east) {
  const int from = terrain.side / 20;
  const int to = terrain.side / 8;
  Vec2 lowest = terrain.place(from, terrain.side - 1 - from);
  if (north_east) lowest = Vec2::Constant(terrain.width_m()) - lowest;
  for (int i = from; i <= to; ++i)
    for (int j = from; j <= to; ++j) {
      Vec2 place = kDrawnCell_m * Vec2(i, j);
      if (north_east) place = Vec2::Constant(terrain.width_m()) - place;
      if (terrain.height(place) < terrain.height(lowest)) lowest = place;
    }
  return lowest;
}

DrawnTerrain draw_hills(int side, std::uint64_t seed) {
  constexpr double kMiddle_m = 600;
  constexpr double kSteepness = 0.25;  ///< Amplitude over wavelength.
  DrawnTerrain terrain = level_ground(side, static_cast<float>(kMiddle_m));
  std::uint64_t octave = 0;
  for (const double wavelength : {1200.0, 600.0, 300.0, 150.0}) {
    const GradientNoise noise(wavelength, terrain.width_m(), Stream(seed, ++octave, 0));
    for_posts(terrain, [&](int column, int row, const Vec2& place) {
      terrain.post(column, row) += static_cast<float>(kSteepness * wavelength * noise(place));
    });
  }
  for (float& post : terrain.posts) post = std::round(post);
  terrain.start = lowest_near_corner(terrain, false);
  terrain.goal = lowest_near_corner(terrain, true);
  return terrain;
}

}  // namespace

double DrawnTerrain::height(const Vec2& place) const {
  const auto column = static_cast<std::size_t>(std::lround(place.x() / kDrawnCell_m));
  const auto row = static_cast<std::size_t>(side) - 1 - static_cast<std::size_t>(std::lround(place.y() / kDrawnCell_m));
  return double{posts[row * static_cast<std::size_t>(side) + column]};
}

DrawnTerrain draw_terrain(TerrainLaw law, int side, std::uint64_t seed) {
  return law == TerrainLaw::canyon ? draw_canyon(side, seed) : draw_hills(side, seed);
}

}  // namespace alate
