// SPDX-License-Identifier: Apache-2.0
//
// Tables of requirements in a problem file: every declared key in its declared unit.
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "machine/axis_file.h"
#include "machine/quantity_reader.h"
#include "machine/reported_constraints.h"
#include "text/nearest.h"
#include "text/table_reader.h"

namespace millwright::machine {

using text::Diagnostics;
using text::Node;
using text::Presence;
using text::TableReader;

namespace {

void warn_of_side(const Node& node, const RequirementDeclaration& declaration, double value, Diagnostics& diagnostics) {
  const Side side = side_of(declaration.requirement);
  if (side == Side::share && value > 1.0)
    diagnostics.warning(
        node.span(),
        fmt::format("{}: {:.6g} allows more than the part can bear", declaration.key, value),
        fmt::format("{}: usually at most 1, default {:.4g}", declaration.meaning, declaration.default_value));
  if (side == Side::safety && value < 1.0)
    diagnostics.warning(
        node.span(),
        fmt::format("{}: {:.6g} is less than no safety at all", declaration.key, value),
        fmt::format("{}: usually at least 1, default {:.4g}", declaration.meaning, declaration.default_value));
}

/// The position error may state the travel it holds over, and that the controller maps the lead error:
/// { limit = "0.05 mm", over = "300 mm", lead_error = "mapped" }.
void read_position_error(const Node& value, Requirements& require, Diagnostics& diagnostics) {
  TableReader inner(value, "position_error", diagnostics);
  QuantityReader q(inner, diagnostics);
  if (const auto limit = q.quantity({"limit", "the error, at most"}, "mm", Sign::positive, Presence::required))
    require.set(Requirement::position_error, *limit);
  if (const auto over =
          q.quantity({"over", "travel over which it is meant; the stroke without it"}, "mm", Sign::positive))
    require.set(Requirement::position_error_over, *over);
  const auto lead_error =
      inner.word({"lead_error", "whether the controller corrects the measured lead error"}, {"as made", "mapped"});
  if (lead_error == "as made") require.forget(Requirement::mapped_lead_error);
  if (lead_error == "mapped" && !require.known(Requirement::mapped_lead_error))
    require.set(Requirement::mapped_lead_error, usual_mapped_lead_error);
  inner.finish();
}

/// enforce = ["C-ST-RMS"]: makes binding what is only reported by default.
void read_enforced(TableReader& table, QuantityReader& q, Requirements& require, Diagnostics& diagnostics) {
  const std::vector<std::string_view> known = reported_constraints();
  (void)q.words({"enforce", "ids of checks that are only reported by default, and shall hold"},
                {known.begin(), known.end()});
  for (const Node* node : table.list("enforce")) {
    const std::string id = node->as_string().value_or("");
    if (id.empty()) continue;
    if (id == "C-PSU-CURRENT")
      diagnostics.error(node->span(),
                        "enforce: C-PSU-CURRENT is of all motors together, and the search follows their power only",
                        "C-PSU-POWER holds that; a larger supply_reserve asks for a larger supply");
    else if (std::find(known.begin(), known.end(), id) == known.end())
      diagnostics.error(node->span(),
                        fmt::format("enforce: {} is no constraint that is only reported", text::in_quotes(id)),
                        text::did_you_mean(id, known, "those marked * in a report; the others must hold anyway"));
    else
      require.enforce(id);
  }
}

}  // namespace

namespace {

void describe_requirement(const TableReader& table, const RequirementDeclaration& declaration) {
  text::Question question;
  question.key = declaration.key;
  question.meaning = declaration.meaning;
  question.expected = text::Expected::quantity;
  question.unit = declaration.unit;
  question.fallback = as_written(declaration.default_value, declaration.unit);
  question.example = !question.fallback.empty() ? question.fallback
                     : declaration.unit == "1"  ? "1"
                                                : fmt::format("\"{}\"", usual_values(declaration.unit).example);
  question.source = declaration.source;
  question.least = 0.0;
  question.above_least = true;
  if (declaration.requirement == Requirement::mapped_lead_error) question.most = 1.0;
  table.describe(question);
  if (declaration.requirement != Requirement::position_error) return;
  question.expected = text::Expected::table;
  table.describe(question);
}

}  // namespace

void read_requirements(const Node& node, const std::string& title, Requirements& require, Diagnostics& diagnostics) {
  TableReader table(node, title, diagnostics);
  QuantityReader q(table, diagnostics);
  read_enforced(table, q, require, diagnostics);
  for (const RequirementDeclaration& declaration : requirements()) {
    if (table.heard()) describe_requirement(table, declaration);
    const Node* value = table.find(declaration.key);
    if (value == nullptr) continue;
    if (declaration.requirement == Requirement::position_error && value->is_table()) {
      read_position_error(*value, require, diagnostics);
      if (value->find("over") != nullptr)
        q.refuse({"position_error_over"}, "is given as 'over' of position_error already", "leave one out");
      continue;
    }
    if (declaration.requirement == Requirement::position_error_over && node.find("position_error") != nullptr &&
        node.find("position_error")->find("over") != nullptr)
      continue;  // reported with position_error
    const auto number = q.of_node(*value, declaration.key, declaration.unit, Sign::positive);
    if (!number) continue;
    if (declaration.requirement == Requirement::mapped_lead_error && *number > 1.0)
      diagnostics.error(value->span(),
                        fmt::format("mapped_lead_error: {:.6g} of the lead error cannot be left of it", *number),
                        "a share of at most 1; usually 0.35 to 0.7");
    require.set(declaration.requirement, *number);
    warn_of_side(*value, declaration, *number, diagnostics);
  }
  if (require.known(Requirement::position_error_over) && !require.known(Requirement::position_error) &&
      node.find("position_error_over") != nullptr && node.find("position_error") == nullptr)
    diagnostics.error(node.key_span("position_error_over"),
                      "position_error_over: without a position_error it says nothing",
                      "write position_error = { limit = \"0.05 mm\", over = \"300 mm\" }");
  table.finish();
}

}  // namespace millwright::machine
