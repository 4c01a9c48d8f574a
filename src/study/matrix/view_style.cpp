#include <fmt/core.h>

#include "study/matrix/views.hpp"

namespace alate {

const std::string_view kViewStyle = R"css(
:root { --w3: #a35200; --w4: #b3261e; --w5: #4d5661; }
@media (prefers-color-scheme: dark) { :root { --w3: #f2b26b; --w4: #ff9d94; --w5: #b9c2cb; } }
@media print { :root { --w3: #a35200; --w4: #b3261e; --w5: #4d5661; } }
.w3 { --line: var(--w3); }
.w4 { --line: var(--w4); }
.w5 { --line: var(--w5); }
.s-way.w3, .s-way.w5 { border-top-style: dashed; }
.s-way.w4 { border-top-style: dotted; }
svg .best.w3, svg .best.w5 { stroke-dasharray: 14 4 3 4; }
svg .best.w4 { stroke-dasharray: 5 3; }
svg .box { fill: var(--line); fill-opacity: .22; stroke: var(--line); stroke-width: 1.6; }
svg .whisker { stroke: var(--line); stroke-width: 1.6; }
svg .median { stroke: var(--line); stroke-width: 4; }
svg .outlier { fill: none; stroke: var(--line); stroke-width: 1.2; }
.told th, .told td { white-space: normal; }
)css";

std::string line_class(const MethodFigures& method) { return fmt::format("w{}", method.planner % kLineStyles); }

}  // namespace alate
