// SPDX-License-Identifier: Apache-2.0
// What makes the report page move: charts, and opening and closing of long parts. Everything else stands in the page
// without it. The data are in <script type="application/json" id="charts">, written by axis_sections.cpp and
// front_section.cpp.
import { drawMotion, drawTorque } from "./drive_charts.js";
import { showFront } from "./front.js";

const data = JSON.parse(document.getElementById("charts").textContent);

for (const figure of document.querySelectorAll("figure[data-chart]")) {
  const { chart, axis } = figure.dataset;
  const drive = data.axes?.drives?.find((each) => each.axis === axis);
  if (chart === "motion") drawMotion(figure, drive, data.axes.words);
  if (chart === "torque") drawTorque(figure, drive, data.axes.words);
  if (chart === "front") showFront(figure, document.getElementById("build"), data.front);
}

// Calculation sheets are long: closed on the screen until someone asks, open on paper.
const sheets = [...document.querySelectorAll("details.sheet")];
for (const sheet of sheets) sheet.open = false;

function openTarget() {
  const target = location.hash.length > 1 ? document.getElementById(decodeURIComponent(location.hash.slice(1))) : null;
  const sheet = target?.closest("details.sheet");
  if (!sheet) return;
  sheet.open = true;
  target.scrollIntoView();
}
window.addEventListener("hashchange", openTarget);
openTarget();

let closed = [];
window.addEventListener("beforeprint", () => {
  const now = sheets.filter((sheet) => !sheet.open);
  for (const sheet of now) sheet.open = true;
  closed.push(...now);
});
window.addEventListener("afterprint", () => {
  for (const sheet of closed) sheet.open = false;
  closed = [];
});
