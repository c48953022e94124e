// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

namespace handcraft::experiments {

/// The style sheet of every report page: light, dark and print; fonts of the system alone.
inline constexpr std::string_view kHtmlStyle = R"css(
:root {
  --paper: #fbfaf8; --card: #ffffff; --ink: #23262b; --quiet: #5f6670; --line: #e3e0da;
  --first: #14766f; --second: #c25a24; --third: #5566a8;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #16181b; --card: #1e2125; --ink: #e6e4df; --quiet: #a0a6af; --line: #34383e;
    --first: #4dbdb3; --second: #e98b56; --third: #93a4e6;
  }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body {
  margin: 0; background: var(--paper); color: var(--ink);
  font: 16px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif;
}
main { max-width: 68rem; margin: 0 auto; padding: 3rem 1.5rem 4rem; }
header { margin-bottom: 2.2rem; }
.kicker { margin: 0 0 .4rem; color: var(--quiet); font-size: .82rem; letter-spacing: .04em; }
h1 { margin: 0 0 .6rem; font-size: 2.1rem; line-height: 1.2; font-weight: 650; letter-spacing: -.015em; overflow-wrap: anywhere; }
h2 { margin: 3rem 0 .3rem; font-size: 1.25rem; font-weight: 650; letter-spacing: -.005em; }
h3 { margin: 0 0 .5rem; font-size: .95rem; font-weight: 650; }
p { margin: .3rem 0 .9rem; max-width: 46rem; }
.lead { font-size: 1.1rem; color: var(--ink); }
.note { color: var(--quiet); font-size: .9rem; }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(13rem, 1fr)); gap: 1rem; margin: 1.6rem 0 0; }
.card, .tile { background: var(--card); border: 1px solid var(--line); border-radius: 10px; }
.tile { padding: 1rem 1.1rem; }
.tile .value { display: block; font-size: 1.9rem; line-height: 1.2; font-weight: 600; letter-spacing: -.02em; font-variant-numeric: tabular-nums; }
.tile .name { display: block; color: var(--quiet); font-size: .85rem; }
.tile .range { display: block; color: var(--quiet); font-size: .85rem; font-variant-numeric: tabular-nums; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: .92rem; font-variant-numeric: tabular-nums; }
th { font-weight: 600; text-align: left; color: var(--quiet); font-size: .82rem; vertical-align: bottom; }
th, td { padding: .5rem .4rem; border-bottom: 1px solid var(--line); white-space: nowrap; }
thead th { white-space: normal; }
.scroll th:first-child { position: sticky; left: 0; background: var(--paper); }
.card .scroll th:first-child { background: var(--card); }
.dense { width: auto; }
.dense th, .dense td { padding: .15rem .28rem; font-size: .75rem; }
.dense td { min-width: 1.5rem; }
.dense tbody th { white-space: nowrap; }
.upright thead th.number { text-align: center; }
.upright thead span { writing-mode: vertical-rl; transform: rotate(180deg); white-space: nowrap; }
td { vertical-align: top; }
td.number, th.number { text-align: right; }
td .range { display: block; color: var(--quiet); font-size: .75rem; }
tbody th { color: var(--ink); font-size: .92rem; vertical-align: top; overflow-wrap: break-word; white-space: normal; }
tr.total th, tr.total td { font-weight: 650; border-top: 2px solid var(--line); }
tr.total td .range { font-weight: 400; }
.plots { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 1rem; margin-top: .8rem; }
.plots .card, .wide { padding: 1rem 1.1rem; margin: 0; }
.wide { margin-top: 1rem; overflow-x: auto; }
.wide svg { min-width: 38rem; }
.card figcaption, .card .caption { color: var(--quiet); font-size: .85rem; margin: .4rem 0 0; }
svg.figure { display: block; width: 100%; height: auto; }
svg .ink { fill: var(--ink); } svg .quiet { fill: var(--quiet); }
svg .first { fill: var(--first); } svg .second { fill: var(--second); } svg .third { fill: var(--third); }
svg .line { fill: none; } svg .line.ink { stroke: var(--ink); } svg .line.quiet { stroke: var(--quiet); }
svg .line.first { stroke: var(--first); } svg .line.second { stroke: var(--second); } svg .line.third { stroke: var(--third); }
.confusion { table-layout: fixed; }
.confusion th { color: var(--quiet); font-weight: 500; border: 0; white-space: normal; text-align: center; vertical-align: middle; font-size: .85rem; }
.confusion th.side { text-align: right; }
.confusion td { border: 3px solid var(--card); border-radius: 8px; text-align: center; vertical-align: middle; padding: 2.1rem .3rem; white-space: normal; }
.confusion .count { display: block; font-size: 1.3rem; font-weight: 600; }
.confusion .share { display: block; font-size: .85rem; }
.confusion td .range { color: inherit; }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(19rem, 1fr)); gap: 1.1rem; margin-top: .8rem; }
.gallery .card { margin: 0; overflow: hidden; }
.gallery .overlay { display: block; width: 100%; height: auto; }
.gallery .pair { display: grid; grid-template-columns: 1fr 1fr; gap: 2px; margin-top: 2px; }
.gallery .pair img { display: block; width: 100%; height: auto; }
.gallery figcaption { margin: 0; padding: .65rem .8rem .75rem; font-size: .85rem; line-height: 1.45; color: var(--quiet); overflow-wrap: anywhere; }
.gallery strong { color: var(--ink); font-weight: 600; }
.good { color: var(--first); font-weight: 600; } .bad { color: var(--second); font-weight: 600; }
.key { display: inline-block; width: .75em; height: .75em; border-radius: 2px; margin-right: .35em; vertical-align: -.03em; }
.key.first { background: var(--first); } .key.second { background: var(--second); }
dl { display: grid; grid-template-columns: 10.5rem minmax(0, 1fr); gap: .35rem 1.4rem; margin: .8rem 0 0; font-size: .92rem; }
dt { color: var(--quiet); }
dd { margin: 0; overflow-wrap: anywhere; }
code { font-family: ui-monospace, "SFMono-Regular", Menlo, Consolas, "DejaVu Sans Mono", monospace; font-size: .88em; }
footer { margin-top: 3.5rem; padding-top: 1rem; border-top: 1px solid var(--line); color: var(--quiet); font-size: .85rem; }
@media (max-width: 40rem) {
  main { padding: 1.6rem 1rem 3rem; } h1 { font-size: 1.6rem; }
  .plots { grid-template-columns: minmax(0, 1fr); }
  dl { grid-template-columns: minmax(0, 1fr); gap: .1rem; } dd { margin-bottom: .5rem; }
}
@media print {
  :root { --paper: #fff; --card: #fff; --ink: #000; --quiet: #444; --line: #ccc; --first: #14766f; --second: #c25a24; --third: #5566a8; }
  body { font-size: 10.5pt; } main { max-width: none; padding: 0; }
  .card, .tile, tr { break-inside: avoid; } h2 { break-after: avoid; }
  .gallery { grid-template-columns: repeat(3, 1fr); } .plots { grid-template-columns: repeat(2, 1fr); }
  * { -webkit-print-color-adjust: exact; print-color-adjust: exact; }
}
)css";

}  // namespace handcraft::experiments
