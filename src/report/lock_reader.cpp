// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>

#include "catalogue/family.h"
#include "catalogue/suppliers.h"
#include "report/lock.h"
#include "report/lock_seal.h"
#include "text/document.h"
#include "text/sha256.h"
#include "text/table_reader.h"

namespace millwright::report {

namespace {

using text::Diagnostics;
using text::Node;
using text::Presence;
using text::TableReader;

constexpr const char* how_to_write_lock = "locks are not to be edited: write it again with --write-lock";
constexpr std::int64_t known_format = 1;

std::string required(TableReader& table, const char* key) { return table.string(key, Presence::required).value_or(""); }

std::string required_sha256(TableReader& table, Diagnostics& diagnostics) {
  const std::string value = required(table, "sha256");
  if (const Node* node = table.find("sha256"); node != nullptr && node->is_string() && !text::is_sha256(value))
    diagnostics.error(
        node->span(), "sha256: not 64 hexadecimal digits: " + text::in_quotes(value, 80), how_to_write_lock);
  return value;
}

/// A count that is not negative.
int required_count(TableReader& table, const char* key, Diagnostics& diagnostics) {
  constexpr std::int64_t most = 1000000000;
  const auto value = table.integer(key, Presence::required);
  if (!value) return 0;
  if (*value >= 0 && *value <= most) return static_cast<int>(*value);
  diagnostics.error(table.find(key)->span(), fmt::format("{}: {} is no count", key, *value), how_to_write_lock);
  return 0;
}

std::string required_family(TableReader& table, Diagnostics& diagnostics) {
  const std::string name = required(table, "family");
  if (const Node* node = table.find("family"); node != nullptr && node->is_string() && !catalogue::find_family(name))
    diagnostics.error(node->span(),
                      "there is no part family " + text::in_quotes(name),
                      "the lock may be of another version of millwright");
  return name;
}

LockedQuestion read_question(const Node& node, Diagnostics& diagnostics) {
  TableReader table(node, "[question]", diagnostics);
  LockedQuestion question;
  question.command = required(table, "command");
  question.settings = table.strings("set");
  question.limits = table.strings("limit");
  question.without = table.strings("without");
  question.fixed = table.strings("fix");
  question.objectives = table.strings("minimise");
  table.finish();
  return question;
}

LockedInput read_input(const Node& node, Diagnostics& diagnostics) {
  TableReader table(node, "[[input]]", diagnostics);
  LockedInput input;
  input.kind =
      table
          .word("kind", {"problem", "profile", "stock", "suppliers", "offers", "bill of materials"}, Presence::required)
          .value_or("");
  input.file = required(table, "file");
  // Locks were written that call all these files the stock.
  const std::filesystem::path file(input.file);
  if (input.kind == "stock" && catalogue::is_supplier_file(file)) input.kind = file.stem().string();
  input.sha256 = required_sha256(table, diagnostics);
  input.where = table.find("file") != nullptr ? table.find("file")->span() : node.span();
  table.finish();
  return input;
}

LockedFile read_file(const Node& node, std::size_t layers, Diagnostics& diagnostics) {
  TableReader table(node, "a file of [catalogues]", diagnostics);
  LockedFile file;
  file.layer = required_count(table, "layer", diagnostics);
  if (const Node* layer = table.find("layer"); layer != nullptr && static_cast<std::size_t>(file.layer) >= layers)
    diagnostics.error(layer->span(), fmt::format("layer: {} of {} places, counted from 0", file.layer, layers));
  file.family = required_family(table, diagnostics);
  file.name = required(table, "name");
  file.rows = required_count(table, "rows", diagnostics);
  file.sha256 = required_sha256(table, diagnostics);
  file.where = table.find("name") != nullptr ? table.find("name")->span() : node.span();
  table.finish();
  return file;
}

LockedPart read_part(const Node& node, Diagnostics& diagnostics) {
  TableReader table(node, "[[part]]", diagnostics);
  LockedPart part;
  part.slots = table.strings("slots", Presence::required);
  part.family = required_family(table, diagnostics);
  part.manufacturer = required(table, "manufacturer");
  part.part_number = required(table, "part_number");
  part.title = required(table, "title");
  part.file = required(table, "file");
  part.where = table.find("part_number") != nullptr ? table.find("part_number")->span() : node.span();
  if (const Node* figures = table.table("figures", Presence::required))
    for (const text::TableEntry& each : figures->entries()) {
      const auto value = each.value.as_string();
      if (!value) text::report_kind(each.value, each.key, text::NodeKind::string, diagnostics);
      part.figures.push_back({each.key, value.value_or(""), each.value.span()});
    }
  table.finish();
  return part;
}

void read_catalogues(const Node& node, Lock& lock, Diagnostics& diagnostics) {
  TableReader table(node, "[catalogues]", diagnostics);
  lock.places = table.strings("places", Presence::required);
  if (const Node* files = table.array("files", Presence::required))
    for (const Node& each : files->items()) lock.files.push_back(read_file(each, lock.places.size(), diagnostics));
  table.finish();
}

/// Only where nothing else is wrong: what is wrong in an edited file has been told better then.
void check_seal(const text::Document& document, const std::string& seal, Diagnostics& diagnostics) {
  if (seal == seal_of(document.text()->contents())) return;
  const Node* node = document.root().find("seal");
  diagnostics.error(node != nullptr ? node->span() : text::whole(document.text()),
                    "this lock was changed after it was written: its seal does not hold",
                    how_to_write_lock);
}

}  // namespace

std::optional<Lock> read_lock(const std::shared_ptr<const text::SourceText>& text, Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  const auto document = text::read_toml(text, diagnostics);
  if (!document) return std::nullopt;
  Lock lock;
  lock.source = text;
  TableReader table(document->root(), "the lock", diagnostics);
  const auto format = table.integer("lock", Presence::required);
  if (format && *format != known_format) {
    diagnostics.error(table.find("lock")->span(),
                      fmt::format("locks of format {} are not known, only {}", *format, known_format),
                      "use the version of millwright that wrote it");
    return std::nullopt;
  }
  lock.version = required(table, "millwright");
  const std::string seal = required(table, "seal");
  if (const Node* node = table.table("question", Presence::required)) lock.question = read_question(*node, diagnostics);
  if (const Node* node = table.table("result")) {
    TableReader result(*node, "[result]", diagnostics);
    lock.cost = required(result, "cost");
    lock.mass = required(result, "mass");
    result.finish();
  }
  if (const Node* nodes = table.array("input", Presence::required))
    for (const Node& node : nodes->items()) lock.inputs.push_back(read_input(node, diagnostics));
  if (const Node* nodes = table.array("part"))
    for (const Node& node : nodes->items()) lock.parts.push_back(read_part(node, diagnostics));
  if (const Node* node = table.table("catalogues", Presence::required)) read_catalogues(*node, lock, diagnostics);
  table.finish();
  if (diagnostics.error_count() == errors) check_seal(*document, seal, diagnostics);
  if (diagnostics.error_count() > errors) return std::nullopt;
  return lock;
}

}  // namespace millwright::report
