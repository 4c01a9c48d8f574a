// Drawn maps that have a way.
#pragma once

#include <vector>

#include "study/yin2021/paper.hpp"

namespace alate::yin2021 {

struct Maps {
  std::vector<StudyCase> cases;
  std::vector<int> seeds;       ///< That drew them.
  std::vector<double> optimum;  ///< Length of the shortest way, cell sides; exact.
  std::size_t passed_over = 0;  ///< Seeds whose map has none.
};

/// Maps of seeds 1, 2, ...: cells blocked with probability 0.2 but for start (lower left) and goal (upper right),
/// heights |peaks|. A map without a way is passed over for that of the next seed.
Maps draw_maps(Size size, std::size_t count);

}  // namespace alate::yin2021
