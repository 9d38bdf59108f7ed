// SPDX-License-Identifier: Apache-2.0
// Report pages in a browser without a window: node page_test.cjs PROGRAM SOURCE_FOLDER CHROMIUM [SCREENSHOT_FOLDER]
// Nothing is complained of or loaded, charts are drawn and say what they are pointed at, links open what they name, and
// what is printed is complete and fits the paper.
"use strict";
const assert = require("node:assert/strict");
const { spawnSync } = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const { pathToFileURL } = require("node:url");
const { chromium } = require("playwright-core");

const [program, source, browserProgram, screenshots] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "millwright-page-"));
const patience = 120000; // ms: slow is not wrong, and on a machine that never ran a browser its first start is slow
const a4 = { width: 688, height: 990 }; // CSS pixels of A4 less the margins of the page

/// Runs the program with `--report`; the page's address.
function pageOf(name, ...words) {
  const file = path.join(folder, `${name}.html`);
  const run = spawnSync(program, [...words, "--report", file], {
    cwd: source,
    env: { ...process.env, MILLWRIGHT_CATALOGUES: path.join(source, "catalogues") },
  });
  assert.ok(run.status <= 1, `${words.join(" ")}: ${run.stderr}`);
  return pathToFileURL(file).href;
}

async function open(browser, address) {
  const page = await browser.newPage({ viewport: { width: 1100, height: 900 } });
  page.setDefaultTimeout(patience);
  const complaints = [];
  page.on("console", (message) => complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("request", (request) => {
    if (request.url().split("#")[0] !== address) complaints.push(`loads ${request.url()}`);
  });
  await page.goto(address);
  return { page, complaints };
}

const resultOf = (page) => page.evaluate(() => JSON.parse(document.getElementById("result").textContent));

/// What is wider than the paper, or closed, when the page is printed.
async function printFaults(page) {
  await page.setViewportSize(a4);
  await page.emulateMedia({ media: "print" });
  const faults = await page.evaluate(() => {
    dispatchEvent(new Event("beforeprint"));
    const found = [...document.querySelectorAll("details:not([open])")].map((each) => `closed: ${each.id}`);
    const width = document.documentElement.clientWidth;
    for (const each of document.querySelectorAll("body *")) {
      const box = each.getBoundingClientRect();
      if (box.width > 0 && box.right > width + 1.5 && !each.closest("svg"))
        found.push(`wider than the paper: ${each.tagName} ${each.className} ${each.textContent.slice(0, 60)}`);
    }
    return found;
  });
  const pdf = await page.pdf({ format: "A4", printBackground: true });
  if (pdf.length < 20000) faults.push("the PDF is empty");
  if (screenshots) fs.writeFileSync(path.join(screenshots, `${path.basename(page.url(), ".html")}.pdf`), pdf);
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  await page.emulateMedia({ media: "screen" });
  return faults;
}

/// Cells that are out of sight on a telephone, all sheets open. Leaves the window as narrow.
async function narrowFaults(page) {
  await page.setViewportSize({ width: 420, height: 900 });
  return page.evaluate(() => {
    for (const sheet of document.querySelectorAll("details")) sheet.open = true;
    const beyond = (each) => each.textContent && each.getBoundingClientRect().right > innerWidth;
    const faults = [...document.querySelectorAll("td")].filter(beyond).map((cell) => cell.textContent);
    for (const cell of document.querySelectorAll("td[data-label]"))
      if (/[<>&]/.test(cell.dataset.label)) faults.push(`markup in a label: ${cell.dataset.label}`);
    for (const section of document.querySelectorAll("section"))
      if (section.scrollWidth > section.clientWidth + 1) faults.push(`section ${section.id} scrolls sideways`);
    return faults;
  });
}

const tests = {
  async "a design with its calculation"(browser) {
    const { page, complaints } = await open(browser, pageOf("solve", "solve", "problems/lifter.toml"));
    const result = await resultOf(page);
    const charts = await page.$$eval("figure.chart", (figures) => figures.map((f) => f.querySelectorAll("svg").length));
    assert.ok(charts.length >= 2 && charts.every((count) => count >= 1), `charts: ${charts}`);
    assert.ok((await page.$$eval("svg.machine .motor", (motors) => motors.length)) >= 1);

    const dots = await page.$$('figure[data-chart="torque"] svg g[aria-label="dot"] circle');
    assert.ok(dots.length > 0);
    await dots[0].scrollIntoViewIfNeeded();
    await dots[0].hover({ force: true });
    await page.waitForFunction(() => /rpm/.test(document.querySelector('g[aria-label="tip"]')?.textContent ?? ""));
    const tip = await page.textContent('g[aria-label="tip"]');
    assert.match(tip, /N·m/);

    assert.equal(await page.$$eval("details.sheet[open]", (open) => open.length), 0);
    const check = result.checks.find((each) => each.id === "C-ST-TORQUE");
    const anchor = `calc-${check.axis}-${check.element}-${check.id}`;
    await page.click(`table.checks a[href="#${anchor}"]`);
    await page.waitForFunction((id) => document.getElementById(id).getBoundingClientRect().height > 0, anchor);
    assert.ok(await page.isVisible(`#${anchor}`));

    assert.deepEqual(await printFaults(page), []);
    assert.equal(await page.$$eval("details.sheet[open]", (open) => open.length), 1);
    assert.deepEqual(await narrowFaults(page), []);
    return complaints;
  },

  async "a machine with a belt, two screws and a failing bill"(browser) {
    const { page, complaints } = await open(
      browser,
      pageOf("check", "check", "problems/sander.toml", "problems/sander-bom.csv"),
    );
    const failing = (await resultOf(page)).checks.filter((each) => each.verdict === "violated" && each.kind !== "soft");
    assert.ok(failing.length > 0);
    const summary = await page.textContent("#summary");
    for (const check of failing) assert.ok(summary.includes(check.id), check.id);
    assert.deepEqual(await printFaults(page), []);

    // On a telephone every part keeps its price in sight.
    assert.deepEqual(await narrowFaults(page), []);
    const result = await resultOf(page);
    const shown = await page.$$eval("table.parts tbody tr", (rows) => rows.map((row) => row.innerText));
    for (const part of result.build.parts)
      assert.ok(
        shown.some((row) => row.includes(part.part_number) && row.includes(`${part.price.toFixed(2)} USD`)),
        part.part_number,
      );
    // Who makes a part is not who sells it, and no shop is stated in these catalogues.
    assert.ok(shown.filter((row) => row.includes("not stated")).length >= result.build.parts.length);
    assert.ok(shown.some((row) => row.includes("TPE17M-44A") && row.includes("known only from a paper")));
    assert.match(await page.textContent("footer"), /Millwright \d+\.\d+\.\d+.*Prices are of 2024-2026/);
    return complaints;
  },

  async "a front"(browser) {
    const { page, complaints } = await open(browser, pageOf("pareto", "pareto", "problems/lifter.toml"));
    const front = (await resultOf(page)).front;
    const dots = await page.$$('figure[data-chart="front"] svg g[aria-label="dot"] circle');
    assert.equal(dots.length, front.length);
    await dots[1].scrollIntoViewIfNeeded();
    await dots[1].hover({ force: true });
    await page.waitForFunction(() => (document.querySelector('g[aria-label="tip"]')?.textContent ?? "") !== "");
    const tip = await page.textContent('g[aria-label="tip"]');
    assert.match(tip, /Build \d+: .*USD/);
    const pointed = Number(tip.match(/Build (\d+)/)[1]);
    const box = await dots[1].boundingBox();
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    const sheet = async () => (await page.textContent("#build")).replace(/\s+/g, " ");
    assert.ok((await sheet()).startsWith(`Build ${pointed}:`));
    for (const part of front[pointed - 1].build.parts) assert.ok((await sheet()).includes(part.part_number));
    for (const each of front[pointed - 1].governing) assert.ok((await sheet()).includes(each.id));

    await page.click("#build button:last-of-type");
    assert.ok((await sheet()).startsWith(`Build ${pointed + 1}:`));
    await page.click("#build-1 a");
    assert.ok((await sheet()).startsWith("Build 1:"));
    assert.deepEqual(await printFaults(page), []);
    assert.deepEqual(await narrowFaults(page), []);
    return complaints;
  },

  async "an audit"(browser) {
    const { page, complaints } = await open(browser, pageOf("audit", "audit", "problems/papers/mini-mill.toml"));
    const rows = (await resultOf(page)).rows;
    assert.equal(await page.$$eval("#results tbody tr", (all) => all.length), rows.length);
    await page.click('a[href="#row-X07"]');
    assert.ok(await page.isVisible("#row-X07 math"));
    assert.deepEqual(await printFaults(page), []);
    assert.deepEqual(await narrowFaults(page), []);
    return complaints;
  },

  async "a range of a setting"(browser) {
    const range = "axis.z.moves[0].time=1.6:2:3 s";
    const { page, complaints } = await open(browser, pageOf("sweep", "solve", "problems/lifter.toml", "--set", range));
    assert.equal(await page.$$eval("table.sweep tbody tr", (rows) => rows.length), 3);
    assert.deepEqual(await printFaults(page), []);
    assert.deepEqual(await narrowFaults(page), []);
    return complaints;
  },
};

async function main() {
  const browser = await chromium.launch({
    executablePath: browserProgram,
    args: ["--no-sandbox", "--disable-dev-shm-usage"], // shared memory is scarce in containers
    timeout: patience,
  });
  let failed = 0;
  for (const [name, test] of Object.entries(tests)) {
    try {
      assert.deepEqual(await test(browser), []);
      console.log(`ok      ${name}`);
    } catch (error) {
      ++failed;
      console.log(`FAILED  ${name}\n${error.stack}`);
    }
  }
  await browser.close();
  fs.rmSync(folder, { recursive: true });
  process.exitCode = failed > 0 ? 1 : 0;
}

main();
