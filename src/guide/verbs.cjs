// SPDX-License-Identifier: Apache-2.0
// The commands as the program tells them: all that is said of them elsewhere is made from their --help.
"use strict";
const { execFileSync } = require("child_process");

/** What `millwright VERB --help` prints; of "" that of the program itself. */
function help(program, verb) {
  const words = verb === "" ? [] : verb.split(" ");
  return execFileSync(program, [...words, "--help"], { encoding: "utf8" });
}

/** Names in the list of subcommands that ends a help text before its examples. */
function inner(text) {
  const begin = text.indexOf("Subcommands:\n");
  if (begin < 0) return [];
  const names = [];
  for (const line of text.slice(begin).split("\n").slice(1)) {
    const name = /^ {2}(\S+)/.exec(line);
    if (name) names.push(name[1]);
    else if (!line.startsWith(" ")) break;
  }
  return names;
}

/** solve, pareto, ..., catalogue list, ... */
function verbs(program) {
  const all = [];
  for (const name of inner(help(program, ""))) {
    all.push(name);
    for (const below of inner(help(program, name))) all.push(`${name} ${below}`);
  }
  return all;
}

module.exports = { help, verbs };
