#include "report/report_style.h"

namespace bodkin::report {

std::string_view report_style() {
  return R"css(
:root { --ink: #16222c; --soft: #5a6873; --line: #dfe4e8; --paper: #f4f6f8; --card: #ffffff;
        --good: #1d7a4f; --good-back: #e6f4ec; --fair: #8a6100; --fair-back: #fdf3d7;
        --poor: #a3471a; --poor-back: #fbeee4; --danger: #b3121d; --danger-back: #fde3e4; color-scheme: light dark; }
@media (prefers-color-scheme: dark) { @media screen { :root { --ink: #e6ebef; --soft: #9aa8b3; --line: #2e3943;
        --paper: #12181d; --card: #1b232a; --good: #6fd3a2; --good-back: #173527; --fair: #e8c25a;
        --fair-back: #38300f; --poor: #f0a878; --poor-back: #3c2618; --danger: #ff7d85; --danger-back: #4a1418; } } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
       font: 15px/1.5 "DejaVu Sans", Verdana, "Helvetica Neue", Arial, sans-serif; }
main { max-width: 980px; margin: 0 auto; padding: 28px 20px 60px; }
h1 { font-size: 25px; line-height: 1.25; margin: 0; }
h2 { font-size: 17px; margin: 34px 0 10px; }
.under { color: var(--soft); margin: 4px 0 20px; overflow-wrap: anywhere; }
.pass { --mark: var(--good); --back: var(--good-back); } .borderline { --mark: var(--fair); --back: var(--fair-back); }
.fail { --mark: var(--poor); --back: var(--poor-back); } .dangerous { --mark: var(--danger); --back: var(--danger-back); }
.verdict { border-left: 6px solid var(--mark); background: var(--back); border-radius: 6px; padding: 14px 18px; }
.verdict.dangerous { border: 3px solid var(--mark); border-left-width: 10px; }
.verdict strong { display: block; font-size: 18px; color: var(--mark); }
.verdict.dangerous strong::before { content: "\26A0\00A0"; }
.verdict li.dangerous, .verdict li.fail { color: var(--mark); font-weight: 600; } .verdict li.borderline { color: var(--mark); }
td.borderline, td.fail, td.dangerous { color: var(--mark); font-weight: 600; }
.verdict ul { margin: 6px 0 0; padding-left: 20px; }
.tiles { display: grid; grid-template-columns: repeat(auto-fill, minmax(172px, 1fr)); gap: 10px; margin: 16px 0 0; }
.tile { background: var(--card); border: 1px solid var(--line); border-radius: 6px; padding: 10px 14px; }
.tile b { display: block; font-size: 20px; font-weight: 600; white-space: nowrap; }
.tile.pass, .tile.borderline, .tile.fail, .tile.dangerous { border-left: 4px solid var(--mark); }
.tile span { color: var(--soft); font-size: 13px; line-height: 1.3; display: block; }
figure { margin: 0; background: #fff; border: 1px solid var(--line); border-radius: 6px; padding: 8px; }
figure.dark { background: #10151a; padding: 0; overflow: hidden; }
figure img { display: block; width: 100%; height: auto; }
table { width: 100%; border-collapse: collapse; background: var(--card); border: 1px solid var(--line);
        font-size: 14px; font-variant-numeric: tabular-nums; }
th, td { padding: 5px 12px; text-align: left; border-bottom: 1px solid var(--line); vertical-align: top; }
th { color: var(--soft); font-weight: 600; font-size: 13px; }
td.n, th.n { text-align: right; white-space: nowrap; }
td.long { overflow-wrap: anywhere; }
i.swatch { display: inline-block; width: 12px; height: 12px; border-radius: 3px; margin-right: 8px; vertical-align: -1px; }
.none { color: var(--soft); }
summary { cursor: pointer; }
pre { font: 12px/1.4 "DejaVu Sans Mono", Menlo, Consolas, monospace; margin: 8px 0 0; white-space: pre-wrap; }
@media (prefers-color-scheme: dark) { @media screen { figure:not(.dark) { background: #d4d4d4; }
        figure:not(.dark) img { filter: brightness(0.83); } } }
@media print { body { background: #fff; font-size: 9.5pt; } main { max-width: none; padding: 0; }
  h1 { font-size: 17pt; } h2 { font-size: 12pt; margin: 14pt 0 5pt; break-after: avoid; }
  .tiles { grid-template-columns: repeat(5, 1fr); gap: 5pt; } .tile { padding: 5pt 7pt; }
  .tile b { font-size: 13pt; } .tile.pass, .tile.borderline, .tile.fail, .tile.dangerous { border-left: 4px solid var(--mark); }
.tile span { font-size: 8pt; }
  figure img { max-height: 118mm; width: auto; max-width: 100%; margin: 0 auto; }
  table { font-size: 8.5pt; } th { font-size: 8pt; } th, td { padding: 1.5pt 6pt; } thead { display: table-header-group; }
  figure, .tile, .verdict, tr, table.whole { break-inside: avoid; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; } @page { margin: 14mm; } }
)css";
}

}  // namespace bodkin::report
