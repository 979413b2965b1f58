#pragma once

namespace pellucida {

/// The page's style sheet. Light colours by default and on paper; on a dark desktop those of the program's window.
inline constexpr const char* kPassportStyle = R"css(
:root { color-scheme: light dark; --page: #ffffff; --ink: #18222d; --dim: #56636f; --rule: #cfd7df; --raised: #f3f6f9;
  --curve: #0a62a8; --removal: #b4531a; --band: rgba(10, 98, 168, 0.16); --mark: #8a96a3; --doubt: #8a5300; --doubt-ground: #fdf4e3; }
@media screen and (prefers-color-scheme: dark) {
  :root { --page: #0f1318; --ink: #e8edf3; --dim: #9daab9; --rule: #303b48; --raised: #171c23;
    --curve: #58b7ff; --removal: #ffa94d; --band: rgba(88, 183, 255, 0.22); --mark: #6d7c8c; --doubt: #f5b950; --doubt-ground: #2a2312; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 24px 20px 40px; max-width: 900px; background: var(--page); color: var(--ink);
  font: 14px/1.4 "Liberation Sans", "Helvetica Neue", Arial, sans-serif; font-variant-numeric: tabular-nums; }
h1 { margin: 0; font-size: 24px; line-height: 1.2; overflow-wrap: anywhere; }
h2 { margin: 0; font-size: 18px; }
h3 { margin: 0 0 2px; font-size: 12px; color: var(--dim); font-weight: 600; }
.top { display: flex; justify-content: space-between; align-items: baseline; gap: 20px; }
.kind { margin: 0; white-space: nowrap; color: var(--dim); font-size: 13px; }
.facts { display: grid; grid-template-columns: repeat(3, 1fr); gap: 8px 20px; margin: 14px 0 0; padding: 10px 0;
  border-top: 2px solid var(--ink); border-bottom: 1px solid var(--rule); }
.facts .wide { grid-column: span 2; margin-top: 0; }
.facts dt { color: var(--dim); font-size: 12px; }
.facts dd { margin: 0; overflow-wrap: anywhere; }
table { border-collapse: collapse; width: 100%; }
th, td { padding: 3px 8px 3px 0; text-align: left; vertical-align: baseline; font-weight: normal; }
thead th { color: var(--dim); font-size: 12px; border-bottom: 1px solid var(--rule); }
.wide { margin-top: 14px; }
.wide tbody tr { border-bottom: 1px solid var(--rule); }
.scroll { overflow-x: auto; }
.charts.one { grid-template-columns: minmax(0, 430px); margin-top: 14px; }
a { color: inherit; }
.cell { margin-top: 22px; padding-top: 12px; border-top: 2px solid var(--ink); }
.cell header { display: flex; flex-wrap: wrap; gap: 2px 14px; align-items: baseline; }
.outcome { color: var(--dim); }
.headline { display: grid; grid-template-columns: repeat(4, 1fr); gap: 10px 16px; margin: 10px 0 6px; }
.headline div { padding: 8px 10px; background: var(--raised); border-radius: 4px; }
.headline dt { font-size: 12px; color: var(--dim); }
.headline dd { margin: 0; font-size: 20px; font-weight: 600; white-space: nowrap; }
.headline dd.interval { font-size: 12px; font-weight: normal; color: var(--dim); }
.headline .missing { font-size: 15px; font-weight: normal; line-height: 28px; }
.charts { display: grid; grid-template-columns: 1fr 1fr; gap: 6px 14px; margin: 8px 0; }
.numbers { columns: 2; column-gap: 28px; margin-top: 8px; }
.numbers section { break-inside: avoid; margin-bottom: 10px; }
.numbers table { font-size: 13px; table-layout: fixed; }
.numbers tr { border-top: 1px solid var(--rule); }
.numbers th { width: 43%; } .numbers td.value { width: 29%; }
.numbers td.value { text-align: right; white-space: nowrap; }
.numbers td.missing { padding-right: 8px; }
.numbers td.interval { color: var(--dim); white-space: nowrap; }
h3.more, .more { margin-top: 12px; }
h3.more + .scroll .wide { margin-top: 2px; }
.missing { color: var(--dim); }
.doubts { margin: 8px 0; padding: 8px 12px; border-left: 4px solid var(--doubt); background: var(--doubt-ground); }
.doubts h3, .doubts.none h3 { color: var(--doubt); }
.doubts ul, .notes ul { margin: 0; padding-left: 18px; overflow-wrap: anywhere; }
.small, footer, .glossary { font-size: 12px; color: var(--dim); }
footer { margin-top: 24px; border-top: 1px solid var(--rule); padding-top: 8px; }
footer p { margin: 0 0 6px; overflow-wrap: anywhere; }
.glossary summary { cursor: pointer; margin-top: 10px; }
.glossary td { padding-right: 14px; }
.none { margin: 4px 0; color: var(--dim); font-size: 13px; }
svg.chart { width: 100%; height: auto; display: block; }
svg text { fill: var(--ink); font-size: 12.5px; font-family: inherit; }
svg .title { font-weight: 600; font-size: 13.5px; }
svg .tick, svg .label { fill: var(--dim); }
svg .word { font-size: 12px; }
svg .grid { stroke: var(--rule); stroke-width: 0.8; }
svg .axis { stroke: var(--dim); stroke-width: 1; }
svg .mark { stroke: var(--mark); stroke-width: 1; stroke-dasharray: 4 3; }
svg .band { fill: var(--band); stroke: none; }
svg .curve, svg .removal { fill: none; stroke: var(--curve); stroke-width: 2; stroke-linejoin: round; stroke-linecap: round; }
svg .thin { stroke-width: 1.4; }
svg .removal { stroke: var(--removal); stroke-dasharray: 6 3; }
svg .dot { fill: var(--page); stroke: var(--curve); stroke-width: 2; }
@media (max-width: 640px) { .facts, .headline { grid-template-columns: 1fr 1fr; } .charts { grid-template-columns: 1fr; } .numbers { columns: 1; } }
@page { size: A4; margin: 10mm 13mm; }
@media print { body { max-width: none; padding: 0; font-size: 9.5pt; } .glossary { display: none; }
  h1 { font-size: 15pt; } .facts { margin-top: 6px; padding: 5px 0; gap: 4px 20px; } .numbers { margin-top: 2px; } .numbers table { font-size: 8pt; line-height: 1.15; }
  .numbers th, .numbers td { padding: 0.4px 6px 0.4px 0; } .numbers h3 { font-size: 8pt; break-after: avoid; } .numbers section { margin-bottom: 4px; break-inside: auto; } .charts { margin: 4px 0; gap: 0 14px; } svg.chart { width: 88%; }
  .headline { margin: 6px 0 4px; } .headline div { padding: 4px 10px; } .headline dd { font-size: 13pt; line-height: 1.25; }
  .facts dt, .headline dt, thead th, .small { font-size: 8pt; } footer { margin-top: 6px; padding-top: 5px; font-size: 7pt; line-height: 1.3; } footer p { margin-bottom: 2px; }
  .cell { break-before: page; margin-top: 0; } .cell.first { break-before: auto; margin-top: 8px; padding-top: 8px; } .cell.brief { break-before: auto; margin-top: 12px; }
  .doubts, svg.chart, .headline, tr { break-inside: avoid; }
  .headline div, .doubts { print-color-adjust: exact; -webkit-print-color-adjust: exact; } }
)css";

}  // namespace pellucida
