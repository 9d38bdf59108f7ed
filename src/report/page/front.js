// SPDX-License-Identifier: Apache-2.0
// The front of builds: the chart, and the sheet of the build that was asked for.
import { dot, line, plot, pointer, tip } from "@observablehq/plot";

const style = { fontFamily: "inherit", fontSize: "12px", background: "none", overflow: "visible" };

function element(name, properties = {}, ...children) {
  const node = Object.assign(document.createElement(name), properties);
  node.append(...children);
  return node;
}

/// Rows of plain text; `right`: columns that are numbers.
function table(headings, rows, right, css) {
  const cells = (tag, row) =>
    row.map((cell, i) => {
      const td = element(tag, { className: right.includes(i) ? "n" : "" });
      td.append(cell);
      return td;
    });
  return element(
    "table",
    { className: css },
    element("thead", {}, element("tr", {}, ...cells("th", headings))),
    element("tbody", {}, ...rows.map((row) => element("tr", {}, ...cells("td", row)))),
  );
}

function bar(utilisation, state) {
  const inner = element("i");
  inner.style.width = `${Math.min(1, Math.max(0, (utilisation ?? 0) / 1.25)) * 100}%`;
  return element("span", { className: `bar ${state}` }, inner);
}

function changesText(build, index, words) {
  if (index === 0) return words["front.first"];
  return build.changes.length ? build.changes.join("\n") : words["front.dimensions"];
}

export function showFront(figure, place, front) {
  const { words, objectives } = front;
  const builds = front.builds.map((build, index) => ({
    ...build,
    index,
    x: build.values[0],
    y: build.values[1],
    z: build.values[2],
    title: `${words["front.build"]} ${index + 1}: ${build.shown.join(", ")}\n${changesText(build, index, words)}`,
  }));
  let chosen = null;
  let chart = null;

  const axis = ({ name, unit }) => ({ label: unit ? `${name} (${unit})` : name, grid: true, nice: true, labelArrow: "none" });
  function draw() {
    const next = plot({
      width: 940,
      height: 380,
      marginLeft: 56,
      marginBottom: 40,
      style,
      x: axis(objectives[0]),
      y: axis(objectives[1]),
      color: objectives.length > 2 ? { scheme: "blues", legend: true, label: objectives[2].name } : undefined,
      marks: [
        ...(objectives.length > 2 ? [] : [line(builds, { x: "x", y: "y", curve: "step-after", stroke: "var(--rule)" })]),
        dot(builds, {
          x: "x",
          y: "y",
          r: 3.4,
          fill: objectives.length > 2 ? "z" : "var(--accent)",
          stroke: "white",
          strokeWidth: 0.8,
        }),
        ...(chosen === null
          ? []
          : [dot([builds[chosen]], { x: "x", y: "y", r: 8, stroke: "var(--ink)", strokeWidth: 1.6 })]),
        tip(builds, pointer({ x: "x", y: "y", title: "title", fontSize: 11, maxRadius: 60, lineWidth: 34 })),
      ],
    });
    if (chart) chart.replaceWith(next);
    else figure.prepend(next);
    chart = next;
    chart.classList.add("front-chart");
    chart.addEventListener("click", () => {
      if (chart.value) choose(chart.value.index, true);
    });
  }

  function step(index, label) {
    const button = element("button", { type: "button", textContent: label, disabled: index < 0 || index >= builds.length });
    button.addEventListener("click", () => choose(index, false));
    return button;
  }

  function choose(index, scroll) {
    if (!builds[index]) return;
    chosen = index;
    draw();
    const build = builds[index];
    const parts = build.parts.map((each) => front.parts[each]);
    const checks = build.checks.map((each) => front.checks[each]);
    place.replaceChildren(
      element(
        "h3",
        {},
        `${words["front.build"]} ${index + 1}: ${build.shown.join(", ")} `,
        step(index - 1, `← ${words["front.previous"]}`),
        " ",
        step(index + 1, `${words["front.next"]} →`),
      ),
      element("p", { className: "changes" }, `${words["front.changes"]}: ${changesText(build, index, words).replaceAll("\n", "; ")}`),
      element(
        "div",
        { className: "pair" },
        table(
          [words.axis, words["parts.slot"], words["parts.part"], words["parts.quantity"], words["parts.length"], front.currency, "kg"],
          parts,
          [3, 4, 5, 6],
          "parts",
        ),
        table(
          [words.axis, words["check.id"], words.check, words["check.value"], words["check.limit"], words["check.used"]],
          checks.map(([where, id, title, value, limit, utilisation, percent, state, word]) => [
            where,
            id,
            title,
            value,
            limit,
            element("span", {}, bar(utilisation, state), element("span", { className: "pct" }, percent), state === "bad" ? ` ${word}` : ""),
          ]),
          [3, 4],
          "checks",
        ),
      ),
    );
    if (scroll) place.scrollIntoView({ block: "nearest" });
  }

  document.querySelector("table.front")?.addEventListener("click", (event) => {
    const row = event.target.closest("tr[id^=build-]");
    if (!row) return;
    event.preventDefault();
    choose(Number(row.id.slice("build-".length)) - 1, true);
  });
  draw();
}
