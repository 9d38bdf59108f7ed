// SPDX-License-Identifier: Apache-2.0
// What has to hold for every registered formula, on every scalar, tested at random points of its everyday range.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <functional>
#include <regex>
#include <set>
#include <sstream>

#include "catch.h"
#include "formula_samples.h"
#include "mechanics/formula.h"
#include "sanitized.h"

namespace formula_consistency_test {

using namespace millwright;
using namespace formula_samples;
using mechanics::Monotone;
using scalar::Dual;
using scalar::Interval;

namespace {

constexpr int points = sanitized ? 20 : 40;

double slope_at(const Formula& formula, const Arguments& values, Place place) {
  const auto dual = on_scalar<Dual<double>>(
      values, [&](double x, Place here) { return here == place ? Dual<double>::variable(x, 0) : Dual<double>(x); });
  return formula.evaluate<Dual<double>>(dual).slope[0];
}

/// Formulas that are infinite in a part of their everyday range, by their nature.
bool has_pole(const Formula& formula) { return formula.name() == "stepper.no_load_speed"; }

/// The slope of a power mean by its exponent is a small difference of sums over the list, which a naive interval cannot
/// tell from zero unless the loads of the list differ much.
bool hard_to_bound(const Formula& formula, const Argument& argument) {
  return formula.name() == "guide.mean_load" && argument.name == "exponent";
}

bool stated_anywhere(const Formula& formula) {
  return std::any_of(formula.arguments().begin(), formula.arguments().end(), [](const Argument& a) {
    return a.monotone != Monotone::unknown;
  });
}

/// Whether an argument that could as well be positive is negative.
bool any_negative(const Formula& formula, const Arguments& values) {
  for (Place place : number_places(values))
    if (number_at(values, place) < 0.0 && formula.arguments()[place.first].upper > 0.0) return true;
  return false;
}

/// A central difference, extrapolated from two step sizes, or nothing where the two disagree (a kink or a step lies
/// between) or a neighbour is invalid. `scale` makes slopes comparable to values.
struct Difference {
  enum { smooth, kinked, outside } verdict;
  double slope = 0.0;
  double uncertainty = 0.0;
};

Difference difference_at(const Formula& formula, const Arguments& values, Place place, double scale) {
  const double x = number_at(values, place);
  const double h = 2e-4 * scale;
  double f[5];
  for (int i = 0; i < 5; ++i) {
    const Arguments moved = with(values, place, x + h * (0.5 * i - 1.0));
    if (!formula.violations(moved).empty()) return {Difference::outside};
    f[i] = formula.evaluate<double>(moved);
    if (!std::isfinite(f[i])) return {Difference::outside};
  }
  // Where only the curvature jumps (Euler to Johnson) the two still differ a little: that is the uncertainty.
  const double wide = (f[4] - f[0]) / (2.0 * h), narrow = (f[3] - f[1]) / h;
  const double left = (f[2] - f[1]) / (0.5 * h), right = (f[3] - f[2]) / (0.5 * h);
  const double size = std::abs(f[2]) / scale + std::abs(narrow);
  if (std::abs(wide - narrow) > 1e-5 * size || std::abs(right - left) > 1e-2 * size) return {Difference::kinked};
  return {Difference::smooth, (4.0 * narrow - wide) / 3.0, std::abs(wide - narrow)};
}

/// A box around the point, relative half width at most 30 %, inside the stated limits.
std::vector<ArgumentValue<Interval>> box_around(const Formula& formula, const Arguments& values, Random& random) {
  const double widths[] = {0.0, 1e-6, 1e-2, 0.1, 0.3};
  return on_scalar<Interval>(values, [&](double x, Place place) {
    const Argument& argument = formula.arguments()[place.first];
    const double width = widths[random.whole(0, 4)] * std::abs(x);
    return Interval(std::max(argument.lower, x - width * random.uniform(0.0, 1.0)),
                    std::min(argument.upper, x + width * random.uniform(0.0, 1.0)));
  });
}

Arguments draw_inside(const std::vector<ArgumentValue<Interval>>& box, Random& random) {
  Arguments values;
  const auto inside = [&](const Interval& range) {
    const double t = random.whole(0, 3) == 0 ? random.whole(0, 1) : random.uniform(0.0, 1.0);
    return std::clamp(range.lower + t * (range.upper - range.lower), range.lower, range.upper);
  };
  for (const auto& value : box) {
    if (const Interval* range = std::get_if<Interval>(&value)) {
      values.emplace_back(inside(*range));
    } else if (const auto* list = std::get_if<std::vector<Interval>>(&value)) {
      std::vector<double> numbers;
      for (const Interval& range_of_element : *list) numbers.push_back(inside(range_of_element));
      values.emplace_back(std::move(numbers));
    } else {
      values.emplace_back(std::get<int>(value));
    }
  }
  return values;
}

/// The box with one of its numbers as the variable of a derivative.
std::vector<ArgumentValue<Dual<Interval>>> differentiated(const std::vector<ArgumentValue<Interval>>& box,
                                                          Place place) {
  std::vector<ArgumentValue<Dual<Interval>>> result;
  for (std::size_t a = 0; a < box.size(); ++a) {
    if (const Interval* x = std::get_if<Interval>(&box[a])) {
      result.emplace_back(Place{a, 0} == place ? Dual<Interval>::variable(*x, 0) : Dual<Interval>(*x));
    } else if (const auto* list = std::get_if<std::vector<Interval>>(&box[a])) {
      std::vector<Dual<Interval>> duals;
      for (std::size_t k = 0; k < list->size(); ++k)
        duals.push_back(Place{a, k} == place ? Dual<Interval>::variable((*list)[k], 0) : Dual<Interval>((*list)[k]));
      result.emplace_back(std::move(duals));
    } else {
      result.emplace_back(std::get<int>(box[a]));
    }
  }
  return result;
}

/// x in the range, up to the rounding of the double computation that gave x.
bool encloses(const Interval& range, double x) {
  const double slack = 1e-13 * std::abs(x);
  return range.lower - slack <= x && x <= range.upper + slack;
}

std::string describe(const Formula& formula, const Arguments& values) {
  std::string text = formula.name();
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += fmt::format(" {}=", formula.arguments()[i].name);
    if (const double* number = std::get_if<double>(&values[i])) text += fmt::format("{}", *number);
    if (const int* choice = std::get_if<int>(&values[i])) text += formula.arguments()[i].choices[std::size_t(*choice)];
    if (const auto* list = std::get_if<std::vector<double>>(&values[i]))
      text += fmt::format("{}", fmt::join(*list, ","));
  }
  return text;
}

std::set<std::string> keys_of_bibliography() {
  std::ifstream file(MILLWRIGHT_SOURCE_DIR "/src/mechanics/sources.bib");
  std::set<std::string> keys;
  const std::regex entry(R"(^@\w+\{([^,\s]+),)");
  for (std::string line; std::getline(file, line);)
    if (std::smatch match; std::regex_search(line, match, entry)) keys.insert(match[1]);
  return keys;
}

}  // namespace

TEST_CASE("every formula is described completely") {
  const std::set<std::string> keys = keys_of_bibliography();
  REQUIRE(keys.size() > 10);
  const std::regex name(R"([a-z0-9_]+\.[a-z0-9_]+)"), word(R"([a-z0-9_]+)");
  for (const Formula& formula : mechanics::formulas()) {
    INFO(formula.name());
    CHECK(std::regex_match(formula.name(), name));
    CHECK_FALSE(formula.title().empty());
    CHECK_FALSE(formula.symbol().empty());
    for (const std::string& key : formula.source_keys()) {
      INFO("source " << key);
      CHECK(keys.count(key) == 1);
    }
    CHECK_NOTHROW(unit_of(formula.unit()));
    if (!formula.display_unit().empty())
      CHECK(unit_of(formula.display_unit()).dimension() == unit_of(formula.unit()).dimension());
    std::set<std::string> names;
    for (const Argument& argument : formula.arguments()) {
      INFO(argument.name);
      CHECK(std::regex_match(argument.name, word));
      CHECK(names.insert(argument.name).second);
      CHECK_FALSE(argument.symbol.empty());
      CHECK_FALSE(argument.meaning.empty());
      CHECK(argument.choices.empty() == (argument.kind != ArgumentKind::choice));
      if (argument.kind == ArgumentKind::choice) continue;
      CHECK_NOTHROW(unit_of(argument.unit));
      CHECK(argument.typical_lower < argument.typical_upper);
      CHECK(argument.lower <= argument.typical_lower);
      CHECK(argument.typical_upper <= argument.upper);
    }
    CHECK(mechanics::find_formula(formula.name()) == &formula);
  }
}

TEST_CASE("derivatives equal central differences") {
  std::size_t compared = 0, skipped = 0;
  for (const Formula& formula : mechanics::formulas()) {
    Random random(formula.name() + " derivative");
    int smooth = 0, kinked = 0;
    for (int i = 0; i < points; ++i) {
      const Arguments values = draw_arguments(formula, random);
      for (Place place : number_places(values)) {
        const Argument& argument = formula.arguments()[place.first];
        const double scale = std::max(std::abs(number_at(values, place)), 0.1 * std::abs(argument.typical_lower));
        const Difference difference = difference_at(formula, values, place, scale);
        if (difference.verdict == Difference::outside) continue;
        if (difference.verdict == Difference::kinked) {
          ++kinked;
          continue;
        }
        ++smooth;
        const double slope = slope_at(formula, values, place);
        const double size = std::abs(formula.evaluate<double>(values)) / scale;
        INFO(describe(formula, values) << " d/d" << argument.name << ": " << slope << " against " << difference.slope);
        CHECK(std::abs(slope - difference.slope) <= 1e-6 * std::abs(slope) + 1e-7 * size + difference.uncertainty);
      }
    }
    INFO(formula.name() << ": " << smooth << " compared, " << kinked << " at a kink");
    CHECK(smooth >= points / 4);
    CHECK(kinked <= (has_pole(formula) ? 5 : 2) + (smooth + kinked) / (has_pole(formula) ? 10 : 20));
    compared += static_cast<std::size_t>(smooth);
    skipped += static_cast<std::size_t>(kinked);
  }
  INFO(compared << " compared, " << skipped << " skipped");
  CHECK(skipped * 100 <= compared);
}

TEST_CASE("intervals contain the values and slopes of every point of the box") {
  for (const Formula& formula : mechanics::formulas()) {
    Random random(formula.name() + " interval");
    int bounded = 0;
    for (int i = 0; i < points; ++i) {
      const Arguments centre = draw_arguments(formula, random);
      const auto box = box_around(formula, centre, random);
      const Interval range = formula.evaluate<Interval>(box);
      if (range.is_bounded()) ++bounded;
      const auto places = number_places(centre);
      const Place place = places[static_cast<std::size_t>(random.whole(0, static_cast<int>(places.size()) - 1))];
      const Dual<Interval> dual = formula.evaluate<Dual<Interval>>(differentiated(box, place));
      for (int k = 0; k < 12; ++k) {
        const Arguments inside = k == 0 ? centre : draw_inside(box, random);
        if (!formula.violations(inside).empty()) continue;
        const double value = formula.evaluate<double>(inside);
        if (!std::isfinite(value)) continue;
        INFO(describe(formula, inside) << " = " << value << " in [" << range.lower << ", " << range.upper << "]");
        CHECK(encloses(range, value));
        CHECK(encloses(dual.value, value));
        const double slope = slope_at(formula, inside, place);
        if (!std::isfinite(slope)) continue;
        INFO("slope by " << formula.arguments()[place.first].name << " = " << slope << " in [" << dual.slope[0].lower
                         << ", " << dual.slope[0].upper << "]");
        CHECK(encloses(dual.slope[0], slope));
      }
    }
    INFO(formula.name() << ": bounded on " << bounded << " of " << points << " boxes");
    CHECK(bounded >= points * (has_pole(formula) ? 7 : 9) / 10);
  }
}

TEST_CASE("dimensions prove out") {
  for (const Formula& formula : mechanics::formulas()) {
    Random random(formula.name() + " dimension");
    for (int i = 0; i < 5; ++i) {
      const Arguments values = draw_arguments(formula, random);
      const auto dimensioned = on_scalar<scalar::Dimensioned>(values, [&](double x, Place place) {
        return scalar::Dimensioned(x, unit_of(formula.arguments()[place.first].unit).dimension());
      });
      INFO(formula.name());
      scalar::Dimensioned result;
      REQUIRE_NOTHROW(result = formula.evaluate<scalar::Dimensioned>(dimensioned));
      INFO(to_string(result.dimension) << " instead of " << formula.unit());
      CHECK((result.dimension == unit_of(formula.unit()).dimension()));
      CHECK(std::bit_cast<std::uint64_t>(result.value) ==
            std::bit_cast<std::uint64_t>(formula.evaluate<double>(values)));
    }
  }
}

TEST_CASE("the traced value equals the double value bit for bit") {
  for (const Formula& formula : mechanics::formulas()) {
    Random random(formula.name() + " traced");
    for (int i = 0; i < 20; ++i) {
      const Arguments values = draw_arguments(formula, random);
      const auto traced = on_scalar<scalar::Traced>(values, [&](double x, Place place) {
        const Argument& argument = formula.arguments()[place.first];
        return scalar::Traced::leaf(argument.symbol, x, unit_of(argument.unit));
      });
      const scalar::Traced result = formula.evaluate<scalar::Traced>(traced);
      INFO(describe(formula, values));
      CHECK(std::bit_cast<std::uint64_t>(result.value) ==
            std::bit_cast<std::uint64_t>(formula.evaluate<double>(values)));
      if (i > 0) continue;
      const auto lines = scalar::derivation(result, formula.symbol(), unit_of(formula.unit()));
      REQUIRE_FALSE(lines.empty());
      CHECK(lines.back().symbol == formula.symbol());
      CHECK_FALSE(lines.back().expression.empty());
    }
  }
}

TEST_CASE("stated monotone directions hold") {
  for (const Formula& formula : mechanics::formulas()) {
    Random random(formula.name() + " monotone");
    int compared = 0, stated = 0;
    for (int i = 0; i < 5 * points; ++i) {
      const Arguments values = draw_arguments(formula, random);
      for (Place place : number_places(values)) {
        const Argument& argument = formula.arguments()[place.first];
        if (argument.monotone == Monotone::unknown) continue;
        const Arguments other = with(values, place, draw(argument, random));
        if (any_negative(formula, values) || any_negative(formula, other)) continue;
        ++stated;
        if (!formula.violations(other).empty()) continue;
        Arguments low = values, high = other;
        if (number_at(low, place) > number_at(high, place)) std::swap(low, high);
        double less = formula.evaluate<double>(low), more = formula.evaluate<double>(high);
        if (argument.monotone == Monotone::falling) std::swap(less, more);
        if (!std::isfinite(less) || !std::isfinite(more)) continue;
        ++compared;
        INFO(describe(formula, low) << " = " << less << " | " << describe(formula, high) << " = " << more);
        CHECK(less <= more + 1e-12 * std::max(std::abs(less), std::abs(more)));
      }
    }
    INFO(formula.name() << ": " << compared << " of " << stated << " pairs compared");
    CHECK(compared * 20 >= stated);
    if (stated_anywhere(formula)) CHECK(compared > 0);
  }
}

TEST_CASE("stated monotone directions are confirmed over boxes") {
  std::size_t judged = 0, confirmed = 0;
  for (const Formula& formula : mechanics::formulas()) {
    Random random(formula.name() + " monotone boxes");
    for (std::size_t a = 0; a < formula.arguments().size(); ++a) {
      const Argument& argument = formula.arguments()[a];
      if (argument.monotone == Monotone::unknown) continue;
      int boxes = 0, right = 0;
      for (int i = 0; i < 3 * points; ++i) {
        const Arguments values = draw_arguments(formula, random);
        if (any_negative(formula, values)) continue;
        const double width = i % 2 == 0 ? 1e-3 : 3e-2;
        const auto box = on_scalar<Interval>(values, [&](double x, Place) {
          const double half = width * std::abs(x);
          return Interval(x - half * random.uniform(0.0, 1.0), x + half * random.uniform(0.0, 1.0));
        });
        const auto slope = formula.evaluate<Dual<Interval>>(differentiated(box, {a, 0})).slope[0];
        ++boxes;
        const bool rises = argument.monotone == Monotone::rising;
        INFO(describe(formula, values) << " by " << argument.name << " in [" << slope.lower << ", " << slope.upper
                                       << "]");
        // The slope at the point itself is inside: a slope of the other sign all over refutes what is stated.
        CHECK_FALSE((rises ? slope.upper < 0.0 : slope.lower > 0.0));
        if (rises ? slope.lower >= 0.0 : slope.upper <= 0.0) ++right;
      }
      INFO(formula.name() << " by " << argument.name << ": " << right << " of " << boxes << " boxes");
      CHECK(10 * right >= boxes * (hard_to_bound(formula, argument) ? 1 : 4));
      judged += static_cast<std::size_t>(boxes);
      confirmed += static_cast<std::size_t>(right);
    }
  }
  INFO(confirmed << " of " << judged << " slopes over boxes have the stated sign throughout");
  CHECK(confirmed * 100 >= judged * 98);
}

TEST_CASE("values of the wrong number or kind are refused") {
  const Formula* formula = mechanics::find_formula("power_screw.lead");
  REQUIRE(formula != nullptr);
  CHECK(formula == mechanics::find_formula("SCREW-LEAD"));
  CHECK(mechanics::find_formula("power_screw.lead ") == nullptr);
  CHECK(mechanics::find_formula("") == nullptr);
  CHECK_THROWS_AS(formula->evaluate<double>(Arguments{0.002}), std::invalid_argument);
  CHECK_THROWS_AS(formula->evaluate<double>(Arguments{0.002, std::vector<double>{1.0}}), std::invalid_argument);
  CHECK_THROWS_AS(formula->evaluate<double>(Arguments{0.002, 1}), std::invalid_argument);
  const Formula* mean = mechanics::find_formula("ball_screw.mean_speed");
  REQUIRE(mean != nullptr);
  CHECK_THROWS_AS(mean->evaluate<double>(Arguments{std::vector<double>{}, std::vector<double>{}}),
                  std::invalid_argument);
  CHECK_THROWS_AS(mean->evaluate<double>(Arguments{std::vector<double>{1.0, 2.0}, std::vector<double>{1.0}}),
                  std::invalid_argument);
}

TEST_CASE("broken limits are told in words") {
  const Formula* raising = mechanics::find_formula("power_screw.raising_torque");
  REQUIRE(raising != nullptr);
  CHECK(raising->violations(Arguments{100.0, 0.014, 0.004, 0.15}).empty());
  const auto negative = raising->violations(Arguments{-100.0, 0.014, 0.004, 0.15});
  REQUIRE(negative.size() == 1);
  CHECK(negative[0] == "force = -100 N is below 0 N");
  CHECK(raising->violations(Arguments{100.0, 0.01, 0.2, 0.3}).size() == 2);
  CHECK(raising->violations(Arguments{std::nan(""), 0.01, 0.004, 0.3}).size() == 1);
}

}  // namespace formula_consistency_test
