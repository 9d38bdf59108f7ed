// SPDX-License-Identifier: Apache-2.0
// What the guide consists of, and the blocks in its Markdown that are not just text:
//
//   ```console             a command behind each "$ ", and what it prints. An HTML comment above the block says which
//                          lines are shown, and a code other than 0 it ends with:
//                            <!-- show: 1-3; /^Parts/+5; exit 1 -->
//                          lines 1 to 3, and the first line that matches with the 5 lines behind it; without it all lines.
//   ```csv                a file for the commands that follow, <!-- file: my-parts/steppers/drawer.csv -->
//   ```toml                a part of a file, <!-- from: problems/sander.toml -->: its lines stand there
"use strict";
const fs = require("fs");
const path = require("path");

/** File name without ending, in the order of reading. */
const chapters = ["index", "mini-mill", "sander", "torch-table", "fdm-printer"];

function read(source, chapter) {
  return fs.readFileSync(path.join(source, "src", "guide", chapter + ".md"), "utf8");
}

/** [{kind, note, lines, begin, end}]: fenced blocks; lines begin .. end - 1 of the chapter are inside the fences. */
function blocks(lines) {
  const found = [];
  for (let i = 0; i < lines.length; ++i) {
    const fence = /^```(\w+)$/.exec(lines[i]);
    if (!fence) continue;
    let above = i - 1;
    while (above >= 0 && lines[above].trim() === "") --above;
    const note = above >= 0 ? /^<!-- (.*) -->$/.exec(lines[above]) : null;
    const begin = i + 1;
    let end = begin;
    while (end < lines.length && lines[end] !== "```") ++end;
    if (end === lines.length) throw new Error("a block does not end: line " + (i + 1));
    found.push({ kind: fence[1], note: note ? note[1] : "", lines: lines.slice(begin, end), begin, end });
    i = end;
  }
  return found;
}

module.exports = { chapters, read, blocks };
