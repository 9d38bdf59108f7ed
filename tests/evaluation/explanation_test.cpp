// SPDX-License-Identifier: Apache-2.0
// What is explained of small machines, against all of their builds, tried one by one.
#include "evaluation/explanation.h"

#include <fmt/format.h>

#include <fstream>

#include "catch.h"
#include "evaluation/exhaustive.h"
#include "evaluation/stated_conditions.h"
#include "evaluation/tiny_catalogue.h"
#include "sanitized.h"

namespace explanation_test {

using namespace millwright;
using evaluation::ConditionSet;
using evaluation::Explanation;
using evaluation::MachineModel;
using machine::Asked;
using machine::Condition;
using machine::ConditionKind;

namespace {

/// One slide; `more` may state [limits] and the like, `require` requirements of the axis.
std::string slide(const std::string& more = {}, const std::string& require = {}, const char* time = "6 s") {
  return fmt::format(R"([currency]
USD = 1.0
[supply]
voltage = ["24 V"]
{}
[[axis]]
name = "x"
stroke = "300 mm"
structure_mass = "10 kg"
guide_friction = 0.05
acceleration_time = ["0.02 s", "0.5 s"]
mechanism = {{ kind = "screw", screw = ["ball_screws", "lead_screws"], ends = "fixed-supported" }}
motor = {{ microsteps = 8 }}
guide = {{ kinds = ["profile rail"], carriages = 4, carriage_spacing = "100 mm", rail_spacing = "200 mm" }}
[[axis.moves]]
name = "feed"
distance = "200 mm"
time = "{}"
force = "60 N"
[axis.require]
{}
)",
                     more,
                     time,
                     require);
}

struct Case : StatedConditions {
  explicit Case(const std::string& toml, const TinyCatalogue& tiny)
      : StatedConditions("slide.toml", toml, tiny.parts()), parts(tiny.parts()) {}
  [[nodiscard]] Explanation explain() const { return evaluation::explain(asked, parts, conditions, {}); }

  /// All builds with a change of what is asked.
  template <class Change>
  [[nodiscard]] Exhaustive builds(Change&& change) const {
    Asked changed = asked;
    change(changed);
    const MachineModel model(changed.problem, parts);
    if (!model.empty_slots().empty()) throw std::runtime_error("an empty slot");
    return within(changed.problem, Exhaustive(model));
  }
  [[nodiscard]] bool possible(const ConditionSet& imposed) const {
    return !builds([&](Asked& changed) {
              for (std::size_t i = 0; i < conditions.size(); ++i)
                if (std::count(imposed.begin(), imposed.end(), i) == 0) conditions[i].lift(changed);
            }).builds.empty();
  }
  [[nodiscard]] std::size_t named(const std::string& name) const {
    for (std::size_t i = 0; i < conditions.size(); ++i)
      if (conditions[i].name == name) return i;
    throw std::runtime_error("no condition " + name);
  }

  /// The solver holds budgets, no stage does.
  static Exhaustive within(const machine::Problem& problem, Exhaustive all) {
    std::erase_if(all.builds, [&](const BuildValue& build) {
      using machine::Quantity;
      return build.cost > problem.limits[Quantity::cost].value_or(1e9) ||
             build.mass > problem.limits[Quantity::mass].value_or(1e9);
    });
    return all;
  }

  catalogue::Catalogue parts;
};

/// Cannot be met together, and can without any one: by trying all builds, over every subset.
void expect_minimal(const Case& machine, const ConditionSet& conflict) {
  REQUIRE(conflict.size() < 10);
  for (std::size_t subset = 0; subset < std::size_t{1} << conflict.size(); ++subset) {
    ConditionSet imposed;
    for (std::size_t i = 0; i < conflict.size(); ++i)
      if ((subset >> i & 1U) != 0) imposed.push_back(conflict[i]);
    CAPTURE(subset);
    CHECK(machine.possible(imposed) == (imposed.size() < conflict.size()));
  }
}

const Condition& condition_of(const Explanation& explanation, const evaluation::Relaxation& way) {
  return explanation.conditions[way.condition];
}

}  // namespace

TEST_CASE("Each condition knows its value and its place") {
  const TinyCatalogue tiny;
  const Case machine(slide("[require]\ninertia_ratio = 12", "life = \"5000 h\""), tiny);
  const Condition& ratio = machine.conditions[machine.named("inertia_ratio")];
  CHECK(ratio.given);
  CHECK(ratio.where.line == 6);
  CHECK(ratio.where.column == 17);
  CHECK(ratio.value == 12.0);
  CHECK(ratio.setting == "axis.x.require.inertia_ratio");
  CHECK(ratio.larger_is_looser);
  const Condition& life = machine.conditions[machine.named("life")];
  CHECK(life.where.line == 22);
  CHECK_FALSE(life.larger_is_looser);
  CHECK(machine::shown(life, life.value, "USD") == "5000 h");
  const Condition& time = machine.conditions[machine.named("time of move 'feed'")];
  CHECK(time.where.line == 19);
  CHECK(machine::shown(time, time.value, "USD") == "6 s");
  CHECK_FALSE(machine.conditions[machine.named("torque_margin")].given);
  CHECK(machine.conditions[machine.named("structure_mass")].where.line == 10);
  // To set a value is to change just that.
  Asked changed = machine.asked;
  time.set(changed, 7.0);
  CHECK(*changed.problem.axes[0].moves[0].time == 7.0);
  // A share is eased to the whole and no further, a safety to none.
  machine.conditions[machine.named("torque_margin")].lift(changed);
  CHECK(changed.problem.axes[0].require(machine::Requirement::torque_margin) == Approx(1.0));
  machine.conditions[machine.named("screw_safety_factor")].lift(changed);
  CHECK(changed.problem.axes[0].require(machine::Requirement::screw_safety_factor) == Approx(1.0));
}

TEST_CASE("Values are rounded to the looser side") {
  Condition larger;
  larger.value = 0.7;
  larger.unit = "1";
  CHECK(machine::rounded_looser(larger, 0.71234) == Approx(0.713));
  CHECK(machine::rounded_looser(larger, 0.713) == Approx(0.713));
  Condition smaller = larger;
  smaller.larger_is_looser = false;
  CHECK(machine::rounded_looser(smaller, 0.71299) == Approx(0.712));
  Condition money;
  money.value = 10.0;
  money.kind = ConditionKind::budget;
  CHECK(machine::rounded_looser(money, 12.3411) == Approx(12.35));
}

TEST_CASE("A budget nothing keeps is the whole conflict, and the way out is the cheapest build there is") {
  const TinyCatalogue tiny;
  const Case free(slide(), tiny);
  const double least = free.builds([](Asked&) {}).least(&BuildValue::cost);
  // Below what anything costs, whatever else is given up.
  const Case poor(slide("[limits]\ncost = \"1 USD\""), tiny);
  const Explanation explanation = poor.explain();
  CHECK(explanation.status == solver::Status::infeasible);
  REQUIRE(explanation.conflicts.size() == 1);
  CHECK(explanation.conflicts[0].conditions == ConditionSet{poor.named("limit of cost")});
  REQUIRE(explanation.conflicts[0].ways.size() == 1);
  const evaluation::Relaxation& way = explanation.conflicts[0].ways[0];
  REQUIRE(way.to.has_value());
  CHECK(*way.to == Approx(least).margin(0.0100001));
  CHECK(*way.to >= least);
  REQUIRE(way.design.has_value());
  CHECK(way.design->cost == Approx(least));
}

TEST_CASE("Budgets of cost and mass that builds keep one by one and not together are in conflict") {
  // The larger guides are the cheaper ones.
  const TinyCatalogue tiny([](const std::string& part, PriceAndMass usual) {
    return part == "R20" ? PriceAndMass{4.0, usual.mass} : usual;
  });
  const Case free(slide(), tiny);
  const std::vector<BuildValue> front = free.builds([](Asked&) {}).front();
  REQUIRE(front.size() > 1);
  const Case both(
      slide(fmt::format(
          "[limits]\ncost = \"{} USD\"\nmass = \"{} kg\"", front.front().cost + 1e-3, front.back().mass + 1e-6)),
      tiny);
  const Explanation explanation = both.explain();
  REQUIRE(explanation.conflicts.size() == 1);
  const ConditionSet& conflict = explanation.conflicts[0].conditions;
  for (const char* name : {"limit of cost", "limit of mass"})
    CHECK(std::count(conflict.begin(), conflict.end(), both.named(name)) == 1);
  expect_minimal(both, conflict);
  for (const evaluation::Relaxation& way : explanation.conflicts[0].ways) {
    const Condition& condition = condition_of(explanation, way);
    if (condition.name == "limit of cost") CHECK(*way.to == Approx(front.back().cost).margin(0.0100001));
    if (condition.name == "limit of mass") CHECK(*way.to == Approx(front.front().mass).epsilon(0.01));
  }
}

TEST_CASE("Ways out of a position error that nothing keeps: enough where they say, and not a percent before") {
  const TinyCatalogue tiny;
  const Case machine(slide("", "position_error = { limit = \"5 um\", over = \"300 mm\" }"), tiny);
  const Explanation explanation = machine.explain();
  CHECK_FALSE(explanation.design.has_value());
  REQUIRE_FALSE(explanation.conflicts.empty());
  const evaluation::Conflict& conflict = explanation.conflicts[0];
  CHECK(std::count(conflict.conditions.begin(), conflict.conditions.end(), machine.named("position_error")) == 1);
  expect_minimal(machine, conflict.conditions);
  std::size_t tried = 0;
  for (const evaluation::Relaxation& way : conflict.ways) {
    if (!way.enough || !way.to) continue;
    const Condition& condition = condition_of(explanation, way);
    CAPTURE(condition.name, *way.to);
    const auto with = [&](double value) { return machine.builds([&](Asked& asked) { condition.set(asked, value); }); };
    const Exhaustive enough = with(*way.to);
    REQUIRE_FALSE(enough.builds.empty());
    CHECK(way.design->cost == Approx(enough.least(&BuildValue::cost)));
    // Bisected to 1 %, then rounded to three digits: at most 1 % more.
    CHECK(with(condition.larger_is_looser ? *way.to / 1.025 : *way.to * 1.025).builds.empty());
    ++tried;
  }
  CHECK(tried > 0);
}

TEST_CASE("A move that is too fast is in a minimal conflict") {
  const TinyCatalogue tiny;
  const Case machine(slide("", "", "0.5 s"), tiny);
  const Explanation explanation = machine.explain();
  CHECK_FALSE(explanation.design.has_value());
  REQUIRE_FALSE(explanation.conflicts.empty());
  for (const evaluation::Conflict& conflict : explanation.conflicts) expect_minimal(machine, conflict.conditions);
  CHECK(std::count(explanation.conflicts[0].conditions.begin(),
                   explanation.conflicts[0].conditions.end(),
                   machine.named("time of move 'feed'")) == 1);
}

TEST_CASE("Where a load turns the screw with the power off, a brake or a counterbalance is a way out") {
  const TinyCatalogue tiny;
  std::string toml = slide();
  toml.replace(toml.find("guide_friction = 0.05"), 21, "direction = \"vertical\"");
  toml.replace(toml.find("\"ball_screws\", \"lead_screws\""), 28, "\"ball_screws\"");
  toml.replace(toml.find("\"10 kg\""), 7, "\"20 kg\"");
  const Case machine(toml, tiny);
  // 20 kg on a ball screw of 5 mm lead at 80 to 100 % drive it with 0.125 to 0.156 N.m; the most that a motor here
  // keeps without current is 0.12 N.m of detent torque.
  const Explanation explanation = machine.explain();
  CHECK_FALSE(explanation.design.has_value());
  REQUIRE(explanation.conflicts.size() == 1);
  const evaluation::Conflict& conflict = explanation.conflicts[0];
  const std::size_t brake = machine.named("brake_torque");
  CHECK(std::count(conflict.conditions.begin(), conflict.conditions.end(), brake) == 1);
  expect_minimal(machine, conflict.conditions);
  bool balanced = false, least_found = false, cheapest_found = false;
  const double cheapest =
      machine.builds([&](Asked& asked) { machine.conditions[brake].lift(asked); }).least(&BuildValue::cost);
  for (const evaluation::Relaxation& way : conflict.ways) {
    if (way.condition != brake) continue;
    REQUIRE(way.design.has_value());
    const Condition& changed = way.changed(explanation.conditions);
    const auto with = [&](double value) { return machine.builds([&](Asked& asked) { changed.set(asked, value); }); };
    CAPTURE(changed.name, *way.to);
    CHECK(way.design->cost == Approx(with(*way.to).least(&BuildValue::cost)));
    REQUIRE_FALSE(way.broken.empty());
    CHECK(way.broken[0].id == "C-ST-BACK");
    const Exhaustive less = with(*way.to / 1.025);
    if (way.instead) {
      CHECK(changed.name == "counterbalance_force");
      CHECK(*way.to < 25.0 * 9.81);
      // What is said not to be enough is not, and the last of it is close below.
      REQUIRE_FALSE(way.refused.empty());
      for (const double value : way.refused) {
        CAPTURE(value);
        CHECK(with(value).builds.empty());
        CHECK(value < *way.to);
      }
      CHECK(std::is_sorted(way.refused.begin(), way.refused.end()));
      CHECK(way.refused.back() > *way.to / 1.025);
      balanced = true;
    } else {
      // brake_factor is 1.5
      CHECK(*way.to > 1.5 * 0.12);
      CHECK(*way.to < 1.5 * 0.2);
      least_found = least_found || less.builds.empty();
      const bool is_cheapest = way.design->cost == Approx(cheapest);
      cheapest_found = cheapest_found || is_cheapest;
      if (is_cheapest && !less.builds.empty()) CHECK(less.least(&BuildValue::cost) > cheapest * (1.0 + 1e-6));
    }
  }
  CHECK(balanced);
  CHECK(least_found);
  CHECK(cheapest_found);
}

// A proof that others contradict each other rests on lifted limits permitting all that they permitted before. Errors at
// the tool and what gives way there are counted in hundredths of what is permitted, rounded up.
TEST_CASE("A limit of the tool that is lifted leaves a build what it was, or less") {
  const std::string name = MILLWRIGHT_SOURCE_DIR "/problems/inserter.toml";
  std::ifstream file(name);
  const std::string toml{std::istreambuf_iterator<char>(file), {}};
  StatedConditions stated(name, toml, shipped_catalogue());
  stated.asked.problem.counted = {machine::Quantity::position_error};
  const MachineModel model(stated.asked.problem, shipped_catalogue());
  evaluation::SearchOptions options;
  const auto found = evaluation::synthesise(model, options);
  REQUIRE(found.designs.size() == 1);
  const double as_asked = found.designs[0].total(machine::Quantity::position_error);
  std::size_t lifted_count = 0;
  for (const Condition& condition : stated.conditions) {
    if (condition.name != "deflection of the tool" && condition.name != "position error of the tool") continue;
    ++lifted_count;
    INFO(condition.name);
    Asked lifted = stated.asked;
    condition.lift(lifted);
    const auto design = MachineModel(lifted.problem, shipped_catalogue()).design(found.builds[0]);
    CHECK(design.total(machine::Quantity::position_error) <= as_asked * (1.0 + 1e-12));
    CHECK(design.satisfied());
  }
  CHECK(lifted_count == 2);
  // Nor does more deflection than the error leaves room for make the machine impossible.
  machine::Problem loose = stated.asked.problem;
  loose.tool->deflection = 5e-3;
  CHECK(evaluation::synthesise(MachineModel(loose, shipped_catalogue()), options).designs.size() == 1);
}

TEST_CASE("Where the catalogues lack a family, no condition is blamed") {
  const TinyCatalogue tiny({}, {"linear_guides"});
  const Explanation explanation = Case(slide(), tiny).explain();
  CHECK(explanation.catalogue_lacks);
  CHECK(explanation.conflicts.empty());
  REQUIRE_FALSE(explanation.empty_slots.empty());
  CHECK(explanation.empty_slots[0].slot == "guide");
}

TEST_CASE("Where no driver does what is asked, it is the drivers that are named") {
  const TinyCatalogue tiny;
  // Drivers of 9 to 30 V and 18 to 50 V, of which driver_voltage_factor (0.9) may be used; 32 and 128 microsteps.
  const auto missing = [&](const char* what, const char* instead) {
    std::string toml = slide();
    toml.replace(toml.find(what), std::string(what).size(), instead);
    const Case machine(toml, tiny);
    const std::vector<evaluation::EmptySlot> empty = MachineModel(machine.asked.problem, machine.parts).empty_slots();
    REQUIRE(empty.size() == 1);
    return empty[0].slot + ": " + empty[0].reason;
  };
  const std::string volts = missing("\"24 V\"", "\"230 V\", \"110 V\"");
  CAPTURE(volts);
  CHECK(volts.find("driver: no driver runs at the supply's 230 V or 110 V") == 0);
  CHECK(volts.find("9 V to 45 V") != std::string::npos);
  const std::string steps = missing("microsteps = 8", "microsteps = 256");
  CAPTURE(steps);
  CHECK(steps.find("driver: no driver makes 256 microsteps") == 0);
  CHECK(steps.find("128 at most") != std::string::npos);
  CHECK(missing("microsteps = 8", "frame = \"NEMA99\"") == "motor: the catalogues have no NEMA99");
}

TEST_CASE("What the next best choice costs is what the machine costs without that part") {
  const TinyCatalogue tiny;
  const Case machine(slide(), tiny);
  const Explanation explanation = machine.explain();
  REQUIRE(explanation.design.has_value());
  CHECK(explanation.status == solver::Status::optimal);
  const double base = machine.builds([](Asked&) {}).least(&BuildValue::cost);
  CHECK(explanation.design->cost == Approx(base));
  CHECK(explanation.choices.size() == explanation.design->parts.size());
  for (const evaluation::SlotChoice& choice : explanation.choices) {
    CAPTURE(choice.slot, choice.part);
    catalogue::Catalogue without = machine.parts;
    without.drop(without.find_named(choice.part).parts);
    const MachineModel model(machine.asked.problem, without);
    const double next = model.empty_slots().empty() ? Exhaustive(model).least(&BuildValue::cost)
                                                    : std::numeric_limits<double>::infinity();
    CHECK(choice.next_best.has_value() == std::isfinite(next));
    if (choice.next_best) CHECK(*choice.next_best == Approx(next - base).margin(1e-6));
  }
}

TEST_CASE("What a condition costs is what is saved without it and all others cost nothing") {
  const TinyCatalogue tiny;
  const Case machine(slide("", "inertia_ratio = 0.5\nlife = \"20000 h\""), tiny);
  const Explanation explanation = machine.explain();
  REQUIRE(explanation.design.has_value());
  const double base = explanation.design->cost;
  CHECK(explanation.prices.size() + explanation.costless == explanation.conditions.size());
  for (std::size_t i = 0; i < explanation.conditions.size(); ++i) {
    const Condition& condition = machine.conditions[i];
    CAPTURE(condition.name);
    if (sanitized && i % 3 != 0) continue;
    const double saved = base - machine.builds([&](Asked& asked) { condition.lift(asked); }).least(&BuildValue::cost);
    const auto price = std::find_if(explanation.prices.begin(),
                                    explanation.prices.end(),
                                    [&](const evaluation::Price& each) { return each.condition == i; });
    if (price == explanation.prices.end()) {
      CHECK(saved == Approx(0.0).margin(1e-3));
      continue;
    }
    CHECK(price->at_most == Approx(saved));
    if (!price->to) continue;
    CHECK(price->saving ==
          Approx(base -
                 machine.builds([&](Asked& asked) { condition.set(asked, *price->to); }).least(&BuildValue::cost)));
    CHECK(price->saving > 0.0);
  }
}

TEST_CASE("When time is up, that is said") {
  const TinyCatalogue tiny;
  const Case machine(slide(), tiny);
  evaluation::SearchOptions options;
  options.time_limit_seconds = 1e-9;
  const Explanation explanation = evaluation::explain(machine.asked, machine.parts, machine.conditions, options);
  CHECK(explanation.status == solver::Status::limit);
  CHECK_FALSE(explanation.design.has_value());
}

}  // namespace explanation_test
