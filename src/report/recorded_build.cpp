// SPDX-License-Identifier: Apache-2.0
#include "report/recorded_build.h"

#include <fmt/format.h>

#include <limits>
#include <set>

#include "report/json_value.h"

namespace millwright::report {

namespace {

using text::Diagnostics;
using text::SourceText;

constexpr const char* how_to_write_result = "write one with 'millwright solve PROBLEM --json FILE' (or check)";
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// The values of one object; complaints name its path in the file.
class Fields {
 public:
  /// `object` is null where its absence has been reported already: then nothing more is said.
  Fields(const Json* object, std::string path, const std::shared_ptr<const SourceText>& text, Diagnostics& diagnostics)
      : object_(object), path_(std::move(path)), text_(text), diagnostics_(diagnostics) {
    if (object_ == nullptr || object_->is_object()) return;
    complain({}, "is not an object");
    object_ = nullptr;
  }

  std::string string(const char* key, bool required = true) const {
    const Json* value = find(key, required);
    if (value == nullptr) return {};
    if (value->is_string()) return value->get<std::string>();
    complain(key, "is not text");
    return {};
  }

  /// null stands for what is undefined or infinite.
  double number(const char* key, bool required = true) const {
    const Json* value = find(key, required);
    if (value == nullptr || value->is_null()) return undefined;
    if (value->is_number()) return value->get<double>();
    complain(key, "is not a number");
    return undefined;
  }

  double finite(const char* key) const {
    const double value = number(key);
    if (std::isfinite(value)) return value;
    if (const Json* given = find(key, false); given != nullptr && given->is_null()) complain(key, "has no value");
    return 0.0;
  }

  bool flag(const char* key) const {
    const Json* value = find(key, false);
    if (value == nullptr) return false;
    if (!value->is_boolean()) complain(key, "is neither true nor false");
    return value->is_boolean() && value->get<bool>();
  }

  template <class Name>
  Name word(const char* key, std::initializer_list<std::pair<const char*, Name>> names) const {
    const std::string value = string(key);
    for (const auto& [name, meaning] : names)
      if (value == name) return meaning;
    if (!value.empty()) complain(key, "is " + text::in_quotes(value) + ", which means nothing here");
    return names.begin()->second;
  }

  Fields object(const char* key) const { return {find(key, true), inner(key), text_, diagnostics_}; }

  std::vector<std::string> strings(const char* key) const {
    std::vector<std::string> result;
    const Json* value = find(key, false);
    if (value == nullptr || !value->is_array()) return result;
    for (const Json& each : *value)
      if (each.is_string()) result.push_back(each.get<std::string>());
    return result;
  }

  std::vector<Fields> list(const char* key, bool required = true) const {
    std::vector<Fields> result;
    const Json* value = find(key, required);
    if (value == nullptr) return result;
    if (!value->is_array()) complain(key, "is not a list");
    if (value->is_array())
      for (std::size_t i = 0; i < value->size(); ++i)
        result.emplace_back(&(*value)[i], fmt::format("{}[{}]", inner(key), i), text_, diagnostics_);
    return result;
  }

  [[nodiscard]] bool has(const char* key) const { return find(key, false) != nullptr; }

 private:
  [[nodiscard]] std::string inner(const std::string& key) const {
    return path_.empty() || key.empty() ? path_ + key : path_ + "." + key;
  }
  void complain(const std::string& key, const std::string& what) const {
    diagnostics_.error(text::whole(text_), fmt::format("{} {}", inner(key), what), how_to_write_result);
  }
  const Json* find(const char* key, bool required) const {
    if (object_ == nullptr) return nullptr;
    const auto found = object_->find(key);
    if (found != object_->end()) return &*found;
    if (required) complain(key, "is missing");
    return nullptr;
  }

  const Json* object_;
  std::string path_;
  const std::shared_ptr<const SourceText>& text_;
  Diagnostics& diagnostics_;
};

evaluation::PartLine part_of(const Fields& f) {
  evaluation::PartLine part;
  part.axis = f.string("axis");
  part.slot = f.string("slot");
  part.family = f.string("family");
  part.manufacturer = f.string("manufacturer");
  part.part_number = f.string("part_number");
  part.quantity = f.finite("quantity");
  part.length = f.number("length_m", false);
  if (std::isnan(part.length)) part.length = 0.0;
  part.unit_price = f.finite("unit_price");
  part.price = f.finite("price");
  part.currency = f.string("currency");
  part.mass = f.finite("mass_kg");
  part.estimate = f.flag("estimate");
  part.where = f.string("row", false);
  part.origin = f.string("origin", false);
  return part;
}

evaluation::Check check_of(const Fields& f) {
  using evaluation::Verdict;
  using machine::ConstraintKind;
  evaluation::Check check;
  check.axis = f.string("axis");
  check.element = f.string("element");
  check.id = f.string("id");
  check.title = f.string("title");
  check.kind = f.word<ConstraintKind>("kind", {{"hard", ConstraintKind::hard}, {"soft", ConstraintKind::soft}});
  check.value = f.number("value");
  check.limit = f.number("limit");
  check.unit = f.string("unit");
  check.utilisation = f.number("utilisation");
  check.verdict = f.word<Verdict>(
      "verdict",
      {{"satisfied", Verdict::satisfied}, {"violated", Verdict::violated}, {"not evaluated", Verdict::not_evaluated}});
  if (check.verdict == Verdict::violated && std::isnan(check.utilisation))
    check.utilisation = std::numeric_limits<double>::infinity();
  check.phase = f.string("phase", false);
  check.position = f.string("position", false);
  check.requirement = f.string("requirement", false);
  return check;
}

void read_totals(const Fields& totals, evaluation::Design& design) {
  const Fields cost = totals.object("cost");
  design.cost = cost.finite("value");
  design.currency = cost.string("unit");
  design.mass = totals.object("mass").finite("value");
  for (const machine::QuantityDeclaration& each : machine::quantities()) {
    const std::string name(each.name);
    if (each.quantity == machine::Quantity::cost || each.quantity == machine::Quantity::mass ||
        !totals.has(name.c_str()))
      continue;
    design.counted.push_back({each.quantity, totals.object(name.c_str()).finite("value")});
  }
}

void read_build(const Fields& result, evaluation::Design& design) {
  const Fields build = result.object("build");
  for (const Fields& part : build.list("parts")) design.parts.push_back(part_of(part));
  for (const Fields& line : build.list("dimensions")) {
    design.dimensions.push_back({line.string("axis"), line.string("name"), line.finite("value"), line.string("unit")});
    if (design.dimensions.back().name == "supply_voltage") design.supply_voltage = design.dimensions.back().value;
  }
  for (const Fields& check : result.list("checks")) design.checks.push_back(check_of(check));
  read_totals(result.object("totals"), design);
}

/// Axes in the order in which their checks stand, which is that of the problem.
std::vector<std::string> axes_of(const evaluation::Design& design) {
  std::vector<std::string> axes;
  std::set<std::string> known{"machine"};
  const auto add = [&](const std::string& axis) {
    if (known.insert(axis).second) axes.push_back(axis);
  };
  for (const evaluation::Check& check : design.checks) add(check.axis);
  for (const evaluation::PartLine& part : design.parts) add(part.axis);
  return axes;
}

/// Where brackets are nested too deep: every level costs memory, and a result has few.
std::optional<std::size_t> find_deep_bracket(std::string_view json) {
  constexpr int deepest = 256;
  int depth = 0;
  for (std::size_t at = 0; at < json.size(); ++at) {
    if (json[at] == '"') {
      for (++at; at < json.size() && json[at] != '"'; ++at)
        if (json[at] == '\\') ++at;
    } else if (json[at] == '[' || json[at] == '{') {
      if (++depth > deepest) return at;
    } else if (json[at] == ']' || json[at] == '}') {
      --depth;
    }
  }
  return std::nullopt;
}

std::optional<Json> parse(const std::shared_ptr<const SourceText>& text, Diagnostics& diagnostics) {
  if (const auto deep = find_deep_bracket(text->contents())) {
    diagnostics.error(text::span_at(text, *deep, 1), "nested more than 256 levels deep", how_to_write_result);
    return std::nullopt;
  }
  try {
    return Json::parse(text->contents());
  } catch (const Json::exception& fault) {
    // Also numbers out of range; only the parser knows the place.
    const auto* at = dynamic_cast<const Json::parse_error*>(&fault);
    diagnostics.error(at != nullptr && at->byte > 0 ? text::span_at(text, at->byte - 1, 1) : text::whole(text),
                      "this is no JSON that could be read",
                      "the file may be cut short: write it again with --json");
    return std::nullopt;
  }
}

/// Whether it is one build that can be looked at.
bool is_one_build(const Json& json, const std::shared_ptr<const SourceText>& text, Diagnostics& diagnostics) {
  const auto word = [&](const char* key) {
    return json.is_object() && json.contains(key) && json.at(key).is_string() ? json.at(key).get<std::string>()
                                                                              : std::string();
  };
  const auto refuse = [&](const std::string& message, const std::string& hint) {
    diagnostics.error(text::whole(text), message, hint);
    return false;
  };
  if (word("schema") != "millwright.result/1") return refuse("this is no result of millwright", how_to_write_result);
  const std::string command = word("command");
  if (command == "pareto")
    return refuse("a front holds several builds, and which one is meant is not said",
                  "compare results of 'solve' (with --limit for another place on the front) or 'check'");
  if (command != "solve" && command != "check")
    return refuse(fmt::format("a result of {} holds no build", text::in_quotes(command)), how_to_write_result);
  if (json.contains("build")) return true;
  return refuse(fmt::format("this result holds no build: {}",
                            command == "check"          ? "its bill of materials could not be evaluated"
                            : word("status") == "limit" ? "none was found before the search was ended"
                                                        : "no build is compliant"),
                "'millwright explain' says why nothing is compliant");
}

/// What was asked for beside the problem, in the words of the command line.
std::vector<std::string> asked_of(const Fields& steering) {
  std::vector<std::string> asked;
  for (const std::string& setting : steering.strings("settings")) asked.push_back("--set " + setting);
  for (const Fields& limit : steering.list("limits", false))
    asked.push_back(
        fmt::format("--limit {}={:.6g} {}", limit.string("name"), limit.number("value"), limit.string("unit")));
  for (const Fields& part : steering.list("without", false)) asked.push_back("--without " + part.string("part_number"));
  for (const Fields& line : steering.list("fixed", false))
    asked.push_back(
        line.has("slot")
            ? fmt::format("--fix {}.{}={}", line.string("axis"), line.string("slot"), line.string("part_number"))
            : fmt::format("--fix {}.{}={:.6g} {}",
                          line.string("axis"),
                          line.string("name"),
                          line.number("value"),
                          line.string("unit")));
  if (asked.empty()) asked.emplace_back("more than the problem says");
  return asked;
}

}  // namespace

std::optional<RecordedBuild> read_recorded_build(const std::shared_ptr<const SourceText>& text,
                                                 Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  const auto json = parse(text, diagnostics);
  if (!json || !is_one_build(*json, text, diagnostics)) return std::nullopt;
  const Fields fields(&*json, "", text, diagnostics);
  RecordedBuild result;
  result.command = fields.string("command");
  const Fields problem = fields.object("problem");
  result.title = problem.string("title");
  result.problem_file = problem.string("file");
  result.bom_file = fields.string("bill_of_materials", false);
  const std::string completion = fields.string("completion", false);  // of check
  result.proved = fields.string("status", false) != "limit" && completion != "limit" && completion != "open";
  if (fields.has("steering")) result.asked = asked_of(fields.object("steering"));
  read_build(fields, result.design);
  result.axes = axes_of(result.design);
  if (diagnostics.error_count() > errors) return std::nullopt;
  return result;
}

}  // namespace millwright::report
