// SPDX-License-Identifier: Apache-2.0
// node schema_test.cjs <millwright> <source folder>: the JSON Schema of problem files, judged by a validator that is not
// ours. It takes every problem file, and every template with each of its optional lines; it refuses each key misspelt,
// each value of another kind, and each missing key that the program asks for.
"use strict";
const { execFileSync } = require("child_process");
const fs = require("fs");
const path = require("path");
const Ajv = require("ajv");
const { parse, TomlDate } = require("smol-toml");

const [program, source] = process.argv.slice(2);
const schema = JSON.parse(execFileSync(program, ["schema"], { maxBuffer: 1 << 26 }));
const validate = new Ajv({ allErrors: true, strict: false }).compile(schema);

let failures = 0;
function expect(good, what) {
  if (good) return;
  failures += 1;
  console.error("FAILED: " + what);
}

/** Dates as text, as an editor hands them over. */
function plain(value) {
  if (value instanceof TomlDate) return value.toISOString();
  if (Array.isArray(value)) return value.map(plain);
  if (value === null || typeof value !== "object") return value;
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, plain(inner)]));
}

function complaints(document) {
  return validate(document) ? "" : JSON.stringify(validate.errors.slice(0, 3));
}

function accept(text, name) {
  const document = plain(parse(text));
  const wrong = complaints(document);
  expect(wrong === "", `${name} is refused: ${wrong}`);
  return document;
}

/** Every table inside, with the way to it. */
function* tables(value, way = []) {
  if (Array.isArray(value)) for (const [i, item] of value.entries()) yield* tables(item, [...way, i]);
  else if (value !== null && typeof value === "object") {
    yield [value, way];
    for (const [key, inner] of Object.entries(value)) yield* tables(inner, [...way, key]);
  }
}

function changed(document, way, change) {
  const copy = structuredClone(document);
  change(way.reduce((value, step) => value[step], copy));
  return copy;
}

const anyName = (way) => way[0] === "currency" || (way[0] === "moves" && way.length === 3);

function spoil(document, name) {
  let tried = 0;
  for (const [table, way] of tables(document)) {
    if (anyName(way) && way.length < 3 - (way[0] === "currency" ? 1 : 0)) continue;
    const where = `${name}: ${way.join(".")}`;
    if (!anyName(way)) {
      const copy = changed(document, way, (inner) => (inner["no_such_key"] = "1 mm"));
      expect(!validate(copy), `${where}: an unknown key is taken`);
    }
    for (const key of Object.keys(table)) {
      tried += 1;
      const misspelt = changed(document, way, (inner) => {
        inner[key + "x"] = inner[key];
        delete inner[key];
      });
      if (!anyName(way)) expect(!validate(misspelt), `${where}: '${key}x' is taken for '${key}'`);
      const other = changed(document, way, (inner) => (inner[key] = { no: [{ such: true }] }));
      expect(!validate(other), `${where}: '${key}' may be anything`);
    }
  }
  return tried;
}

const files = fs.readdirSync(path.join(source, "problems")).filter((name) => name.endsWith(".toml"));
expect(files.length >= 10, "problem files are missing");
let spoilt = 0;
for (const name of files) {
  const document = accept(fs.readFileSync(path.join(source, "problems", name), "utf8"), name);
  spoilt += spoil(document, name);
}
expect(spoilt > 1000, `only ${spoilt} values were spoilt`);

let offered = 0;
const templates = path.join(source, "src", "app", "templates");
for (const name of fs.readdirSync(templates).filter((each) => each.endsWith(".toml"))) {
  const lines = fs.readFileSync(path.join(templates, name), "utf8").split("\n");
  accept(lines.join("\n"), name);
  const optional = (line) => /^#[^ ]/.test(line ?? "");
  for (let begin = 0; begin < lines.length; ++begin) {
    if (!optional(lines[begin])) continue;
    let end = begin + 1;
    if (lines[begin][1] === "[") while (optional(lines[end])) ++end;
    const used = lines.map((line, i) => (i >= begin && i < end ? line.slice(1) : line));
    accept(used.join("\n"), `${name} with line ${begin + 1}`);
    offered += 1;
    begin = end - 1;
  }
}
expect(offered > 100, `only ${offered} optional lines were tried`);

// What goes with one kind only, and what is asked for.
const small = `[supply]\nvoltage = "24 V"\n[[axis]]\nname = "x"\nstroke = "1 m"\n[axis.mechanism]\nkind = "belt"\n`;
const moves = `[[axis.moves]]\ndistance = "1 m"\ntime = "2 s"\n`;
accept(small + moves, "a small belt axis");
for (const [text, what] of [
  [small + 'ends = "fixed-free"\n' + moves, "a belt with ends"],
  [small.replace('"belt"', '"blet"') + moves, "a misspelt kind"],
  [small.replace('"belt"', '"screw"') + moves, "a screw without families"],
  [small.replace('"belt"', '"rotary"') + moves, "a table without inertia"],
  [small.replace('stroke = "1 m"\n', "") + moves, "an axis without stroke"],
  [small.replace('"1 m"', "1000") + moves, "a stroke without unit"],
  [small.replace('"1 m"', '"-1 m"') + moves, "a negative stroke"],
  [small.replace('"24 V"', '["24 V", 36]') + moves, "a voltage without unit in a list"],
  [small.replace('[supply]\nvoltage = "24 V"\n', "") + moves, "no supply"],
  [small + moves + 'torque = "1 N.m"\n', "a torque against a length"],
])
  expect(!validate(plain(parse(text))), `${what} is taken`);

console.log(`${files.length} problem files, ${offered} optional lines taken, ${spoilt} values spoilt: ${failures} failures`);
process.exit(failures === 0 ? 0 : 1);
