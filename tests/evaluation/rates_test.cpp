// SPDX-License-Identifier: Apache-2.0
// What a little of each condition is worth where free dimensions move the objective: by hand, and against differences
// of machines solved to the proof.
#include <cmath>

#include "evaluation/explanation.h"
#include "evaluation/hand_worked.h"
#include "evaluation/stated_conditions.h"
#include "evaluation/synthesis.h"
#include "sanitized.h"

namespace rates_test {

using namespace millwright;
using namespace millwright::hand_worked;
using evaluation::Explanation;
using evaluation::Rate;
using machine::Asked;
using machine::Condition;

namespace {

/// A light drive is enough for it.
const std::string slow_axis = R"([currency]
USD = 1.0
[supply]
voltage = ["24 V"]
[[axis]]
name = "x"
direction = "horizontal"
stroke = "500 mm"
structure_mass = "20 kg"
mechanism = { kind = "belt", idler_distance = "80 mm" }
[[axis.moves]]
distance = "400 mm"
time = "3 s"
force = "10 N"
)";

struct Case : StatedConditions {
  explicit Case(const std::string& member, const std::string& require)
      : StatedConditions("axis.toml",
                         slow_axis + "[[axis.members]]\nname = \"part\"\n" + member +
                             "\n[axis.require]\ninertia_ratio = 100\n" + require,
                         parts()) {}
  [[nodiscard]] Explanation explain(const std::string& objective = "cost") const {
    evaluation::SearchOptions options;
    options.objectives = {objective};
    return evaluation::explain(asked, parts(), conditions, options);
  }
  /// The proven best with a condition at another value.
  [[nodiscard]] evaluation::Design best(const Condition& condition, double value) const {
    Asked changed = asked;
    condition.set(changed, value);
    const evaluation::MachineModel model(changed.problem, parts());
    evaluation::Synthesis found = evaluation::synthesise(model, {});
    REQUIRE(found.status == solver::Status::optimal);
    return found.designs.front();
  }
};

const Rate* rate_of(const Explanation& explanation, const std::string& name) {
  for (const Rate& rate : explanation.rates)
    if (explanation.conditions[rate.condition].name == name) return &rate;
  return nullptr;
}

/// A steel plate of 300 mm between its rails and 200 mm wide, of which the thickness is free.
const std::string plate =
    "kind = \"plate\"\nmaterial = \"steel\"\nlength = \"300 mm\"\nwidth = \"200 mm\"\nsupport = \"supported\"\n"
    "thickness = [\"2 mm\", \"30 mm\"]";

std::vector<std::string> names(const evaluation::Design& design) {
  std::vector<std::string> result;
  for (const evaluation::PartLine& part : design.parts) result.push_back(part.axis + part.slot + part.part_number);
  return result;
}

}  // namespace

TEST_CASE("What a little more deflection and load are worth to a plate is worked by hand") {
  const double ratio = 2e-5;
  const Case machine(plate, "frame_deflection_ratio = 2e-5");
  const Explanation explanation = machine.explain();
  REQUIRE(explanation.design.has_value());
  // Thickness t at which (F L^3/48 + 5 w L^4/384)/(E I) = ratio L; F of 20 kg and the belt, w = 1600 kg/m2 t g.
  const double E = 200e9, L = 0.3, F = (20.0 + belt_allowance) * g, w = 8000.0 * 0.2 * g;
  const double inertia = 0.2 / 12.0, a = F * L * L * L / 48.0, b = 5.0 * w * std::pow(L, 4) / 384.0;
  const auto deflection = [&](double t) { return (a + b * t) / (E * inertia * t * t * t); };
  double low = 2e-3, high = 30e-3;
  for (int i = 0; i < 200; ++i) (deflection(0.5 * (low + high)) > ratio * L ? low : high) = 0.5 * (low + high);
  const double t = low;
  CHECK(explanation.moving.size() == 1);
  CHECK(explanation.moving[0].name == "part.thickness");
  CHECK(explanation.moving[0].value == Approx(t).epsilon(1e-6));
  REQUIRE(explanation.holding.size() == 1);
  CHECK(explanation.holding[0].id == "C-FR-DEFL");
  const double steepness = (b * t - 3.0 * (a + b * t)) / (E * inertia * std::pow(t, 4));  // d deflection / dt
  const double price = 2.0 * 8000.0 * 0.3 * 0.2;                                          // per metre of thickness
  const Rate* asked = rate_of(explanation, "frame_deflection_ratio");
  REQUIRE(asked != nullptr);
  CHECK(asked->slope == Approx(price * L / steepness).epsilon(1e-4));
  const Rate* mass = rate_of(explanation, "structure_mass");
  REQUIRE(mass != nullptr);
  CHECK(mass->slope == Approx(-price * g * L * L * L / 48.0 / (E * inertia * t * t * t) / steepness).epsilon(1e-4));
  // Nothing else holds the plate.
  CHECK(rate_of(explanation, "frame_safety_factor") == nullptr);
  CHECK(rate_of(explanation, "torque_margin") == nullptr);
  if (sanitized) return;
  // The same in mass: 8000 kg/m3, which are not sold at 2 a kilogram there.
  const Explanation lightest = machine.explain("mass");
  const Rate* in_mass = rate_of(lightest, "frame_deflection_ratio");
  REQUIRE(in_mass != nullptr);
  CHECK(in_mass->slope == Approx(price / 2.0 * L / steepness).epsilon(1e-4));
}

TEST_CASE("What a little of each condition is worth to a bar is what machines solved to the proof differ by") {
  // Two dimensions that deflection down and sideways share out.
  const Case machine(
      "kind = \"bar\"\nmaterial = \"alloy\"\nlength = \"500 mm\"\nsupport = \"supported\"\nlateral_force = \"40 N\"\n"
      "width = [\"5 mm\", \"80 mm\"]\nheight = [\"5 mm\", \"80 mm\"]",
      "frame_deflection_ratio = 1e-4\nframe_safety_factor = 2");
  const Explanation explanation = machine.explain();
  REQUIRE(explanation.design.has_value());
  CHECK(explanation.moving.size() == 2);
  std::size_t compared = 0;
  for (const Rate& rate : explanation.rates) {
    if (sanitized && compared == 1) return;
    const Condition& condition = machine.conditions[rate.condition];
    CAPTURE(condition.name, rate.slope);
    constexpr double step = 0.05;
    const evaluation::Design more = machine.best(condition, condition.value * (1.0 + step));
    const evaluation::Design less = machine.best(condition, condition.value * (1.0 - step));
    if (names(more) != names(*explanation.design) || names(less) != names(*explanation.design)) continue;
    ++compared;
    CHECK((more.cost - less.cost) / (2.0 * step * condition.value) == Approx(rate.slope).epsilon(0.02));
    CHECK((rate.slope < 0.0) == condition.larger_is_looser);
  }
  CHECK(compared > 1);
}

TEST_CASE("Where all that can be chosen is discrete there are no derivatives") {
  const Case machine("kind = \"beam\"\nmaterial = \"steel\"\nsections = [\"steel_sections\"]\nlength = \"500 mm\"", "");
  const Explanation explanation = machine.explain();
  REQUIRE(explanation.design.has_value());
  CHECK(explanation.moving.empty());
  CHECK(explanation.rates.empty());
  CHECK_FALSE(explanation.rates_undetermined);
}

TEST_CASE("A dimension at its own bound holds the objective with no condition") {
  std::string thick = plate;
  thick.replace(thick.find("2 mm\""), 4, "10 mm");
  const Case machine(thick, "frame_deflection_ratio = 0.01");
  const Explanation explanation = machine.explain();
  REQUIRE(explanation.design.has_value());
  REQUIRE(explanation.moving.size() == 1);
  CHECK(explanation.moving[0].value == Approx(10e-3));
  CHECK(explanation.rates.empty());
}

}  // namespace rates_test
