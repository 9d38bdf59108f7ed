// SPDX-License-Identifier: Apache-2.0
//
// The problem file as a whole: title, objective, supply, the axes. One axis is read by axis_file.cpp, how the axes
// carry each other is worked out in carrying.cpp, rates of exchange are read by currency_file.cpp.
#include "machine/problem_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "machine/axis_file.h"
#include "machine/carrying.h"
#include "machine/currency_file.h"
#include "machine/limits_file.h"
#include "machine/quantity_reader.h"
#include "machine/spares_file.h"
#include "text/table_reader.h"

namespace millwright::machine {

using text::Diagnostics;
using text::Node;
using text::TableReader;

namespace {

void read_supply(const Node& node, Problem& problem, Diagnostics& diagnostics) {
  TableReader table(node, "[supply]", diagnostics);
  QuantityReader q(table, diagnostics);
  if (q.required("voltage", "voltage = [\"24 V\", \"36 V\"]") != nullptr)
    problem.supply_voltages =
        q.choices({"voltage", "voltages the supply may have; the search takes one for the whole machine"}, "V");
  table.finish();
}

/// Reports lists that are longer than anything in a machine, in which each is compared with all others. True if there
/// is none.
bool lists_are_short(const Node& node, Diagnostics& diagnostics) {
  constexpr std::size_t longest = 1000;
  bool good = node.items().size() <= longest;
  if (!good)
    diagnostics.error(node.items()[longest].span(),
                      fmt::format("a list of {}: more than {} are not taken", node.items().size(), longest),
                      "a long motion is a file of its own: profile = \"motion.csv\"");
  for (const Node& each : node.items()) good = lists_are_short(each, diagnostics) && good;
  for (const text::TableEntry& each : node.entries()) good = lists_are_short(each.value, diagnostics) && good;
  return good;
}

void read_axes(const Node& axes, const AxisSurroundings& around, Problem& problem, Diagnostics& diagnostics) {
  if (axes.size() == 0) diagnostics.error(axes.span(), "axis: a machine needs at least one", "add an [[axis]]");
  std::map<std::string, SourceSpan> names;
  for (const Node& node : axes.items()) {
    Axis axis = read_axis(node, around, diagnostics);
    const Node* name = node.find("name");
    if (!axis.name.empty()) {
      const auto [first, added] = names.try_emplace(axis.name, name->span());
      if (!added) {
        text::Diagnostic twice;
        twice.where = name->span();
        twice.message = fmt::format("name: axis '{}' is there twice", axis.name);
        twice.hint = "give each axis its own name";
        twice.related = first->second;
        twice.related_message = "first here";
        diagnostics.add(std::move(twice));
      }
    }
    if (axis.name == "machine")
      diagnostics.error(name->span(),
                        "name: an axis cannot be called 'machine'",
                        "in bills of materials that name stands for what the axes share");
    problem.axes.push_back(std::move(axis));
  }
  link_axes(axes, problem, diagnostics);
}

void read_objective(const Node& node, Problem& problem, Diagnostics& diagnostics) {
  TableReader reader(node, "[objective]", diagnostics);
  QuantityReader q(reader, diagnostics);
  if (q.required("minimise", "minimise = \"cost\"") != nullptr)
    if (const auto text = reader.string({"minimise",
                                         "what is best: cost, mass, cycle_time, energy, position_error, or a weighted "
                                         "sum such as cost + 25*mass"})) {
      ObjectiveFault fault;
      if (const auto objective = parse_objective(*text, fault))
        problem.objective = objective->name();
      else
        diagnostics.error(
            node.find("minimise")->part_span(fault.offset, fault.length), "minimise: " + fault.message, fault.hint);
    }
  problem.preference = q.share_or({"preference",
                                   "how much dearer a part may be that a catalogue or stock.csv marks as preferred, "
                                   "and is chosen still; with 0 it goes first among equally dear ones"},
                                  usual_preference,
                                  true);
  reader.finish();
}

/// What the objective and the limits sum up, once the axes are known.
void count_quantities(const Node& root, Problem& problem, Diagnostics& diagnostics) {
  problem.counted = counted_quantities({problem.objective});
  for (const QuantityDeclaration& each : quantities()) {
    const auto reason = uncountable(problem, each.quantity);
    if (!reason) continue;
    if (objective_named(problem.objective).counts(each.quantity))
      diagnostics.error(root.find("objective")->find("minimise")->span(), "minimise: " + reason->message, reason->hint);
    if (problem.limits[each.quantity])
      diagnostics.error(root.find("limits")->find(each.name)->span(), "limits: " + reason->message, reason->hint);
  }
}

/// A stated price must be in a currency whose rate is known.
void check_currency(const Axis& axis, const Problem& problem, Diagnostics& diagnostics) {
  for (const Reduction& reduction : axis.mechanism.reductions) {
    const bool known = reduction.currency == problem.currency || problem.currencies.count(reduction.currency) > 0;
    if (known || reduction.price <= 0.0) continue;
    diagnostics.error(reduction.where,
                      fmt::format("price: there is no rate for {}", reduction.currency),
                      fmt::format("state it in {}, or add {} to [currency]", problem.currency, reduction.currency));
  }
}

/// Says where to begin where nothing is asked yet.
bool is_empty(const text::Document& document, Diagnostics& diagnostics) {
  if (!document.root().is_table() || !document.root().entries().empty()) return false;
  diagnostics.error(document.root().span(),
                    "the problem is empty",
                    "'millwright new --template mill FILE' writes one to begin with; 'millwright reference' has every "
                    "key");
  return true;
}

/// One or several.
std::vector<std::string> catalogues_of(TableReader& table, QuantityReader& q) {
  const text::Key key{
      "catalogues",
      "folders with parts of your own, seen from the problem file; they add to the shipped ones or replace them"};
  const Node* catalogues = table.find("catalogues");
  return catalogues != nullptr && catalogues->size() > 0 ? q.words(key) : table.strings(key);
}

/// What is bought beside the machine, and the limits of the whole.
void read_purchase(TableReader& table, Problem& problem, Diagnostics& diagnostics) {
  if (const Node* spares = table.table({"spares", "what is bought in addition, to lie in the drawer"});
      spares != nullptr)
    read_spares(*spares, problem, diagnostics);
  if (const Node* limits = table.table({"limits", "what the whole machine may take at most"}); limits != nullptr)
    read_limits(*limits, problem, diagnostics);
}

}  // namespace

std::optional<Problem> problem_of(const text::Document& document, Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  if (is_empty(document, diagnostics) || !lists_are_short(document.root(), diagnostics)) return std::nullopt;
  Problem problem;
  problem.file = document.text()->path();
  TableReader table(document.root(), "problem", diagnostics);
  (void)table.string({"$schema", "of a JSON file: the schema for editors; nothing is computed from it"});
  problem.title = table.string({"title", "stands over every report"}).value_or("");
  problem.source =
      table.string({"source", "where the figures come from; for people, nothing is computed from it"}).value_or("");
  QuantityReader q(table, diagnostics);
  problem.catalogues = catalogues_of(table, q);
  if (const Node* objective = table.table({"objective", "what is best; without this table the cheapest build"});
      objective != nullptr)
    read_objective(*objective, problem, diagnostics);
  problem.currencies_where = document.root().span();
  if (const Node* currencies = table.table(
          {"currency",
           "rates of exchange: what one unit of each currency is worth in the one of the report, whose own rate is 1"});
      currencies != nullptr) {
    problem.currencies_where = currencies->span();
    read_currencies(*currencies, problem, diagnostics);
  }
  if (q.required("supply", "a table [supply] with voltage = [\"24 V\", \"36 V\"]") != nullptr)
    if (const Node* supply = table.table({"supply", "the power supply of the machine"}); supply != nullptr)
      read_supply(*supply, problem, diagnostics);
  AxisSurroundings around;
  around.folder = std::filesystem::path(problem.file).parent_path();
  if (const Node* require =
          table.table({"require", "what every axis must keep, unless its own [axis.require] says otherwise"});
      require != nullptr)
    read_requirements(*require, "[require]", around.require, diagnostics);
  problem.require = around.require;
  const Node* together = table.array({"moves", "moves in which several axes go along a straight line together"});
  if (together != nullptr) around.together = axes_moved_together(*together);
  const std::size_t before_axes = diagnostics.error_count();
  if (q.required("axis", "an [[axis]] with its name, stroke, mechanism and moves") != nullptr)
    if (const Node* axes = table.array({"axis", "the axes of the machine"}); axes != nullptr)
      read_axes(*axes, around, problem, diagnostics);
  if (together != nullptr)
    read_coordinated_moves(*together, diagnostics.error_count() == before_axes, problem, diagnostics);
  for (const Axis& axis : problem.axes) check_currency(axis, problem, diagnostics);
  if (const Node* tool = table.table({"tool", "what presses on the tool and how far it may give way or be off"});
      tool != nullptr)
    read_tool(*tool, table.find("axis"), problem, diagnostics);
  read_purchase(table, problem, diagnostics);
  if (diagnostics.error_count() == errors) count_quantities(document.root(), problem, diagnostics);
  table.finish();
  if (diagnostics.error_count() > errors) return std::nullopt;
  return problem;
}

std::optional<Problem> read_problem(const std::filesystem::path& path,
                                    const std::vector<std::pair<std::string, std::string>>& settings,
                                    Diagnostics& diagnostics) {
  auto document = text::read_document(path.string(), diagnostics);
  if (!document) return std::nullopt;
  bool good = true;
  for (const auto& [key, value] : settings) good = document->set(key, value, diagnostics) && good;
  if (!good) return std::nullopt;
  return problem_of(*document, diagnostics);
}

}  // namespace millwright::machine
