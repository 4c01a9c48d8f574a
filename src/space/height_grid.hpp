// A height grid as ants see it: from each cell up to eight moves, without cutting corners.
//
// Source: Yin et al. 2021 and, for what that paper leaves to its baseline, the public program of Li et al. 2019 (called
// source C below). Moves, heights and distances stand in arrays by cell; which moves are free is worked out once.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "alate/data/height_grid.hpp"
#include "space/choices.hpp"

namespace alate {

/// How routes on a grid are judged: composite index S = length * L + height_dev * F + turns * T; weights
/// 1 : 100 : 1 in source C, not in the prose of the paper.
struct GridScore {
  /// Which cells F is taken over: those of the route, or, as source C does by mistake, as many cells of the height
  /// matrix, column by column from the upper left.
  enum class HeightsOf { route, matrix };

  double length = 1;
  double height_dev = 0;
  double turns = 0;
  HeightsOf heights_of = HeightsOf::route;

  bool length_only() const { return height_dev == 0 && turns == 0; }
};

/// Cells are numbered row by row with a rim of blocked cells around, so that no move leaves the arrays. Directions run
/// counter-clockwise from east; odd ones are diagonal. A diagonal is free only if the cells on both its sides are.
class GridSpace {
 public:
  using Cell = std::uint32_t;
  static constexpr unsigned kDirections = 8;
  static constexpr unsigned kNoDirection = kDirections;

  struct Ends {
    int start_column = 0, start_row = 0;
    int goal_column = 0, goal_row = 0;
  };

  /// `grid` must outlive this. `diagonal`: cost of a diagonal step, straight ones cost 1. Start and goal are free.
  GridSpace(const HeightGrid& grid, const Ends& ends, double diagonal, const GridScore& score);

  Cell start() const { return start_; }
  Cell goal() const { return goal_; }
  std::size_t cells() const { return open_.size(); }
  /// Bit d: direction d is free.
  unsigned open(Cell cell) const { return open_[cell]; }
  Cell neighbour(Cell cell, unsigned direction) const {
    return cell + static_cast<Cell>(offsets_[direction]);  // wraps round: the sum is the neighbour's number
  }
  const std::array<std::int32_t, kDirections>& offsets() const { return offsets_; }
  double diagonal() const { return diagonal_; }
  double step(unsigned direction) const { return direction % 2 == 0 ? 1 : diagonal_; }
  float to_goal(Cell cell) const { return to_goal_[cell]; }        ///< d_jE, Euclidean, cell sides.
  float from_start(Cell cell) const { return from_start_[cell]; }  ///< d_Aj.
  float height(Cell cell) const { return height_[cell]; }
  /// Length of the shortest way between two cells were all cells free: no way is shorter.
  double octile(Cell a, Cell b) const;
  int column(Cell cell) const { return static_cast<int>(cell % stride_) - 1; }
  int row(Cell cell) const { return static_cast<int>(cell / stride_) - 1; }
  /// Columns and rows of a step.
  static std::array<int, 2> shift(unsigned direction);

  /// L, F as the score has it, and T: names from the paper, forms from source C.
  GridMeasures measure(std::span<const std::uint32_t> directions) const;
  double score(std::span<const std::uint32_t> directions) const;
  /// Length alone, from the number of moves and how many of them are diagonal.
  double length(std::size_t moves, std::size_t diagonals) const {
    return static_cast<double>(moves - diagonals) + diagonal_ * static_cast<double>(diagonals);
  }
  const GridScore& rule() const { return score_; }

  /// Score and step costs of a string of directions; nothing if a move is not free or the goal is not reached.
  std::optional<FlownActions> fly(std::span<const std::uint32_t> directions) const;

  /// From `from` all cells that moves lead to, 1 for reached.
  std::vector<std::uint8_t> flood(Cell from) const;

 private:
  void note_heights();
  void note_moves();
  double deviation(std::span<const std::uint32_t> directions) const;

  const HeightGrid& grid_;
  GridScore score_;
  double diagonal_;
  std::uint32_t stride_;
  std::array<std::int32_t, kDirections> offsets_{};
  Cell start_;
  Cell goal_;
  std::vector<std::uint8_t> open_;
  AlignedFloats to_goal_, from_start_, height_;
};

}  // namespace alate
