#pragma once

#include <string_view>

namespace splitsum {

/// Colours of verdicts are blue, grey-yellow and vermilion (Okabe & Ito 2008), which no common kind
/// of colour blindness confuses; a sign says the same.
inline constexpr std::string_view page_style = R"(
:root { color-scheme: light dark; --line: #8885; --meets: #0072b2; --near: #8a6d00;
  --fails: #c44500; --refuses: #767676; --failed: #d55e0022; }
@media (prefers-color-scheme: dark) { :root { --meets: #56b4e9; --near: #f0e442;
  --fails: #ff8a3d; --refuses: #a0a0a0; --failed: #d55e0033; } }
body { font: 16px/1.45 system-ui, sans-serif; margin: 0 auto; max-width: 76rem; padding: 0 1rem 4rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; margin: 2.5rem 0 .3rem; }
p { margin: .4rem 0; max-width: 46rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; margin: .6rem 0; }
th, td { border: 1px solid var(--line); padding: .3rem .5rem; text-align: left; vertical-align: top; }
th { font-weight: 600; white-space: nowrap; }
tbody th { position: sticky; left: 0; background: Canvas; }
.files tbody th, .table-kinds tbody th { white-space: normal; min-width: 9rem; max-width: 16rem; }
.files td { min-width: 16rem; max-width: 26rem; overflow-wrap: anywhere; }
td small { display: block; opacity: .75; min-width: 6.5rem; }
.overview td { text-align: center; white-space: nowrap; }
.overview tbody th { white-space: normal; min-width: 9rem; font-weight: 400; }
.meets { color: var(--meets); } .near { color: var(--near); } .refuses { color: var(--refuses); }
.fails { color: var(--fails); background: var(--failed); font-weight: 600; }
td small { color: CanvasText; font-weight: 400; }
img { display: block; image-rendering: pixelated; border: 1px solid var(--line); }
td img { width: 96px; height: 48px; margin-bottom: .2rem; }
.sky { width: 256px; max-width: 100%; height: auto; margin: .5rem 0; }
a { color: inherit; }
)";

}  // namespace splitsum
