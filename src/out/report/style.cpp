#include "out/report/style.hpp"

namespace alate {

const std::string_view kStyle = R"css(
:root {
  color-scheme: light dark;
  --page: #fbfbf9; --ink: #1c2126; --soft: #59626b; --rule: #dcdfe2; --card: #ffffff;
  --route: #0b4f9e; --halo: #ffffff; --threat: #c2410c; --ground: #b9ab94; --ground-edge: #7d6d55;
  --band: #d9ecdf; --limit: #2f7d51; --pass: #1f6f43; --fail: #b3261e; --unknown: #8a5a00;
  --pass-tint: #e7f3ec; --fail-tint: #fbe9e7; --unknown-tint: #fdf3dc; --void: #b2b4b8;
  --vertical: #8a2d9c; --horizontal: #0c7a70; --blocked: #3e424a;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #14181c; --ink: #e8eaec; --soft: #a3adb6; --rule: #333a41; --card: #1b2026;
    --route: #6cb4ff; --halo: #0d1115; --threat: #ff8a4c; --ground: #6d6251; --ground-edge: #a6967b;
    --band: #1d3a2b; --limit: #6fc796; --pass: #7fd3a4; --fail: #ff9d94; --unknown: #f0c46a;
    --pass-tint: #182b21; --fail-tint: #361c1a; --unknown-tint: #322812; --void: #5d636a;
    --vertical: #dc9bef; --horizontal: #4fcdbf; --blocked: #26292e;
  }
  .relief { filter: brightness(.62); }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink); line-height: 1.5;
  font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", "Noto Sans", sans-serif; }
main { max-width: 62rem; margin: 0 auto; padding: 2rem 1.25rem 4rem; }
header p { margin: 0; color: var(--soft); }
h1 { font-size: 1.75rem; line-height: 1.2; margin: .1rem 0 1rem; overflow-wrap: anywhere; }
h2 { font-size: 1.2rem; margin: 2.5rem 0 .6rem; }
.verdict { border-left: .4rem solid var(--c); background: var(--t); padding: .9rem 1.1rem; border-radius: .3rem;
  font-size: 1.1rem; margin: 0 0 1.2rem; overflow-wrap: anywhere; }
.verdict b { color: var(--c); margin-right: .35rem; }
.pass { --c: var(--pass); --t: var(--pass-tint); }
.fail { --c: var(--fail); --t: var(--fail-tint); }
.unknown, .skipped { --c: var(--unknown); --t: var(--unknown-tint); }
.facts { display: grid; grid-template-columns: repeat(auto-fit, minmax(8.5rem, 1fr)); gap: .75rem; margin: 0 0 1.5rem;
  padding: 0; list-style: none; }
.facts li { background: var(--card); border: 1px solid var(--rule); border-radius: .4rem; padding: .6rem .8rem; }
.facts b { display: block; font-size: 1.3rem; font-variant-numeric: tabular-nums; }
.facts span { color: var(--soft); font-size: .85rem; }
figure { margin: 0; }
svg { display: block; width: 100%; height: auto; border-radius: .4rem; }
svg svg { border-radius: 0; }
figure > svg { background: var(--card); border: 1px solid var(--rule); }
.key { list-style: none; padding: 0; margin: .6rem 0 0; display: flex; flex-wrap: wrap; gap: .3rem 1.3rem;
  font-size: .88rem; color: var(--soft); }
.key li { display: flex; align-items: center; gap: .45rem; }
.caption { margin: 0 0 .7rem; }
.swatch { display: inline-block; width: 1.5rem; height: .9rem; border-radius: .15rem; flex: none; }
.s-route { height: .3rem; background: var(--route); }
.s-direct { height: 0; border-top: 2px dashed var(--ink); border-radius: 0; }
.s-barred { height: .3rem; background: var(--fail); }
.s-threat { background: color-mix(in srgb, var(--threat) 30%, transparent); border: 1.5px solid var(--threat); }
.s-core { background: var(--threat); }
.s-broken { background: linear-gradient(45deg, transparent 43%, var(--fail) 43% 57%, transparent 57%),
  linear-gradient(-45deg, transparent 43%, var(--fail) 43% 57%, transparent 57%); width: .9rem; }
.s-ground { background: var(--ground); }
.s-best { height: 0; border-top: 2px solid var(--pass); border-radius: 0; }
.s-ants-mean { height: 0; border-top: 2px dashed var(--ink); border-radius: 0; }
.s-worst { height: 0; border-top: 2px dotted var(--threat); border-radius: 0; }
.s-band { background: var(--band); border: 1.5px dashed var(--limit); }
.s-blocked { background: var(--blocked); }
.s-unknown { background: repeating-linear-gradient(135deg, var(--void) 0 4px, #8b8f95 4px 6px); }
.tint { padding: 0 .4rem; color: #1c2126; font-size: .78rem; font-variant-numeric: tabular-nums; }
.key .tints { gap: 0; flex-wrap: wrap; }
.tints > :first-child { margin-left: .45rem; }
svg text { font-size: 15px; fill: var(--ink); }
svg .tick, svg .axis { font-size: 14px; fill: var(--soft); font-variant-numeric: tabular-nums; }
svg .label { font-weight: 600; paint-order: stroke; stroke: var(--halo); stroke-width: 4px; stroke-linejoin: round; }
svg .name { fill: var(--threat); }
svg .plain { font-weight: 600; }
svg .grid { stroke: var(--rule); stroke-width: 1; }
svg .cells { image-rendering: pixelated; }
svg .cell { stroke: var(--ink); stroke-width: .6; opacity: .25; }
svg .voxel { fill: var(--blocked); }
svg .edge { fill: none; stroke: var(--soft); stroke-width: 1.5; }
svg .blank { fill: var(--card); }
svg .route { fill: none; stroke: var(--route); stroke-width: 4; stroke-linejoin: round; stroke-linecap: round; }
svg .halo { fill: none; stroke: var(--halo); stroke-width: 8; stroke-linejoin: round; stroke-linecap: round;
  opacity: .85; }
svg .waypoint { fill: var(--halo); stroke: var(--route); stroke-width: 1.5; }
svg .direct { stroke: var(--ink); stroke-width: 1.6; stroke-dasharray: 7 6; }
svg .barred { fill: none; stroke: var(--fail); stroke-width: 4.5; opacity: .8; }
svg .threat { fill: var(--threat); fill-opacity: .18; stroke: var(--threat); stroke-width: 1.8; }
svg .core { fill: var(--threat); fill-opacity: .62; stroke: none; }
svg .broken { stroke: var(--fail); stroke-width: 3; }
svg .end { fill: var(--halo); stroke: var(--ink); stroke-width: 2.4; }
svg .dot { fill: var(--ink); }
svg .tolerance { fill: none; stroke: var(--ink); stroke-width: 1.6; stroke-dasharray: 3 4; }
svg .plate { fill: var(--card); opacity: .78; }
svg .scale { stroke: var(--ink); stroke-width: 2.4; }
svg .north { fill: var(--ink); }
svg .vertical { --k: var(--vertical); }
svg .horizontal { --k: var(--horizontal); }
svg .point { fill: var(--k); stroke: var(--k); stroke-width: 1.6; opacity: .75; transform-box: fill-box;
  transform-origin: center; }
svg .unsure { fill: var(--card); }
svg .used { opacity: 1; stroke-width: 2.6; }
svg .used:not(.unsure) { stroke: var(--halo); }
svg .error { fill: none; stroke: var(--k); stroke-width: 3; stroke-linejoin: round; }
svg .error.horizontal { stroke-dasharray: 9 5; }
svg .error-limit { stroke: var(--k); stroke-width: 5; }
svg .front { fill: var(--card); stroke: var(--route); stroke-width: 3; }
svg .front.chosen { fill: var(--route); }
.key svg.mark { width: 1.1rem; height: 1.1rem; flex: none; }
.s-vertical { height: 0; border-top: 3px solid var(--vertical); border-radius: 0; }
.s-horizontal { height: 0; border-top: 3px dashed var(--horizontal); border-radius: 0; }
.front th, .front td:not(.ids) { white-space: nowrap; }
.front .ids { overflow-wrap: anywhere; font-variant-numeric: tabular-nums; }
.front .chosen td { background: var(--pass-tint); }
svg .ants { fill: none; stroke-width: 2; stroke-linejoin: round; }
svg .ants.best { stroke: var(--pass); }
svg .ants.mean { stroke: var(--ink); stroke-dasharray: 7 5; }
svg .ants.worst { stroke: var(--threat); stroke-dasharray: 2 4; }
svg .ground { fill: var(--ground); stroke: var(--ground-edge); stroke-width: 1.5; }
svg .band { fill: var(--band); }
svg .limit { fill: none; stroke: var(--limit); stroke-width: 1.5; stroke-dasharray: 6 4; }
svg rect.unknown { fill: var(--void); opacity: .7; }
svg .threat-span { fill: var(--threat); fill-opacity: .16; }
svg .lowest { stroke: var(--ink); stroke-width: 2; }
svg .lowest-dot { fill: var(--ink); stroke: var(--halo); stroke-width: 1.5; }
table { border-collapse: collapse; width: 100%; font-size: .94rem; }
th, td { text-align: left; vertical-align: top; padding: .45rem .8rem .45rem 0; border-bottom: 1px solid var(--rule);
  font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
th { font-weight: 600; }
thead th { color: var(--soft); font-size: .82rem; }
.pairs th { width: 15rem; font-weight: 400; color: var(--soft); }
.rules code { font-size: .78rem; font-weight: 400; color: var(--soft); }
.state { color: var(--c); font-weight: 600; white-space: nowrap; }
.scroll { overflow-x: auto; }
code, pre { font-family: ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace; font-size: .86em; }
pre { background: var(--card); border: 1px solid var(--rule); border-radius: .4rem; padding: .8rem 1rem;
  overflow-x: auto; }
a { color: var(--route); }
summary { cursor: pointer; padding: .4rem 0; }
.notice { margin-top: 2.5rem; padding-top: 1rem; border-top: 1px solid var(--rule); color: var(--soft);
  font-size: .9rem; }
@media (max-width: 600px) {
  main { padding: 1.2rem .8rem 3rem; }
  h1 { font-size: 1.4rem; }
  svg text, svg .tick, svg .axis { font-size: 25px; }
  svg .route { stroke-width: 7; }
  svg .halo { stroke-width: 13; }
  svg .barred { stroke-width: 8; }
  svg .direct { stroke-width: 3; }
  svg .point { transform: scale(1.6); }
  svg.mark .point { transform: none; }
  svg .error { stroke-width: 6; }
  svg .error-limit { stroke-width: 9; }
  .rules thead { display: none; }
  .rules tr { display: block; padding: .5rem 0; border-bottom: 1px solid var(--rule); }
  .rules th, .rules td { display: block; border: 0; padding: .05rem 0; }
  .rules td:empty { display: none; }
  .rules td[title]::before { content: attr(title) ": "; color: var(--soft); }
  .pairs th { width: 45%; }
}
@media print {
  :root { --page: #fff; --card: #fff; }
  main { max-width: none; padding: 0; }
  figure, table, .verdict { break-inside: avoid; }
  svg, .verdict, .tint, .swatch { -webkit-print-color-adjust: exact; print-color-adjust: exact; }
}
)css";

}  // namespace alate
