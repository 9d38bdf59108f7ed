// SPDX-License-Identifier: Apache-2.0
// node man.cjs <millwright> <output folder>: one manual page for the program and one for each command, from --help.
"use strict";
const fs = require("fs");
const path = require("path");
const { execFileSync } = require("child_process");
const { help, verbs } = require("./verbs.cjs");

const [program, output] = process.argv.slice(2);
const version = execFileSync(program, ["--version"], { encoding: "utf8" }).trim();

/** Text as roff takes it: no escapes of its own, no request at the start of a line, plain hyphens. */
const plain = (text) => text.replace(/\\/g, "\\e").replace(/-/g, "\\-").replace(/^([.'])/, "\\&$1");

/** The lines of a help text, in sections: the first is what it is for. */
function sections(text) {
  const parts = [{ title: "", lines: [] }];
  for (const line of text.split("\n")) {
    const title = /^(Usage|Positionals|Options|Common options|Subcommands|Exit codes|Environment|Examples):(.*)$/.exec(line);
    if (title) parts.push({ title: title[1], lines: title[2].trim() === "" ? [] : [title[2].trim()] });
    else parts[parts.length - 1].lines.push(line);
  }
  return parts;
}

/** "  --name TYPE   text" with the lines that go on below it becomes a tagged paragraph. */
function tagged(lines) {
  const result = [];
  for (const line of lines) {
    const item = /^ {2}(\S.*?)(?: {2,}(.*))?$/.exec(line);
    if (item) {
      result.push(".TP", ".B " + plain(item[1]));
      if (item[2]) result.push(plain(item[2]));
    } else if (line.trim() !== "") result.push(plain(line.trim()));
  }
  return result;
}

function verbatim(lines) {
  const text = lines.map((line) => plain(line));
  while (text.length > 0 && text[text.length - 1] === "") text.pop();
  return text.length === 0 ? [] : [".nf", ...text, ".fi"];
}

function page(verb, others) {
  const name = ["millwright", ...verb.split(" ").filter((word) => word !== "")].join("-");
  const parts = sections(help(program, verb));
  const about = parts[0].lines.filter((line) => line !== "").join(" ");
  const lines = [`.TH ${name.toUpperCase()} 1 "" "${version}" "Millwright"`, ".SH NAME", `${plain(name)} \\- ${plain(about)}`];
  for (const { title, lines: text } of parts.slice(1)) {
    if (title === "Usage") {
      lines.push(".SH SYNOPSIS", ".B " + plain(text[0]));
    } else if (["Examples", "Exit codes", "Environment"].includes(title)) {
      lines.push(".SH " + title.toUpperCase(), ...verbatim(text));
    } else {
      // What a footer says before its examples stands behind a blank line.
      const blank = text.indexOf("");
      const head = blank < 0 ? text : text.slice(0, blank);
      const tail = blank < 0 ? [] : text.slice(blank).filter((line) => line !== "");
      lines.push(".SH " + (title === "Positionals" ? "ARGUMENTS" : title.toUpperCase()), ...tagged(head));
      if (tail.length > 0) lines.push(".SH NOTES", ...verbatim(tail));
    }
  }
  lines.push(".SH SEE ALSO", others.filter((other) => other !== name).map((other) => `.BR ${plain(other)} (1)`).join(",\n"));
  fs.writeFileSync(path.join(output, name + ".1"), lines.join("\n") + "\n");
}

const all = verbs(program);
const names = ["millwright", ...all.map((verb) => "millwright-" + verb.replace(" ", "-"))];
fs.rmSync(output, { recursive: true, force: true });
fs.mkdirSync(output, { recursive: true });
page("", names);
for (const verb of all) page(verb, ["millwright", ...names.filter((name) => name.includes(verb.split(" ")[0]))]);
