// SPDX-License-Identifier: Apache-2.0
// Motion over time and torque over speed of one drive.
import { areaY, crosshairX, dot, lineY, plot, pointer, ruleY, text, tip } from "@observablehq/plot";

const style = { fontFamily: "inherit", fontSize: "11px", background: "none", overflow: "visible" };
const blue = "var(--accent)";
const red = "var(--bad)";
const grey = "var(--faint)";

const figures = (value) => Number(value.toPrecision(4)).toString();

/// Speed and position, one above the other, on the same time.
export function drawMotion(figure, drive, words) {
  if (!drive || drive.motion.length < 2) return;
  const points = drive.motion.map(([time, speed, position]) => ({ time, speed, position }));
  const panel = (key, label, last) =>
    plot({
      width: 460,
      height: last ? 130 : 112,
      marginLeft: 52,
      marginRight: 12,
      marginTop: 20,
      marginBottom: last ? 34 : 10,
      style,
      x: { label: last ? `${words["chart.time"]} (s)` : null, ticks: last ? 6 : [], line: last, labelArrow: "none" },
      y: { label, ticks: 4, nice: true, grid: true, labelArrow: "none" },
      marks: [
        ruleY([0], { stroke: "var(--rule)" }),
        areaY(points, { x: "time", y: key, fill: blue, fillOpacity: 0.08 }),
        lineY(points, { x: "time", y: key, stroke: blue, strokeWidth: 1.6 }),
        crosshairX(points, { x: "time", y: key, color: blue, textFill: "var(--ink)" }),
      ],
    });
  const unit = drive.length_unit;
  figure.prepend(
    panel("speed", `${words["chart.speed"]} (${unit}/s)`, false),
    panel("position", `${words["chart.position"]} (${unit})`, true),
  );
}

/// The torque that is available, what of it is permitted, and where each phase works.
export function drawTorque(figure, drive, words) {
  if (!drive) return;
  const curve = drive.pull_out.map(([rpm, torque]) => ({ rpm, torque, permitted: torque * drive.margin }));
  const last = curve[curve.length - 1];
  // Those that govern on top of the others.
  const order = [...drive.phases].sort((a, b) => Number(a.governs) - Number(b.governs) || a.ratio - b.ratio);
  const phases = order.map((phase) => ({
    ...phase,
    title:
      `${phase.name}\n${figures(phase.rpm)} rpm, ${figures(phase.torque)} N·m` +
      (phase.governs ? `\n${figures(100 * phase.ratio)} % / ${figures(100 * drive.margin)} %` : ""),
  }));
  figure.prepend(
    plot({
      width: 460,
      height: 254,
      marginLeft: 52,
      marginRight: 74,
      marginTop: 20,
      marginBottom: 38,
      style,
      x: { label: `${words["chart.motor_speed"]} (rpm)`, line: true, ticks: 6, labelArrow: "none" },
      y: { label: `${words["chart.torque"]} (N·m)`, grid: true, ticks: 6, zero: true, nice: true, labelArrow: "none" },
      marks: [
        ruleY([0], { stroke: "var(--rule)" }),
        areaY(curve, { x: "rpm", y: "permitted", fill: blue, fillOpacity: 0.08 }),
        lineY(curve, { x: "rpm", y: "permitted", stroke: blue, strokeDasharray: "5 3", strokeWidth: 1.2 }),
        lineY(curve, {
          x: "rpm",
          y: "torque",
          stroke: blue,
          strokeWidth: 1.8,
          strokeDasharray: drive.estimate ? "1 3" : null,
        }),
        text([last], { x: "rpm", y: "torque", text: [words["chart.pull_out"]], textAnchor: "start", dx: 5, fill: blue }),
        text([last], {
          x: "rpm",
          y: "permitted",
          text: [words["chart.permitted"]],
          textAnchor: "start",
          dx: 5,
          dy: 2,
          fill: blue,
        }),
        dot(phases, {
          x: "rpm",
          y: "torque",
          r: 3.6,
          fill: (d) => (d.governs ? (d.ratio > drive.margin ? red : "var(--ink)") : "white"),
          stroke: (d) => (d.governs ? "white" : grey),
          strokeWidth: 1.2,
        }),
        tip([...phases].reverse(), pointer({ x: "rpm", y: "torque", title: "title", fontSize: 11 })),
      ],
    }),
  );
}
