// SPDX-License-Identifier: Apache-2.0
// node build.cjs <millwright> <source folder> <output folder>: the guide as HTML pages that need nothing else, with the
// reference of the problem file and the commands as the program itself tells them.
"use strict";
const { execFileSync } = require("child_process");
const fs = require("fs");
const path = require("path");
const { Marked } = require("marked");
const { chapters, read } = require("./chapters.cjs");
const { verbs, help } = require("./verbs.cjs");

const [program, source, output] = process.argv.slice(2);

const slug = (text) => text.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");
const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;");

function commands() {
  const parts = verbs(program).map((verb) => `## millwright ${verb}\n\n\`\`\`text\n${help(program, verb)}\`\`\`\n`);
  return `# Commands\n\n\`\`\`text\n${help(program, "")}\`\`\`\n\n${parts.join("\n")}`;
}

const marked = new Marked({
  renderer: {
    heading({ tokens, depth, text }) {
      return `<h${depth} id="${slug(text)}">${this.parser.parseInline(tokens)}</h${depth}>\n`;
    },
    code({ text, lang }) {
      const lines = escaped(text).split("\n");
      const typed = lang === "console" ? lines.map((line) => (line.startsWith("$ ") ? `<b>${line}</b>` : line)) : lines;
      return `<pre>${typed.join("\n")}</pre>\n`;
    },
    table(token) {
      const cells = (row, tag) => row.map((cell) => `<${tag}>${this.parser.parseInline(cell.tokens)}</${tag}>`).join("");
      const rows = token.rows.map((row) => `<tr>${cells(row, "td")}</tr>`).join("\n");
      return `<div class="wide"><table><tr>${cells(token.header, "th")}</tr>\n${rows}</table></div>\n`;
    },
    link({ href, tokens }) {
      return `<a href="${href.replace(/^([\w-]+)\.md/, "$1.html")}">${this.parser.parseInline(tokens)}</a>`;
    },
  },
});

const pages = [
  ...chapters.map((name) => [name, read(source, name)]),
  ["problem-file", execFileSync(program, ["reference"], { encoding: "utf8" })],
  ["commands", commands()],
];
const titled = pages.map(([name, text]) => [name, /^# (.*)$/m.exec(text)[1], text.replace(/^<!-- .* -->\n/gm, "")]);
const style = fs.readFileSync(path.join(source, "src", "guide", "style.css"), "utf8");

const written = new Map();
fs.rmSync(output, { recursive: true, force: true });
fs.mkdirSync(output, { recursive: true });
for (const [name, title, text] of titled) {
  const menu = titled
    .map(([other, words]) => `<li>${other === name ? `<b>${words}</b>` : `<a href="${other}.html">${words}</a>`}</li>`)
    .join("\n");
  const page = `<!DOCTYPE html>
<html lang="en">
<head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>${escaped(title)} - Millwright</title>
<style>
${style}</style></head>
<body>
<nav><ul>
${menu}
</ul></nav>
<main>
${marked.parse(text)}</main>
</body>
</html>
`;
  written.set(name + ".html", page);
  fs.writeFileSync(path.join(output, name + ".html"), page);
}
for (const [name, page] of written)
  for (const [, target] of page.matchAll(/href="([^"]*)"/g))
    if (!written.has(target)) throw new Error(`${name}: there is no page ${target}`);
