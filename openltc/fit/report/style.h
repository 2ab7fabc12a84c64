// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Style and script of the report's page. Private to this folder.
//
// The colours of the curves are those of Okabe and Ito 2008, "Color Universal Design", lightened
// for the dark background. The script shows the figures of the cell under the pointer; without it
// the page lacks nothing else.

#pragma once

namespace openltc::fit {

inline constexpr char k_report_style[] = R"css(
:root { color-scheme: light dark; --paper: #fcfcfa; --ink: #1b1c1e; --soft: #5c6066;
  --rule: #dcdcd6; --panel: #f3f3ee; --good: #00714f; --bad: #b1420a;
  --series0: #0068a8; --series1: #cf5200; --series2: #008a63; --series3: #a8558a; }
@media (prefers-color-scheme: dark) { :root { --paper: #15171a; --ink: #e6e6e2; --soft: #9ba1a8;
  --rule: #33373c; --panel: #1d2024; --good: #4fc79c; --bad: #f0975d;
  --series0: #5bb4ea; --series1: #f09a4f; --series2: #35c796; --series3: #d796bf; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 15px/1.55 system-ui, -apple-system, "Segoe UI", "Helvetica Neue", Arial, sans-serif; }
main { max-width: 1260px; margin: 0 auto; padding: 48px 28px 80px; }
h1 { font-size: 30px; line-height: 1.2; font-weight: 650; letter-spacing: -.01em; margin: 0 0 6px; }
h2 { font-size: 20px; font-weight: 650; margin: 52px 0 10px; padding-top: 18px;
  border-top: 1px solid var(--rule); }
h3 { font-size: 15px; font-weight: 650; margin: 26px 0 8px; }
p { max-width: 76ch; margin: 8px 0; }
.lead { color: var(--soft); font-size: 17px; margin: 0 0 18px; }
sub { line-height: 0; }
.note { color: var(--soft); font-size: 13.5px; }
code, pre { font: 13px/1.5 ui-monospace, "SF Mono", "Cascadia Mono", Menlo, Consolas, monospace; }
pre { background: var(--panel); border: 1px solid var(--rule); border-radius: 6px;
  padding: 10px 14px; overflow-x: auto; margin: 14px 0; white-space: pre-wrap; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 13.5px;
  margin: 8px 0 14px; }
th, td { text-align: right; padding: 3px 7px; white-space: nowrap; font-weight: 400; }
thead th { color: var(--soft); font-size: 12.5px; vertical-align: bottom; }
thead tr.group th { color: var(--ink); font-weight: 650; font-size: 13.5px; text-align: left;
  padding-top: 8px; white-space: normal; min-width: 150px; }
thead tr:last-child th { border-bottom: 1px solid var(--soft); }
tbody th { text-align: left; }
tbody tr + tr > * { border-top: 1px solid var(--rule); }
td.mean { font-weight: 650; }
td.first, th.first { border-left: 14px solid transparent; background-clip: padding-box; }
.better { color: var(--good); } .worse { color: var(--bad); }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 2px 18px; margin: 8px 0;
  font-size: 13.5px; }
dt { color: var(--soft); } dd { margin: 0; overflow-wrap: anywhere; }
.columns { display: grid; grid-template-columns: repeat(auto-fit, minmax(300px, 1fr)); gap: 8px 40px; }
.bound { background: var(--panel); border-left: 3px solid var(--series0); padding: 12px 18px;
  border-radius: 0 6px 6px 0; margin: 18px 0; }
.bound p { margin: 4px 0; } .bound .formula { font-size: 18px; }
.maps { display: grid; gap: 2px 0; align-items: start; justify-content: start; }
.maps .head { font-weight: 650; font-size: 13.5px; padding-left: 46px; }
.maps .head small { color: var(--soft); font-weight: 400; display: block; }
.maps .who { align-self: center; font-size: 13.5px; font-weight: 650; padding-bottom: 34px;
  overflow-wrap: anywhere; line-height: 1.35; }
svg { display: block; } svg image { image-rendering: pixelated; }
svg.disc image { image-rendering: auto; } svg.bar image { image-rendering: auto; }
svg .label { font: 11px system-ui, sans-serif; fill: var(--soft); }
svg .middle { text-anchor: middle; } svg .end { text-anchor: end; }
svg .tick { stroke: var(--soft); stroke-width: 1; } svg .grid { stroke: var(--rule); stroke-width: 1; }
svg .frame { fill: none; stroke: var(--soft); stroke-width: .75; }
svg .cursor { fill: none; stroke: #fff; stroke-width: 1.5; pointer-events: none; }
svg .horizon { fill: none; stroke: var(--soft); stroke-width: 1; }
svg .mirror { stroke: #fff; stroke-width: 1.2; opacity: .9; }
svg .curve { fill: none; stroke-width: 1.8; stroke-linejoin: round; }
svg .brdf { stroke: var(--ink); stroke-width: 4.5; opacity: .28; }
svg .series0 { stroke: var(--series0); } svg .series1 { stroke: var(--series1); }
svg .series2 { stroke: var(--series2); stroke-dasharray: 5 3; }
svg .series3 { stroke: var(--series3); stroke-dasharray: 2 3; }
.cell { border: 1px solid var(--rule); border-radius: 8px; padding: 12px 16px 14px; margin: 16px 0; }
.cell header { display: flex; flex-wrap: wrap; gap: 2px 22px; align-items: baseline;
  margin-bottom: 8px; }
.cell header strong { font-size: 15px; } .cell header span { color: var(--soft); font-size: 13px; }
.lobes { display: flex; flex-wrap: wrap; gap: 10px 8px; align-items: flex-end; }
figure { margin: 0; } figcaption { font-size: 12.5px; max-width: 176px; line-height: 1.35;
  margin-bottom: 4px; }
figcaption small { color: var(--soft); display: block; }
.key { display: inline-block; width: 18px; height: 0; border-top: 3px solid; vertical-align: 4px;
  margin-right: 6px; }
.key.brdf { border-color: var(--ink); opacity: .4; border-top-width: 5px; vertical-align: 3px; }
.key.series0 { border-color: var(--series0); } .key.series1 { border-color: var(--series1); }
.key.series2 { border-color: var(--series2); border-top-style: dashed; }
.key.series3 { border-color: var(--series3); border-top-style: dotted; }
#tip { position: fixed; display: none; background: var(--paper); color: var(--ink);
  border: 1px solid var(--soft); border-radius: 6px; padding: 8px 12px; font-size: 12.5px;
  pointer-events: none; box-shadow: 0 4px 18px #0004; z-index: 1; }
#tip table { margin: 4px 0 0; font-size: 12.5px; } #tip td, #tip th { padding: 0 6px; border: 0; }
#tip td:first-child { text-align: left; padding-left: 0; }
details summary { cursor: pointer; color: var(--soft); }
footer { margin-top: 56px; color: var(--soft); font-size: 13px; }
@media print { main { padding: 0; max-width: none; } .cell { break-inside: avoid; } }
)css";

inline constexpr char k_report_script[] = R"js(
(function () {
  var data = JSON.parse(document.getElementById("cells").textContent);
  var tip = document.getElementById("tip"), maps = document.querySelectorAll("svg.map");
  var names = {tv: "TV", bound: "bound", l1: "L1", l2: "L2", l3: "L3", peak: "peak", leak: "leak",
               n1: "n1", n5: "n5"};
  function show(event, map) {
    var box = map.querySelector("image").getBoundingClientRect();
    var region = data[map.dataset.region];
    var columns = region.roughness.length, rows = region.theta.length;
    var i = Math.floor((event.clientX - box.left) / box.width * columns);
    var j = rows - 1 - Math.floor((event.clientY - box.top) / box.height * rows);
    if (i < 0 || j < 0 || i >= columns || j >= rows) return hide();
    var at = j * columns + i, own = region.candidates[map.dataset.candidate];
    var text = "<strong>roughness " + region.roughness[i] + ", θ " + region.theta[j] +
               "°</strong><table>";
    for (var field in names)
      text += "<tr><td>" + names[field] + "</td><td>" +
              (own[field][at] === null ? "–" : own[field][at]) + "</td></tr>";
    text += "<tr><td>E of the BRDF</td><td>" + region.albedo[at] + "</td></tr></table>";
    tip.innerHTML = text;
    tip.style.display = "block";
    var x = event.clientX + 18, y = event.clientY + 18;
    if (x + tip.offsetWidth > innerWidth) x = event.clientX - tip.offsetWidth - 18;
    if (y + tip.offsetHeight > innerHeight) y = innerHeight - tip.offsetHeight - 6;
    tip.style.left = x + "px";
    tip.style.top = y + "px";
    maps.forEach(function (other) {
      var c = other.querySelector(".cursor"), same = other.dataset.region === map.dataset.region;
      var w = 180 / columns, h = 180 / rows;
      c.setAttribute("x", 46 + i * w - 1);
      c.setAttribute("y", 6 + (rows - 1 - j) * h - 1);
      c.setAttribute("width", same ? w + 2 : 0);
      c.setAttribute("height", same ? h + 2 : 0);
    });
  }
  function hide() {
    tip.style.display = "none";
    document.querySelectorAll("svg.map .cursor").forEach(function (c) {
      c.setAttribute("width", 0);
    });
  }
  maps.forEach(function (map) {
    map.addEventListener("mousemove", function (event) { show(event, map); });
    map.addEventListener("mouseleave", hide);
  });
})();
)js";

} // namespace openltc::fit
