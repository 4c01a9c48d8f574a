#include "study/page/study_style.hpp"

namespace alate {

const std::string_view kStudyStyle = R"css(
:root { --w0: #0b4f9e; --w1: #8a1f7a; --w2: #1c7a55; --gleam: #ffffff; }
@media (prefers-color-scheme: dark) { :root { --w0: #6cb4ff; --w1: #f08fe0; --w2: #6fd6a8; --gleam: #ffd9c2; } }
@media print { :root { --w0: #0b4f9e; --w1: #8a1f7a; --w2: #1c7a55; --gleam: #ffffff; } }
.w0 { --line: var(--w0); }
.w1 { --line: var(--w1); }
.w2 { --line: var(--w2); }
h3 { font-size: 1.05rem; margin: 1.8rem 0 .5rem; }
h4 { font-size: .92rem; font-weight: 600; margin: 0 0 .3rem; }
.soft { color: var(--soft); font-weight: 400; font-size: .82rem; white-space: normal; }
.lead { margin: 0 0 .8rem; max-width: 46rem; }
.holds { --c: var(--pass); }
.does_not_hold, .impossible { --c: var(--fail); }
.cannot_be_told { --c: var(--unknown); }
.num { text-align: right; }
.study { font-size: .88rem; }
.study td, .study tbody th { white-space: nowrap; }
.study th, .study td { overflow-wrap: normal; }
.cells td, .cells th, .claims td, .claims th { padding-right: .7rem; }
.cells tbody tr:first-child th, .cells tbody tr:first-child td { border-top: 2px solid var(--soft); }
.cells .winner { font-weight: 700; }
.claims .num { white-space: nowrap; overflow-wrap: normal; }
.claims .text { min-width: 12rem; }
.claims .why { min-width: 18rem; }
.defects { padding: 0; margin: 0; list-style: none; display: grid; gap: .8rem; }
.defects li { background: var(--card); border: 1px solid var(--rule); border-radius: .4rem; padding: .7rem 1rem; }
.defects p { margin: .2rem 0 0; max-width: 52rem; }
.defects .measured { color: var(--soft); }
.notes { max-width: 52rem; margin: 0; padding-left: 1.4rem; }
.notes li { margin: .35rem 0; }
.study .interval { white-space: nowrap; }
.panels { display: grid; grid-template-columns: repeat(auto-fill, minmax(18rem, 1fr)); gap: 1.1rem 1rem; }
.panels.wide { grid-template-columns: repeat(auto-fit, minmax(min(24rem, 100%), 1fr)); }
.s-way { height: 0; border-top: 4px solid var(--line); border-radius: 0; }
.s-way.w1 { border-top-style: dashed; }
.s-way.w2 { border-top-style: dotted; }
.s-mean { height: 0; border-top: 1.5px solid var(--soft); border-radius: 0; }
.s-seeds { background: color-mix(in srgb, var(--soft) 25%, transparent); }
svg .way { stroke: var(--line); stroke-width: 4; stroke-linecap: round; }
svg .way.w1 { stroke-dasharray: 12 7; }
svg .way.w2 { stroke-dasharray: 1 8; stroke-width: 5; }
svg .node { fill: var(--line); stroke: var(--halo); stroke-width: 1.2; }
svg .drop { stroke: var(--line); stroke-width: 1; opacity: .45; }
svg .shadow { fill: none; stroke: var(--line); stroke-width: 2; opacity: .4; }
svg .sphere { fill: var(--threat); fill-opacity: .2; stroke: var(--threat); stroke-width: 1.8; }
svg .gleam { fill: var(--gleam); fill-opacity: .1; stroke: none; }
svg .ring { fill: none; stroke: var(--threat); stroke-width: 1.1; opacity: .75; }
svg .ring.far { opacity: .35; stroke-dasharray: 3 4; }
svg .best { fill: none; stroke: var(--line); stroke-width: 3; stroke-linejoin: round; }
svg .best.w1, .key .w1 { stroke-dasharray: 9 5; }
svg .best.w2 { stroke-dasharray: 2 5; stroke-linecap: round; }
svg .mean { fill: none; stroke: var(--line); stroke-width: 1.2; opacity: .8; }
svg .seeds { fill: var(--line); fill-opacity: .16; stroke: none; }
@media (max-width: 600px) {
  .panels svg text, .panels svg .tick, .panels svg .axis { font-size: 16px; }
  .claims thead { display: none; }
  .claims tr { display: block; padding: .5rem 0; border-bottom: 1px solid var(--rule); }
  .claims th, .claims td { display: block; border: 0; padding: .05rem 0; text-align: left; white-space: normal; }
  .claims td[title]::before { content: attr(title) ": "; color: var(--soft); }
}
)css";

}  // namespace alate
