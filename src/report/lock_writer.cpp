// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "report/json_value.h"
#include "report/lock.h"
#include "report/lock_seal.h"
#include "text/sha256.h"

namespace millwright::report {

namespace {

constexpr std::string_view seal_key = "seal = \"";

/// A TOML string. What JSON escapes, TOML understands; it wants DEL escaped too.
std::string quoted_toml(std::string_view text) {
  const std::string json = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string out;
  for (const char c : json) {
    if (c == '\x7F')
      out += "\\u007f";
    else
      out += c;
  }
  return out;
}

std::string list_toml(const std::vector<std::string>& texts) {
  std::string out = "[";
  for (const std::string& text : texts) out += (out.size() > 1 ? ", " : "") + quoted_toml(text);
  return out + "]";
}

std::string line(std::string_view key, const std::string& value) { return fmt::format("{} = {}\n", key, value); }

std::string text_line(std::string_view key, std::string_view value) { return line(key, quoted_toml(value)); }

/// A key, quoted only where TOML wants it.
std::string key_toml(const std::string& key) {
  const bool plain = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
  return plain ? key : quoted_toml(key);
}

std::string part_toml(const LockedPart& part) {
  std::string out = "\n[[part]]\n" + line("slots", list_toml(part.slots)) + text_line("family", part.family) +
                    text_line("manufacturer", part.manufacturer) + text_line("part_number", part.part_number) +
                    text_line("title", part.title) + text_line("file", part.file) + "[part.figures]\n";
  for (const LockedFigure& figure : part.figures) out += text_line(key_toml(figure.name), figure.value);
  return out;
}

std::string file_toml(const LockedFile& file) {
  return fmt::format("  {{ layer = {}, family = {}, name = {}, rows = {}, sha256 = {} }},\n",
                     file.layer,
                     quoted_toml(file.family),
                     quoted_toml(file.name),
                     file.rows,
                     quoted_toml(file.sha256));
}

}  // namespace

std::string lock_text(std::string_view text) {
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

std::string seal_of(std::string_view contents) {
  std::string rest;
  while (!contents.empty()) {
    const std::size_t end = std::min(contents.find('\n'), contents.size() - 1) + 1;
    std::string_view each = contents.substr(0, end);
    contents.remove_prefix(end);
    if (each.starts_with(seal_key)) continue;
    for (const char c : each)
      if (c != '\r') rest += c;
  }
  return text::sha256(rest);
}

std::string lock_toml(const Lock& lock) {
  const LockedQuestion& question = lock.question;
  const std::string head =
      std::string(lock_heading) +
      ": what it was made from. --write-lock writes it, --locked verifies it; not to be edited.\n" + line("lock", "1") +
      text_line("millwright", lock.version);
  std::string body = "\n[question]\n" + text_line("command", question.command) +
                     line("set", list_toml(question.settings)) + line("limit", list_toml(question.limits)) +
                     line("without", list_toml(question.without)) + line("fix", list_toml(question.fixed)) +
                     line("minimise", list_toml(question.objectives));
  if (!lock.cost.empty()) body += "\n[result]\n" + text_line("cost", lock.cost) + text_line("mass", lock.mass);
  for (const LockedInput& input : lock.inputs)
    body += "\n[[input]]\n" + text_line("kind", input.kind) + text_line("file", input.file) +
            text_line("sha256", input.sha256);
  for (const LockedPart& part : lock.parts) body += part_toml(part);
  body += "\n[catalogues]\n" + line("places", list_toml(lock.places)) + "files = [\n";
  for (const LockedFile& file : lock.files) body += file_toml(file);
  body += "]\n";
  return head + text_line("seal", seal_of(head + body)) + body;
}

}  // namespace millwright::report
