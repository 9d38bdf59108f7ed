// SPDX-License-Identifier: Apache-2.0
// node check.cjs [--update | --readme] <millwright> <source folder>: does every command of the guide still print what
// the guide shows, and does every example of a help text run? Commands run in a folder of their own that holds a copy
// of problems/. With --update the guide is rewritten with what they print now: look at the difference before it is
// committed. With --readme: does every command of README.md that needs no file of the reader's print what is shown
// there?
"use strict";
const { spawnSync } = require("child_process");
const fs = require("fs");
const os = require("os");
const path = require("path");
const { chapters, read, blocks } = require("./chapters.cjs");
const { help, verbs } = require("./verbs.cjs");

const update = process.argv[2] === "--update";
const readme = process.argv[2] === "--readme";
const [program, source] = process.argv.slice(update || readme ? 3 : 2).map((each) => path.resolve(each));
let failures = 0;
let commands = 0;

function fail(where, what) {
  failures += 1;
  console.error(`FAILED: ${where}: ${what}`);
}

function run(command, folder) {
  commands += 1;
  const result = spawnSync("bash", ["-c", command], {
    cwd: folder,
    encoding: "utf8",
    env: {
      PATH: path.dirname(program) + ":" + process.env.PATH,
      MILLWRIGHT_CATALOGUES: path.join(source, "catalogues"),
      HOME: folder,
      LANG: "C.UTF-8",
      TERM: "dumb",
    },
  });
  // What it took differs from run to run.
  const output = (result.stderr + result.stdout).split(source + path.sep).join("");
  const lines = output.split("\n").filter((line) => !line.startsWith("time: "));
  while (lines.length > 0 && lines[lines.length - 1] === "") lines.pop();
  return { code: result.status, lines };
}

/** The lines that a note asks for, with "..." where some are left out. */
function shown(lines, note, where) {
  const parts = /^show: (.*)$/.exec(note);
  const ranges = parts ? parts[1].split("; ").filter((part) => !part.startsWith("exit ")) : [];
  if (ranges.length === 0) return lines;
  const wanted = new Set();
  for (const range of ranges) {
    const numbers = /^(\d+)-(\d+)$/.exec(range);
    const match = /^\/(.*)\/(?:\+(\d+))?$/.exec(range);
    let begin = 0;
    let end = 0;
    if (numbers) [begin, end] = [Number(numbers[1]) - 1, Number(numbers[2])];
    else if (match) {
      begin = lines.findIndex((line) => new RegExp(match[1]).test(line));
      end = begin + 1 + Number(match[2] ?? 0);
      if (begin < 0) fail(where, `no line matches ${range}`);
    } else fail(where, `cannot read '${range}'`);
    for (let i = begin; i < Math.min(end, lines.length); ++i) wanted.add(i);
  }
  const result = [];
  for (let i = 0; i < lines.length; ++i) {
    if (wanted.has(i)) result.push(lines[i]);
    else if (result[result.length - 1] !== "...") result.push("...");
  }
  return result;
}

function check_console(block, where, folder) {
  const asked = block.lines.filter((line) => line.startsWith("$ "));
  if (asked.length === 0) fail(where, "a console block without a command");
  const exit = /exit (\d+)/.exec(block.note);
  const lines = [];
  for (const line of asked) {
    const result = run(line.slice(2), folder);
    const code = exit ? Number(exit[1]) : 0;
    if (result.code !== code) fail(where, `'${line}' ended with ${result.code}:\n${result.lines.join("\n")}`);
    lines.push(line, ...shown(result.lines, block.note, where));
  }
  if (!update && lines.join("\n") !== block.lines.join("\n"))
    fail(where, `the program prints something else now (node src/guide/check.cjs --update):\n${lines.join("\n")}`);
  return lines;
}

function check_part(block, where) {
  const from = /^from: (\S+)$/.exec(block.note);
  if (!from) return;
  const there = new Set(
    fs.readFileSync(path.join(source, from[1]), "utf8").split("\n").map((line) => line.trim()),
  );
  for (const line of block.lines)
    if (line.trim() !== "" && line.trim() !== "..." && !there.has(line.trim())) fail(where, `${from[1]} has no line '${line}'`);
}

function workshop() {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "millwright-guide-"));
  fs.cpSync(path.join(source, "problems"), path.join(folder, "problems"), { recursive: true });
  return folder;
}

/** A folder with the files that the examples of help texts name. */
function example_workshop() {
  const folder = workshop();
  const motors = path.join(source, "catalogues", "steppers", "ldo.csv");
  fs.mkdirSync(path.join(folder, "my-parts", "steppers"), { recursive: true });
  fs.copyFileSync(motors, path.join(folder, "my-parts", "steppers", "motors.csv"));
  for (const year of ["2025", "2026"])
    fs.cpSync(path.join(folder, "my-parts"), path.join(folder, "parts-" + year), { recursive: true });
  fs.copyFileSync(motors, path.join(folder, "motors.csv"));
  fs.mkdirSync(path.join(folder, "my-shops"));
  fs.writeFileSync(path.join(folder, "my-shops", "suppliers.csv"), "supplier,shipping_fee,minimum_order,currency\n,15,,USD\n");
  for (const name of ["my-bom.csv", "mine.csv"])
    fs.copyFileSync(path.join(source, "problems", "sander-bom.csv"), path.join(folder, name));
  const prices =
    "Model;Step Angle (deg);Holding Torque (N.cm);Rated Current (A);Phase Resistance (ohm);Phase Inductance (mH);" +
    "Rotor Inertia (g.cm2);Mass;Price (USD)\n" +
    "A17-40;1,8;40;1,7;1,5;2,8;54;0,28;9,50\n" +
    "A23-56;1,8;126;2,8;0,9;2,5;300;0,70;19,90\n";
  for (const name of ["prices.csv", "prices-2027.csv"]) fs.writeFileSync(path.join(folder, name), prices);
  const recorded = { "monday.json": "solve", "tuesday.json": "lightest", "sander.json": "solve" };
  for (const [name, result] of Object.entries(recorded))
    fs.copyFileSync(path.join(source, "results", "sander", result + ".json"), path.join(folder, name));
  return folder;
}

/** Runs the examples of all help texts. Searches may stop soon: exit code 3 is as good. */
function check_examples() {
  let examples = 0;
  for (const verb of ["", ...verbs(program)]) {
    const folder = example_workshop();
    const text = help(program, verb).replace(/ \\\n +/g, " ");  // lines that go on
    const lines = text.slice(text.indexOf("Examples:\n")).split("\n").filter((line) => line.startsWith("  millwright "));
    if (lines.length === 0) fail(`millwright ${verb} --help`, "has no example");
    for (const line of lines) {
      ++examples;
      const soon = /^ {2}millwright (solve|pareto|check|explain) /.test(line) ? " --time-limit 0.3" : "";
      const result = run(line.replace("| less", "| cat") + soon, folder);
      if (![0, 1, 3].includes(result.code)) fail(`millwright ${verb} --help`, `'${line}':\n${result.lines.join("\n")}`);
    }
    fs.rmSync(folder, { recursive: true });
  }
  return examples;
}

/** Of every command, or of those that stand together, README may leave lines out ("..."). */
function check_readme() {
  const lines = fs.readFileSync(path.join(source, "README.md"), "utf8").split("\n");
  const folder = example_workshop();
  let checked = 0;
  for (let begin = 0; begin < lines.length; ++begin) {
    if (!lines[begin].startsWith("    $ ./dev run ")) continue;
    const start = begin;
    let end = begin;
    while (end < lines.length && (lines[end].startsWith("    ") || lines[end] === "")) ++end;
    const block = lines.slice(begin, end).map((line) => line.slice(4)).filter((line) => !line.startsWith("time: "));
    while (block[block.length - 1] === "") block.pop();
    const words = block.join("\n").replace(/ \\\n +/g, " ").split("\n");  // commands that go on
    const asked = words.filter((line) => line.startsWith("$ "));
    begin = end - 1;
    if (asked.some((line) => /my-parts|parts-20|prices/.test(line))) continue; // the reader's own files
    const printed = [];
    for (const line of asked) {
      const result = run(line.replace("$ ./dev run", "millwright"), folder);
      if (![0, 1].includes(result.code)) fail(`README.md:${start + 1}`, `'${line}' ended with ${result.code}`);
      printed.push(...result.lines);
    }
    let at = 0;
    let anywhere = false;
    for (const line of words.filter((each) => !each.startsWith("$ "))) {
      const found = line === "..." ? at : printed.indexOf(line, at);
      if (found < 0 || (!anywhere && found !== at)) {
        const there = printed.slice(at, at + 3).join("\n");
        fail(`README.md:${start + 1}`, `'${asked.join("; ")}' does not print here:\n${line}\nbut:\n${there}`);
        anywhere = true;
        break;
      }
      anywhere = line === "...";
      at = anywhere ? at : found + 1;
    }
    if (!anywhere && at > 0 && at < printed.length) fail(`README.md:${start + 1}`, `goes on with:\n${printed[at]}`);
    ++checked;
  }
  fs.rmSync(folder, { recursive: true });
  if (checked < 10) fail("README.md", `it has only ${checked} examples`);
  console.log(`${checked} examples of README: ${failures} failures`);
  process.exit(failures === 0 ? 0 : 1);
}

if (readme) check_readme();

for (const chapter of chapters) {
  const folder = workshop();
  const lines = read(source, chapter).split("\n");
  const fresh = [];
  let at = 0;
  for (const block of blocks(lines)) {
    const where = `${chapter}.md:${block.begin}`;
    if (block.kind === "toml") check_part(block, where);
    const file = /^file: (\S+)$/.exec(block.note);
    if (file) {
      fs.mkdirSync(path.dirname(path.join(folder, file[1])), { recursive: true });
      fs.writeFileSync(path.join(folder, file[1]), block.lines.join("\n") + "\n");
    }
    fresh.push(...lines.slice(at, block.begin));
    fresh.push(...(block.kind === "console" ? check_console(block, where, folder) : block.lines));
    at = block.end;
  }
  fresh.push(...lines.slice(at));
  if (update) fs.writeFileSync(path.join(source, "src", "guide", chapter + ".md"), fresh.join("\n"));
  fs.rmSync(folder, { recursive: true });
}
if (commands < 20) fail("the guide", `it has only ${commands} commands`);
const shownThere = commands;
const examples = update ? 0 : check_examples();
console.log(`${shownThere} commands of the guide, ${examples} examples of help texts: ${failures} failures`);
process.exit(failures === 0 ? 0 : 1);
