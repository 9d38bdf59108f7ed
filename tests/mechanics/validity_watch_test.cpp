// SPDX-License-Identifier: Apache-2.0
// Stated limits as data: what each formula announces, that each limit can be broken, and what a watch collects.
#include "mechanics/validity_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <thread>

#include "catch.h"
#include "formula_samples.h"
#include "mechanics/beam.h"
#include "mechanics/column.h"
#include "mechanics/guide.h"
#include "mechanics/outside_validity.h"
#include "mechanics/power_screw.h"

namespace validity_watch_test {

using namespace millwright;
using namespace formula_samples;
using mechanics::BrokenLimit;
using mechanics::FormulaWatch;
using mechanics::LeftRange;
using mechanics::ValidityWatch;
using mechanics::WatchedArgument;

namespace {

struct Call {
  std::string formula;
  Arguments arguments;
};

class Recorder final : public FormulaWatch {
 public:
  void called(const char* formula, std::initializer_list<WatchedArgument> arguments) override {
    calls.push_back({formula, mechanics::argument_values(arguments)});
  }
  [[nodiscard]] std::size_t count(const std::string& formula, const Arguments& arguments) const {
    return static_cast<std::size_t>(std::count_if(calls.begin(), calls.end(), [&](const Call& call) {
      return call.formula == formula && call.arguments == arguments;
    }));
  }
  std::vector<Call> calls;
};

template <class T>
std::size_t calls_on(const Formula& formula, const Arguments& values) {
  const auto converted = on_scalar<T>(values, [](double x, Place) { return T(x); });
  Recorder recorder;
  (void)formula.evaluate<T>(converted);
  return recorder.calls.size();
}

/// Far beyond the everyday range, but inside the bounds of the single arguments.
Arguments draw_far(const Formula& formula, Random& random) {
  Arguments values;
  for (const Argument& argument : formula.arguments()) {
    Argument wide = argument;
    const double low = argument.typical_lower > 0.0 ? argument.typical_lower : 1e-3 * argument.typical_upper;
    wide.typical_lower = std::max(argument.lower, low / 1e3);
    wide.typical_upper = std::min(argument.upper, 1e3 * argument.typical_upper);
    values.push_back(draw_value(wide, values, random));
  }
  return values;
}

/// Where a relation breaks in so small a corner of the single bounds that chance does not meet it.
std::map<std::string, Arguments> corners() { return {{"square_thread.tangent_of_sum", {1.0, 1.0}}}; }

bool breaks(const Formula& formula, const Arguments& values, const std::string& sentence) {
  const auto broken = formula.broken_limits(values);
  return std::any_of(
      broken.begin(), broken.end(), [&](const BrokenLimit& limit) { return limit.sentence == sentence; });
}

}  // namespace

TEST_CASE("every formula with stated limits announces its arguments, under its own name") {
  std::size_t limited = 0;
  for (const Formula& formula : mechanics::formulas()) {
    INFO(formula.name());
    Random random(formula.name() + " announcement");
    for (int i = 0; i < 5; ++i) {
      const Arguments values = draw_arguments(formula, random);
      Recorder recorder;
      (void)formula.evaluate<double>(values);
      // What has no limits keeps silent: the announcement and the register cannot drift apart either way.
      CHECK(recorder.count(formula.name(), values) == (formula.has_limits() ? 1 : 0));
      for (const Call& call : recorder.calls) {
        const Formula* other = mechanics::find_formula(call.formula);
        INFO("calls " << call.formula);
        REQUIRE(other != nullptr);
        CHECK(other->has_limits());
      }
    }
    if (formula.has_limits()) ++limited;
  }
  CHECK(limited > 100);
}

TEST_CASE("nothing is announced on other scalars than double") {
  for (const Formula& formula : mechanics::formulas()) {
    if (!formula.has_limits()) continue;
    INFO(formula.name());
    Random random(formula.name() + " silence");
    const Arguments values = draw_arguments(formula, random);
    CHECK(calls_on<scalar::Interval>(formula, values) == 0);
    CHECK(calls_on<scalar::Dual<double>>(formula, values) == 0);
    CHECK(calls_on<scalar::Dual<scalar::Interval>>(formula, values) == 0);
  }
}

TEST_CASE("every stated bound of an argument is told when it is broken") {
  for (const Formula& formula : mechanics::formulas()) {
    Random random(formula.name() + " bounds");
    const Arguments values = draw_arguments(formula, random);
    for (Place place : number_places(values)) {
      const Argument& argument = formula.arguments()[place.first];
      for (const double bound : {argument.lower, argument.upper}) {
        if (!std::isfinite(bound)) continue;
        const bool below = bound == argument.lower;
        const double beyond = std::nextafter(bound, below ? -INFINITY : INFINITY);
        const auto broken = formula.broken_limits(with(values, place, beyond));
        INFO(formula.name() << " " << argument.name);
        REQUIRE(broken.size() == 1);
        CHECK(broken[0].index == 3 * place.first + (below ? 1 : 2));
        CHECK(broken[0].excess > 0.0);
        CHECK(broken[0].sentence.find(argument.name + " = ") == 0);
        CHECK(broken[0].sentence.find(below ? " is below " : " is above ") != std::string::npos);
      }
    }
  }
}

TEST_CASE("every stated relation between arguments can be broken, and is told") {
  const auto known = corners();
  std::size_t relations = 0;
  for (const Formula& formula : mechanics::formulas()) {
    Random random(formula.name() + " relations");
    for (const mechanics::Validity& relation : formula.conditions()) {
      ++relations;
      const std::string sentence = "it does not hold that " + relation.text;
      const auto corner = known.find(formula.name());
      bool found = corner != known.end() && breaks(formula, corner->second, sentence);
      for (int i = 0; i < 20000 && !found; ++i) found = breaks(formula, draw_far(formula, random), sentence);
      INFO(formula.name() << ": " << relation.text);
      CHECK(found);
    }
  }
  CHECK(relations > 50);
}

TEST_CASE("a watch keeps each broken limit once, with the values that break it most") {
  ValidityWatch watch;
  // tan λ = l / (π d) = 1: 45 degrees, beyond the 40 of raising and not beyond the 45 of lowering (31.4 < π · 10).
  (void)mechanics::power_screw::raising_torque(100.0, 0.010, 0.0314, 0.1);
  (void)mechanics::power_screw::raising_torque(100.0, 0.010, 0.0400, 0.1);
  (void)mechanics::power_screw::lowering_torque(100.0, 0.010, 0.0314, 0.1);
  (void)mechanics::power_screw::self_locking_ratio(1.51, 0.1);
  (void)mechanics::power_screw::self_locking_ratio(1.54, 0.1);
  (void)mechanics::power_screw::self_locking_ratio(1.52, 0.1);
  REQUIRE(watch.left().size() == 2);
  CHECK(watch.left()[0].formula->name() == "power_screw.raising_torque");
  CHECK(watch.left()[0].limit.sentence == "it does not hold that lead angle < 40 degrees");
  CHECK(watch.left()[0].arguments == Arguments{100.0, 0.010, 0.0314, 0.1});
  CHECK(watch.left()[1].limit.sentence == "lead_angle = 1.54 rad is above 1.5 rad");
  CHECK(watch.formulas().size() == 3);
}

TEST_CASE("lists and choices are heard as the register takes them") {
  Recorder recorder;
  const std::vector<double> loads{100.0, 50.0}, distances{1.0, 2.0};
  (void)mechanics::guide::mean_load(std::span<const double>(loads), std::span<const double>(distances), 3.0);
  (void)mechanics::power_screw::mean_diameter(mechanics::power_screw::ThreadForm::acme, 0.0254, 0.00508);
  CHECK(recorder.count("guide.mean_load", Arguments{loads, distances, 3.0}) == 1);
  CHECK(recorder.count("power_screw.mean_diameter", Arguments{2, 0.0254, 0.00508}) == 1);
}

TEST_CASE("of a formula with two branches only the one that is taken is judged") {
  // E = 210 GPa, σ_y = 250 MPa, C = 1: transition slenderness √(2 π² 210000 / 250) = 128.8. A square bar of 10 mm has
  // k = 10/√12 = 2.887 mm: slenderness 34.6 at 100 mm (Johnson), 346 at 1 m (Euler).
  ValidityWatch watch;
  (void)mechanics::column::critical_load(1.0, 210e9, 250e6, 1e-4, 1e-8 / 12.0, 0.1);
  (void)mechanics::column::critical_load(1.0, 210e9, 250e6, 1e-4, 1e-8 / 12.0, 1.0);
  CHECK(watch.formulas().size() == 3);
  CHECK(watch.left().empty());
  (void)mechanics::column::johnson_load(1.0, 210e9, 250e6, 1e-4, 1e-8 / 12.0, 1.0);
  REQUIRE(watch.left().size() == 1);
  CHECK(watch.left()[0].formula->name() == "column.johnson_load");
}

TEST_CASE("missing data are no finding, and the youngest watch of its own thread alone hears") {
  ValidityWatch outer;
  (void)mechanics::beam::span_to_height(std::nan(""), 0.1);
  CHECK(outer.left().empty());
  CHECK(outer.formulas().size() == 1);
  {
    ValidityWatch inner;
    (void)mechanics::beam::span_to_height(0.5, 0.1);  // 5 < 8
    CHECK(inner.left().size() == 1);
  }
  CHECK(outer.left().empty());
  std::thread([] { (void)mechanics::beam::span_to_height(0.5, 0.1); }).join();
  CHECK(outer.left().empty());
  (void)mechanics::beam::span_to_height(0.8, 0.1);  // 8: the limit itself is inside
  CHECK(outer.left().empty());
  (void)mechanics::beam::span_to_height(0.5, 0.1);
  CHECK(outer.left().size() == 1);
}

}  // namespace validity_watch_test
