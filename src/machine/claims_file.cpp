// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "machine/claims.h"
#include "machine/claims_check.h"
#include "machine/claims_reader.h"
#include "text/document.h"

namespace millwright::machine {

namespace {
using text::in_quotes;
using text::Node;

class ClaimsReader {
 public:
  ClaimsReader(const text::Document& document, text::Diagnostics& diagnostics)
      : root_(document.root()), diagnostics_(diagnostics), calculations_(diagnostics) {
    file_.text = document.text();
  }

  ClaimsFile read() {
    calculations_.check_keys(root_, {"title", "source", "inputs", "derived", "claim"});
    file_.title = calculations_.required_text(root_, "title");
    file_.source = calculations_.optional_text(root_, "source");
    read_inputs();
    for_each("derived", [&](const Node& block) { read_derived(block); });
    for_each("claim", [&](const Node& block) { read_claim(block); });
    if (!root_.find("claim")) diagnostics_.error(text::whole(file_.text), "there is no [[claim]] in this file");
    return std::move(file_);
  }

 private:
  void read_inputs() {
    const Node* inputs = root_.find("inputs");
    if (!inputs) return;
    if (!inputs->is_table()) return wrong(*inputs, "inputs: a table for each axis is wanted here");
    for (const text::TableEntry& axis : inputs->entries()) {
      if (!axis.value.is_table()) {
        wrong(axis.value, "inputs." + axis.key + ": a table is wanted here", "inputs are declared by axis: [inputs.x]");
        continue;
      }
      auto& values = file_.inputs[axis.key];
      for (const text::TableEntry& input : axis.value.entries()) {
        if (const auto value = calculations_.quantity(input.value)) values.emplace(input.key, *value);
      }
    }
  }

  template <class Read>
  void for_each(std::string_view key, Read read) {
    const Node* blocks = root_.find(key);
    if (!blocks) return;
    if (!blocks->is_array()) return wrong(*blocks, "blocks [[" + std::string(key) + "]] are wanted here");
    for (const Node& block : blocks->items()) {
      if (block.is_table()) {
        read(block);
      } else {
        wrong(block, "a block [[" + std::string(key) + "]] is wanted here");
      }
    }
  }

  void wrong(const Node& node, std::string message, std::string hint = {}) {
    diagnostics_.error(node.span(), std::move(message), std::move(hint));
  }

  void read_row(const Node& block, ClaimRow& row) {
    row.axis = calculations_.required_text(block, "axis");
    row.id = calculations_.required_text(block, "id");
    row.where = block.find("id") ? block.find("id")->span() : block.span();
    if (!row.id.empty()) {
      const auto [first, is_new] = ids_.emplace(row.id, row.where);
      if (!is_new) {
        diagnostics_.add({text::Severity::error,
                          row.where,
                          "row " + in_quotes(row.id) + " is there twice",
                          "a name stands for one row in the whole file",
                          first->second,
                          "first here"});
      }
    }
    row.calculation = calculations_.calculation(block, row.axis);
  }

  void read_derived(const Node& block) {
    calculations_.check_keys(block, {"axis", "id", "formula", "expression", "inputs"});
    ClaimRow row;
    read_row(block, row);
    if (!block.find("formula") && !block.find("expression")) wrong(block, "a formula or an expression is missing");
    if (row.calculation) file_.derived.push_back(std::move(row));
  }

  void read_claim(const Node& block) {
    calculations_.check_keys(
        block, {"axis", "id", "quantity", "printed", "read_as", "missing", "formula", "expression", "inputs", "line"});
    Claim claim;
    read_row(block, claim);
    claim.quantity = calculations_.required_text(block, "quantity");
    claim.missing = calculations_.optional_text(block, "missing");
    if (!block.find("formula") && !block.find("expression") && claim.missing.empty()) {
      wrong(block, "a formula or an expression is wanted here, or what is missing for one");
    }
    read_printed(block, claim);
    if (const Node* line = block.find("line")) {
      if (claim.calculation) claim.line = calculations_.line(*line, *claim.calculation, claim.axis);
      if (!block.find("formula") && !block.find("expression")) wrong(*line, "a line needs a formula or an expression");
    }
    file_.claims.push_back(std::move(claim));
  }

  void read_printed(const Node& block, Claim& claim) {
    const std::string printed = calculations_.required_text(block, "printed");
    std::string reason;
    if (!printed.empty()) {
      if (auto value = parse_printed(printed, reason)) {
        claim.printed = std::move(*value);
      } else {
        wrong(*block.find("printed"), "not a printed value: " + in_quotes(printed), reason);
        return;
      }
    }
    const Node* read_as = block.find("read_as");
    if (!read_as) return;
    claim.read_as = scalar::Unit::parse(calculations_.required_text(block, "read_as"), reason);
    if (!claim.read_as) {
      wrong(*read_as, "not a unit", reason);
    } else if (claim.read_as->dimension() == claim.printed.unit.dimension() &&
               claim.printed.unit.fits(*claim.read_as, reason)) {
      wrong(*read_as,
            "read_as is for a printed unit of another dimension",
            "the audit finds factors between " + claim.printed.unit.name() + " and other units by itself");
    }
  }

  const Node& root_;
  text::Diagnostics& diagnostics_;
  CalculationReader calculations_;
  ClaimsFile file_;
  std::map<std::string, text::SourceSpan> ids_;
};
}  // namespace

std::optional<ClaimsFile> read_claims(const text::Document& document, text::Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  ClaimsFile file = ClaimsReader(document, diagnostics).read();
  if (diagnostics.error_count() == errors_before) check_claims(file, diagnostics);
  if (diagnostics.error_count() != errors_before) return std::nullopt;
  return file;
}

std::optional<ClaimsFile> read_claims(const std::string& path, text::Diagnostics& diagnostics) {
  const auto document = text::read_document(path, diagnostics);
  if (!document) return std::nullopt;
  return read_claims(*document, diagnostics);
}

}  // namespace millwright::machine
