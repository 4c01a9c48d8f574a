// What is wrong with what was published and with the program behind it, in plain words.
#pragma once

#include <vector>

#include "study/yin2021/study.hpp"

namespace alate::yin2021 {

/// Heights of the public program: what F takes for a number of cells.
struct CodedHeights {
  std::size_t runs = 0;
  std::size_t counts = 0;  ///< Different numbers of cells among the routes.
  double least = 0;        ///< F.
  double most = 0;
  bool by_count_alone = true;  ///< Do routes with as many cells always have the same F?
};
CodedHeights coded_heights(const Study& study, Size size);

std::vector<Defect> defects(const Study& study);

}  // namespace alate::yin2021
