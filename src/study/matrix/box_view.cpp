#include <fmt/core.h>

#include <algorithm>

#include "out/report/axis.hpp"
#include "study/matrix/views.hpp"

namespace alate {

namespace {

constexpr double kWidth = 420;
constexpr double kRow = 58;
constexpr double kLeft = 14;
constexpr double kRight = 14;
constexpr double kBottom = 56;
constexpr double kHalfBox = 10;

void draw_box(Svg& svg, const Scale& x, double y, const MethodFigures& method) {
  const Spread spread = *spread_of(method.gaps);
  const std::string css = line_class(method);
  const std::string tip = fmt::format("median {:.3g} %, quartiles {:.3g} and {:.3g} %, {} routes", spread.median,
                                      spread.lower_quartile, spread.upper_quartile, method.gaps.size());
  svg.line({x(spread.lower_whisker), y}, {x(spread.upper_whisker), y}, "whisker " + css);
  for (const double end : {spread.lower_whisker, spread.upper_whisker})
    svg.line({x(end), y - kHalfBox / 2}, {x(end), y + kHalfBox / 2}, "whisker " + css);
  svg.rect({x(spread.lower_quartile), y - kHalfBox},
           {std::max(1.0, x(spread.upper_quartile) - x(spread.lower_quartile)), 2 * kHalfBox}, "box " + css, tip);
  svg.line({x(spread.median), y - kHalfBox}, {x(spread.median), y + kHalfBox}, "median " + css);
  for (const double outlier : spread.outliers) svg.circle({x(outlier), y}, 2.5, "outlier " + css);
}

}  // namespace

std::string box_svg(const Study& study, const StudyAnalysis& analysis, std::size_t budget) {
  double most = 0;
  std::vector<const MethodFigures*> methods;
  for (const MethodFigures& method : analysis.methods) {
    if (method.budget != budget || !method.gap) continue;
    methods.push_back(&method);
    most = std::max(most, method.gap->greatest);
  }
  if (methods.empty()) return {};
  const double height = kRow * static_cast<double>(methods.size());
  Svg svg(kWidth, height + kBottom, "Gaps of all routes as box plots, " + study.budgets[budget].text());
  const Scale x{.from = 0, .to = most > 0 ? 1.02 * most : 1, .pixel_from = kLeft, .pixel_to = kWidth - kRight};
  const std::vector<double> marks = ticks(x.from, x.to, 5);
  for (const double value : marks) {
    svg.line({x(value), 0}, {x(value), height}, "grid");
    svg.text({x(value), height + 20}, tick_label(value, marks[1] - marks[0]), "tick", Anchor::middle);
  }
  svg.text({kWidth - kRight, height + 44}, fmt::format("% above {}", words_of(analysis.yardstick)), "axis",
           Anchor::end);
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const double top = kRow * static_cast<double>(i);
    svg.text({kLeft, top + 20}, methods[i]->name, "label");
    draw_box(svg, x, top + 40, *methods[i]);
  }
  return svg.str();
}

}  // namespace alate
