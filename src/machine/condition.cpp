// SPDX-License-Identifier: Apache-2.0
#include "machine/condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "machine/condition_holding.h"
#include "machine/condition_loads.h"
#include "machine/condition_places.h"
#include "machine/usual_currents.h"
#include "scalar/unit.h"

namespace millwright::machine {

namespace {

using catalogue::Catalogue;
using text::Node;
using text::SourceSpan;

class Collector {
 public:
  Collector(const Asked& asked, const text::Document& document, const Catalogue& catalogue)
      : asked_(asked), problem_(asked.problem), places_(document), catalogue_(catalogue) {}

  std::vector<Condition> collect() {
    for (std::size_t i = 0; i < problem_.axes.size(); ++i) add_requirements(i, true);
    add_machine();
    add_moves();
    for (std::size_t i = 0; i < problem_.axes.size(); ++i) add_wishes(i);
    for (std::size_t i = 0; i < problem_.axes.size(); ++i)
      if (auto brake = brake_condition(problem_, i, places_)) result_.push_back(std::move(*brake));
    add_steering();
    for (std::size_t i = 0; i < problem_.axes.size(); ++i) add_requirements(i, false);
    // (What is lighter helps its drive less where it goes down, and so may not take less energy.)
    for (std::size_t i = 0; i < problem_.axes.size() && !problem_.limits[Quantity::energy]; ++i)
      for (Condition& load : load_conditions(problem_, i, places_)) result_.push_back(std::move(load));
    return std::move(result_);
  }

 private:
  Condition& add(std::string axis, std::string name, SourceSpan where) {
    Condition condition;
    condition.axis = std::move(axis);
    condition.name = std::move(name);
    condition.where = std::move(where);
    result_.push_back(std::move(condition));
    return result_.back();
  }

  /// A number with a way to set it; lifted, it is as far away as `furthest` says.
  Condition& add_number(Condition& condition,
                        double value,
                        std::string unit,
                        bool larger_is_looser,
                        std::function<void(Asked&, double)> set) {
    condition.kind = ConditionKind::number;
    condition.value = value;
    condition.unit = std::move(unit);
    condition.larger_is_looser = larger_is_looser;
    condition.set = std::move(set);
    return condition;
  }

  /// Whose reserve counts for the one supply of the machine: the largest.
  [[nodiscard]] const Axis& axis_of_reserve() const {
    return *std::ranges::max_element(
        problem_.axes, {}, [](const Axis& a) { return a.require(Requirement::supply_reserve); });
  }

  void add_requirements(std::size_t index, bool given) {
    const Axis& axis = problem_.axes[index];
    for (const RequirementDeclaration& declared : requirements()) {
      const Requirement which = declared.requirement;
      const Looser side = looser_side(which);
      if (side == Looser::neither || !axis.require.counts(which) || axis.require.given(which) != given) continue;
      const bool shared = which == Requirement::supply_reserve;
      if (shared && &axis != &axis_of_reserve()) continue;
      // A share of what a part can bear is eased to all of it, a safety to none, and no further.
      const double present = axis.require(which);
      const double furthest = side_of(which) == Side::share && side == Looser::larger     ? 1.0 / present
                              : side_of(which) == Side::safety && side == Looser::smaller ? present
                                                                                          : Condition{}.furthest;
      if (!(furthest > 1.0)) continue;
      const Node* own = Places::find(places_.axis(index), {"require", declared.key});
      const Node* found = own != nullptr ? own : Places::find(places_.root(), {"require", declared.key});
      if (const Node* limit = Places::find(found, {"limit"})) found = limit;
      Condition& condition = add(shared ? "machine" : axis.name, std::string(declared.key), places_.of(found));
      condition.meaning = declared.meaning;
      condition.given = given;
      condition.source = declared.source;
      const std::string of_axis = shared && own == nullptr ? "" : "axis." + axis.name + ".";
      condition.setting = of_axis + "require." + std::string(declared.key);
      if (Places::find(own, {"limit"}) != nullptr) condition.setting += ".limit";
      if (which == Requirement::torque_margin && !given && !axis.require.given(Requirement::torque_margin_estimate))
        condition.beside = fmt::format("axis.{}.require.torque_margin_estimate={:.12g}",
                                       axis.name,
                                       axis.require(Requirement::torque_margin_estimate));
      condition.furthest = furthest;
      add_number(condition, present, std::string(declared.unit), side == Looser::larger, [=](Asked& asked, double to) {
        for (std::size_t i = 0; i < asked.problem.axes.size(); ++i)
          if (Requirements& each = asked.problem.axes[i].require; i == index || (shared && each(which) > to))
            each.change(which, to);
      });
    }
  }

  void add_machine() {
    for (const QuantityDeclaration& each : quantities()) {
      const std::optional<double> limit = problem_.limits[each.quantity];
      if (!limit) continue;
      const Node* found = Places::find(places_.root(), {"limits", each.name});
      const bool from_option = found == nullptr || by_option(each.name, *limit);
      Condition& condition = add("machine",
                                 fmt::format("{} {}", from_option ? "--limit" : "limit of", each.name),
                                 from_option ? SourceSpan{} : found->span());
      const Quantity quantity = each.quantity;
      add_number(condition, *limit, std::string(each.unit), true, [quantity](Asked& asked, double to) {
        asked.problem.limits[quantity] = to;
      });
      condition.kind = ConditionKind::budget;
      condition.quantity = quantity;
      condition.lift = [quantity](Asked& asked) { asked.problem.limits[quantity].reset(); };
      if (!from_option) condition.setting = fmt::format("limits.{}", each.name);
    }
    const auto tool = [&](const char* name, std::optional<double> Tool::*limit, std::optional<double> Tool::*scale) {
      if (!problem_.tool || !((*problem_.tool).*limit)) return;
      Condition& condition =
          add("machine", fmt::format("{} of the tool", name), places_.of(Places::find(places_.root(), {"tool", name})));
      condition.setting = fmt::format("tool.{}", name);
      std::replace(condition.name.begin(), condition.name.end(), '_', ' ');
      add_number(condition, *((*problem_.tool).*limit), "m", true, [limit](Asked& asked, double to) {
        (*asked.problem.tool).*limit = to;
      });
      // Counted in steps of a larger limit, errors and what gives way would be more: lifted it leaves them as they are.
      condition.lift = [limit, scale, far = condition.eased(condition.furthest)](Asked& asked) {
        Tool& of = *asked.problem.tool;
        if (!(of.*scale)) of.*scale = of.*limit;
        of.*limit = far;
      };
    };
    tool("deflection", &Tool::deflection, &Tool::deflection_scale);
    tool("position_error", &Tool::position_error, &Tool::position_error_scale);
    add_voltage();
  }

  /// Whether the limit that counts is that of the command line.
  [[nodiscard]] bool by_option(std::string_view name, double value) const {
    return std::any_of(asked_.limits.begin(), asked_.limits.end(), [&](const LimitOption& limit) {
      return limit.name == name && limit.value == value;
    });
  }

  void add_voltage() {
    std::set<double> sold;
    const catalogue::Table& supplies = catalogue_.table(catalogue::Family::power_supplies);
    for (int row = 0; row < supplies.rows(); ++row) sold.insert(supplies.number("output_voltage", row));
    std::vector<double> all = problem_.supply_voltages;
    for (const double volts : sold)
      if (std::isfinite(volts) &&
          std::none_of(all.begin(), all.end(), [&](double v) { return std::abs(v - volts) < 1e-6; }))
        all.push_back(volts);
    if (all.size() == problem_.supply_voltages.size()) return;
    Condition& condition =
        add("machine", "supply voltage", places_.of(Places::find(places_.root(), {"supply", "voltage"})));
    condition.setting = "supply.voltage";
    std::vector<std::string> names;
    for (const double volts : problem_.supply_voltages) names.push_back(scalar::format(volts, scalar::Unit::of("V")));
    choice(condition, fmt::format("{}", fmt::join(names, ", ")), "supply_voltage", [all](Asked& asked) {
      asked.problem.supply_voltages = all;
    });
  }

  static void choice(Condition& condition, std::string present, std::string slot, std::function<void(Asked&)> lift) {
    condition.kind = ConditionKind::choice;
    condition.present = std::move(present);
    condition.slot = std::move(slot);
    condition.lift = std::move(lift);
  }

  /// Times, speeds and forces of the moves. A coordinated move is one of several axes, found by their common place.
  void add_moves() {
    std::vector<std::pair<std::string, SourceSpan>> seen;
    for (std::size_t i = 0; i < problem_.axes.size(); ++i) {
      const Axis& axis = problem_.axes[i];
      for (std::size_t k = 0; k < axis.moves.size(); ++k) {
        const Move& move = axis.moves[k];
        if (move.profile) continue;
        const auto same = [&](const auto& other) { return is_same(other.second, move.where); };
        const bool first = move.where.line == 0 || std::none_of(seen.begin(), seen.end(), same);
        if (first) seen.emplace_back(axis.name, move.where);
        add_move(i, k, first);
      }
      if (!axis.acceleration_time.fixed() &&
          std::any_of(axis.moves.begin(), axis.moves.end(), [](const Move& m) { return uses_chosen_ramp(m); })) {
        Condition& condition = add(
            axis.name, "longest acceleration_time", places_.of(Places::find(places_.axis(i), {"acceleration_time"})));
        add_number(condition, axis.acceleration_time.upper, "s", true, [i](Asked& asked, double to) {
          asked.problem.axes[i].acceleration_time.upper = to;
        });
        condition.furthest = 1e2;
      }
    }
  }

  void add_move(std::size_t i, std::size_t k, bool first_of_its_place) {
    const Axis& axis = problem_.axes[i];
    const Move& move = axis.moves[k];
    std::vector<std::pair<std::size_t, std::size_t>> parts;  // of the same coordinated move
    for (std::size_t a = 0; a < problem_.axes.size(); ++a)
      for (std::size_t m = 0; m < problem_.axes[a].moves.size(); ++m) {
        const bool same = move.where.line > 0 && is_same(problem_.axes[a].moves[m].where, move.where);
        if (same || (a == i && m == k)) parts.emplace_back(a, m);
      }
    const bool coordinated = parts.size() > 1;
    const std::string title = move.name.empty() ? fmt::format("move {}", k + 1) : fmt::format("move '{}'", move.name);
    std::string path = fmt::format("axis.{}.moves[{}].", axis.name, k);
    const Node* node = own_move(i, k, move);
    const bool of_machine = node == nullptr;
    if (of_machine) node = machine_move(move, path);
    const auto place = [&](const char* key) {
      const Node* found = Places::find(node, {key});
      return found != nullptr ? found->span() : move.where;
    };
    if (node == nullptr) path.clear();
    if (first_of_its_place) {
      double distance = 0.0;  // along the path, of which each axis has its share of a speed
      for (const auto& [a, m] : parts) distance = std::hypot(distance, problem_.axes[a].moves[m].distance);
      const auto scale = [&](const char* name, std::optional<double> Move::*value, const char* unit, bool larger) {
        if (!(move.*value) || (value == &Move::speed && move.time)) return;  // slower is not looser: it has its time
        if (!slower_is_looser(problem_, parts)) return;
        Condition& condition =
            add(coordinated ? "machine" : axis.name, fmt::format("{} of {}", name, title), place(name));
        if (!path.empty()) condition.setting = path + name;
        const bool shared = coordinated && value == &Move::speed && move.distance > 0.0;
        const double from =
            shared ? std::stod(fmt::format("{:.12g}", *(move.*value) * distance / move.distance)) : *(move.*value);
        add_number(condition, from, unit, larger, [=](Asked& asked, double to) {
          for (const auto& [a, m] : parts) {
            std::optional<double>& part = asked.problem.axes[a].moves[m].*value;
            if (part) *part *= to / from;
          }
        });
        condition.furthest = 1e3;
      };
      scale("time", &Move::time, "s", true);
      scale("speed", &Move::speed, is_rotary(axis) ? "rad/s" : "m/s", false);
    }
    if (move.force > 0.0 && !problem_.limits[Quantity::energy] && !softens_under_less(axis)) {
      const Node* shared = of_machine ? Places::find(node, {"forces", axis.name}) : nullptr;
      const SourceSpan where = shared != nullptr ? shared->span() : place(move.cutting ? "cutting" : "force");
      Condition& condition =
          add(axis.name, fmt::format("{} of {}", move.cutting ? "cutting force" : "force", title), where);
      if (!path.empty() && !move.cutting) condition.setting = path + (of_machine ? "forces." + axis.name : "force");
      add_number(condition, move.force, is_rotary(axis) ? "N.m" : "N", false, [i, k](Asked& asked, double to) {
        asked.problem.axes[i].moves[k].force = to;
      });
    }
  }

  static bool is_same(const SourceSpan& a, const SourceSpan& b) {
    return a.text == b.text && a.line == b.line && a.column == b.column;
  }

  /// The node of a move of several axes, and the path to it.
  [[nodiscard]] const Node* machine_move(const Move& move, std::string& path) const {
    const Node* moves = places_.root()->find("moves");
    if (moves == nullptr || !moves->is_array()) return nullptr;
    for (std::size_t i = 0; i < moves->items().size(); ++i) {
      if (!is_same(moves->items()[i].span(), move.where)) continue;
      path = fmt::format("moves[{}].", i);
      return &moves->items()[i];
    }
    return nullptr;
  }

  /// The node of a move that the axis itself states: those of the machine come after them.
  [[nodiscard]] const Node* own_move(std::size_t axis, std::size_t index, const Move& move) const {
    const Node* moves = Places::find(places_.axis(axis), {"moves"});
    if (moves == nullptr || index >= moves->items().size()) return nullptr;
    const Node& node = moves->items()[index];
    const Node* name = node.find("name");
    return name == nullptr || name->as_string() == move.name ? &node : nullptr;
  }

  /// What kinds of parts may be used. Only what narrows the choice.
  void add_wishes(std::size_t i) {
    const Axis& axis = problem_.axes[i];
    const auto list = [&](const char* what,
                          const std::vector<std::string>& words,
                          const Node* node,
                          const char* slot,
                          std::function<void(Asked&)> lift) {
      if (words.empty()) return;
      choice(add(axis.name, what, places_.of(node)), fmt::format("{}", fmt::join(words, ", ")), slot, std::move(lift));
    };
    const Node* motor = Places::find(places_.axis(i), {"motor"});
    const Node* mechanism = Places::find(places_.axis(i), {"mechanism"});
    list("motor frame", axis.motor.frames, Places::find(motor, {"frame"}), "motor", [i](Asked& asked) {
      asked.problem.axes[i].motor.frames.clear();
    });
    std::vector<std::string> amperes;
    for (const double each : axis.motor.currents) amperes.push_back(scalar::format(each, scalar::Unit::of("A")));
    const auto set_any = [i, currents = usual_currents(axis, catalogue_)](Asked& asked) {
      asked.problem.axes[i].motor.currents = currents;
    };
    list("motor current", amperes, Places::find(motor, {"current"}), "motor", set_any);
    if (axis.mechanism.kind == MechanismKind::screw && axis.mechanism.ball_screws != axis.mechanism.lead_screws)
      list("kind of screw",
           {axis.mechanism.ball_screws ? "ball_screws" : "lead_screws"},
           Places::find(mechanism, {"screw"}),
           "screw",
           [i](Asked& asked) {
             asked.problem.axes[i].mechanism.ball_screws = asked.problem.axes[i].mechanism.lead_screws = true;
           });
    list("thread form",
         axis.mechanism.thread_forms,
         Places::find(mechanism, {"thread_forms"}),
         "screw",
         [i](Asked& asked) { asked.problem.axes[i].mechanism.thread_forms.clear(); });
    list("nut material",
         axis.mechanism.nut_materials,
         Places::find(mechanism, {"nut_materials"}),
         "nut",
         [i](Asked& asked) { asked.problem.axes[i].mechanism.nut_materials.clear(); });
    list("belt profile", axis.mechanism.profiles, Places::find(mechanism, {"profiles"}), "belt", [i](Asked& asked) {
      asked.problem.axes[i].mechanism.profiles.clear();
    });
    if (axis.guide)
      list("kind of guide",
           axis.guide->kinds,
           Places::find(places_.axis(i), {"guide", "kinds"}),
           "guide",
           [i](Asked& asked) { asked.problem.axes[i].guide->kinds.clear(); });
    for (std::size_t m = 0; m < axis.members.size(); ++m) {
      const Member& member = axis.members[m];
      const auto of_member = [&](const char* what, std::vector<std::string> Member::*words) {
        if ((member.*words).empty()) return;
        choice(add(axis.name, fmt::format("{} of {}", what, member.name), member.where),
               fmt::format("{}", fmt::join(member.*words, ", ")),
               member.name,
               [=](Asked& asked) { (asked.problem.axes[i].members[m].*words).clear(); });
      };
      of_member("kind of section", &Member::section_kinds);
    }
  }

  void add_steering() {
    for (std::size_t i = 0; i < asked_.fixed.lines.size(); ++i) {
      const BomLine& line = asked_.fixed.lines[i];
      const std::string axis = line.axis, slot = line.slot;
      choice(add(axis, "--fix " + slot, {}),
             line.value ? scalar::format(*line.value, scalar::Unit::of(unit_of_setting(slot))) : line.part_number,
             slot,
             [axis, slot](Asked& asked) {
               std::erase_if(asked.fixed.lines,
                             [&](const BomLine& each) { return each.axis == axis && each.slot == slot; });
             });
    }
    for (const ExcludedPart& part : asked_.without) {
      const std::string maker = part.manufacturer, number = part.part_number;
      choice(add("machine", part.said_in.empty() ? "--without" : "not available", {}),
             maker.empty() ? number : fmt::format("{} {}", maker, number),
             "",
             [=](Asked& asked) {
               std::erase_if(asked.without, [&](const ExcludedPart& each) {
                 return each.manufacturer == maker && each.part_number == number;
               });
             });
    }
  }

  const Asked& asked_;
  const Problem& problem_;
  Places places_;
  const Catalogue& catalogue_;
  std::vector<Condition> result_;
};

}  // namespace

std::vector<Condition> conditions_of(const Asked& asked, const text::Document& document, const Catalogue& catalogue) {
  std::vector<Condition> result = Collector(asked, document, catalogue).collect();
  for (Condition& condition : result)
    if (!condition.lift)
      condition.lift = [set = condition.set, far = condition.eased(condition.furthest)](Asked& each) {
        set(each, far);
      };
  return result;
}

}  // namespace millwright::machine
