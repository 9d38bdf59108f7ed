// SPDX-License-Identifier: Apache-2.0
// Of drivers that give a motor the same current those stay that somebody could want, whatever is asked; what is best by
// cost alone, by mass alone and by both is found here by looking at all of them.
#include "evaluation/driver_choices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "catch.h"
#include "evaluation/machine_stages.h"
#include "evaluation/two_axes.h"

namespace driver_choices_test {

using namespace millwright;
using evaluation::DriverChoices;

namespace {

struct Figures {
  double current, most_volts, price, mass;
};

const machine::Problem& problem() {
  static const machine::Problem two = two_axes(2.0);
  return two;
}

/// A catalogue of these drivers alone.
catalogue::Catalogue of_drivers(const std::vector<Figures>& drivers, const TemporaryFolder& folder) {
  std::string text =
      "manufacturer,part_number,minimum_voltage [V],maximum_voltage [V],peak_current [A],maximum_microsteps "
      "[1],closed_loop,mass [kg],price,currency,price_basis,evidence,source,confidence\n";
  for (std::size_t i = 0; i < drivers.size(); ++i)
    text += fmt::format("test,D{},9,{},{},32,no,{:.17g},{:.17g},USD,test,computed,test,high\n",
                        i,
                        drivers[i].most_volts,
                        drivers[i].current,
                        drivers[i].mass,
                        drivers[i].price);
  folder.write("drivers/test.csv", text);
  return catalogue_of({folder.path()});
}

std::set<int> kept(const catalogue::Catalogue& parts, bool cost_counts, bool mass_counts, double current) {
  machine::Axis axis = problem().axes.front();
  axis.cost_counts = cost_counts;
  axis.mass_counts = mass_counts;
  axis.require.set(machine::Requirement::driver_voltage_factor, 1.0);
  const std::vector<double> voltages{24.0, 36.0};
  const evaluation::PriceBook prices(problem(), parts);
  DriverChoices choices(parts.table(catalogue::Family::drivers), axis, voltages, prices);
  std::set<int> rows;
  for (const evaluation::Driver* driver : choices.at(current).kept) rows.insert(driver->row);
  return rows;
}

}  // namespace

TEST_CASE("At every voltage and current the cheapest, the lightest and what is between them stay where they count") {
  std::mt19937 rng(3);
  std::size_t fewer = 0, all = 0;
  for (int n = 0; n < 200; ++n) {
    std::vector<Figures> drivers;
    for (std::size_t i = 0; i < 12; ++i)
      drivers.push_back({rng() % 3 == 0 ? 2.0 : 4.0 + static_cast<double>(rng() % 2),
                         rng() % 3 == 0 ? 30.0 : 50.0,
                         10.0 + static_cast<double>(rng() % 6),
                         0.1 + 0.01 * static_cast<double>(rng() % 6)});
    const TemporaryFolder folder;
    const catalogue::Catalogue parts = of_drivers(drivers, folder);
    constexpr double asked = 4.0;
    const std::set<int> by_cost = kept(parts, true, false, asked), by_mass = kept(parts, false, true, asked),
                        by_both = kept(parts, true, true, asked);
    CAPTURE(n);
    CHECK(std::includes(by_both.begin(), by_both.end(), by_cost.begin(), by_cost.end()));
    CHECK(std::includes(by_both.begin(), by_both.end(), by_mass.begin(), by_mass.end()));
    all += by_both.size();
    fewer += by_cost.size();
    for (const double volts : {24.0, 36.0})
      for (const double current : {2.0, 4.0}) {
        std::vector<std::size_t> fit;
        for (std::size_t i = 0; i < drivers.size(); ++i)
          if (drivers[i].most_volts >= volts && std::min(drivers[i].current, asked) == current) fit.push_back(i);
        if (fit.empty()) continue;
        const auto has = [&](const std::set<int>& rows, double price, double mass) {
          return std::any_of(fit.begin(), fit.end(), [&](std::size_t i) {
            return rows.count(static_cast<int>(i)) > 0 && drivers[i].price == price && drivers[i].mass == mass;
          });
        };
        const auto price_first = [&](std::size_t a, std::size_t b) {
          return std::pair(drivers[a].price, drivers[a].mass) < std::pair(drivers[b].price, drivers[b].mass);
        };
        const auto mass_first = [&](std::size_t a, std::size_t b) {
          return std::pair(drivers[a].mass, drivers[a].price) < std::pair(drivers[b].mass, drivers[b].price);
        };
        const Figures& cheapest = drivers[*std::min_element(fit.begin(), fit.end(), price_first)];
        const Figures& lightest = drivers[*std::min_element(fit.begin(), fit.end(), mass_first)];
        CHECK(has(by_cost, cheapest.price, cheapest.mass));
        CHECK(has(by_mass, lightest.price, lightest.mass));
        for (const std::size_t i : fit)
          if (std::none_of(fit.begin(), fit.end(), [&](std::size_t k) {
                return drivers[k].price <= drivers[i].price && drivers[k].mass <= drivers[i].mass &&
                       (drivers[k].price < drivers[i].price || drivers[k].mass < drivers[i].mass);
              }))
            CHECK(has(by_both, drivers[i].price, drivers[i].mass));
      }
  }
  CHECK(3 * fewer < 2 * all);
}

TEST_CASE("Of covered drivers those stay that fewer cover than builds are asked for, with all that cover them") {
  std::mt19937 rng(5);
  std::size_t dropped = 0, covered = 0;
  for (int n = 0; n < 100; ++n) {
    std::vector<Figures> drivers;
    for (std::size_t i = 0; i < 14; ++i)
      drivers.push_back({rng() % 3 == 0 ? 2.0 : 4.0,
                         rng() % 3 == 0 ? 30.0 : 50.0,
                         10.0 + static_cast<double>(rng() % 4),
                         0.1 + 0.01 * static_cast<double>(rng() % 4)});
    const TemporaryFolder folder;
    const catalogue::Catalogue parts = of_drivers(drivers, folder);
    machine::Axis axis = problem().axes.front();
    axis.require.set(machine::Requirement::driver_voltage_factor, 1.0);
    axis.keep_covered_candidates = true;
    const std::vector<double> voltages{24.0, 36.0};
    const evaluation::PriceBook prices(problem(), parts);
    const auto covering = [&] {  // [driver]: those that cover it
      DriverChoices choices(parts.table(catalogue::Family::drivers), axis, voltages, prices);
      const DriverChoices::Choice& choice = choices.at(4.0);
      std::map<int, std::set<int>> of;
      for (std::size_t i = 0; i < choice.kept.size(); ++i) {
        std::set<int>& by = of[choice.kept[i]->row];
        for (const std::size_t k : choice.covered_by.at(i)) by.insert(choice.kept[k]->row);
      }
      return of;
    };
    const std::map<int, std::set<int>> all = covering();
    REQUIRE(all.size() == drivers.size());
    for (const std::size_t most : {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{6}, std::size_t{14}}) {
      CAPTURE(n, most);
      axis.most_covering = most;
      std::map<int, std::set<int>> expected = all;
      std::erase_if(expected, [&](const auto& driver) { return driver.second.size() >= most; });
      CHECK(covering() == expected);
      dropped += all.size() - expected.size();
      for (const auto& driver : expected) covered += driver.second.empty() ? 0 : 1;
    }
  }
  CHECK(dropped > 1000);
  CHECK(covered > 1000);
}

TEST_CASE("Cheaper by a rounding is not cheaper: the mass decides") {
  const double price = 17.5 * 1.08;  // 18.900000000000002
  REQUIRE(price > 18.9);
  const TemporaryFolder folder;
  const catalogue::Catalogue parts = of_drivers({{4.0, 50.0, 18.9, 0.2}, {4.0, 50.0, price, 0.05}}, folder);
  CHECK(kept(parts, true, false, 4.0).count(1) == 1);
  const TemporaryFolder other;
  const catalogue::Catalogue apart = of_drivers({{4.0, 50.0, 18.9, 0.2}, {4.0, 50.0, 18.91, 0.05}}, other);
  CHECK(kept(apart, true, false, 4.0) == std::set<int>{0});
  CHECK(kept(apart, false, true, 4.0) == std::set<int>{1});
  CHECK(kept(apart, true, true, 4.0) == std::set<int>{0, 1});
  CHECK_THROWS_AS(kept(apart, false, false, 4.0), std::logic_error);
}

TEST_CASE("A model made for some objectives refuses others, and gives the answers of one made for any") {
  const TinyCatalogue tiny;
  const evaluation::MachineModel any(problem(), tiny.parts());
  for (const char* objective : {"cost", "mass", "cost + 20*mass"}) {
    CAPTURE(objective);
    const evaluation::MachineModel made(problem(), tiny.parts(), {}, {.objectives = {objective}});
    evaluation::SearchOptions options;
    options.objectives = {objective};
    const auto its = evaluation::synthesise(made, options), expected = evaluation::synthesise(any, options);
    REQUIRE(its.designs.size() == 1);
    REQUIRE(expected.designs.size() == 1);
    CHECK(its.designs[0].cost == Approx(expected.designs[0].cost).epsilon(1e-9));
    CHECK(its.designs[0].mass == Approx(expected.designs[0].mass).epsilon(1e-9));
  }
  const evaluation::MachineModel cheapest(problem(), tiny.parts(), {}, {.objectives = {"cost"}});
  const evaluation::MachineModel lightest(problem(), tiny.parts(), {}, {.objectives = {"mass"}});
  evaluation::SearchOptions options;
  options.objectives = {"mass"};
  CHECK_THROWS_AS(evaluation::solver_options(cheapest, options), std::invalid_argument);
  options.objectives = {"cost"};
  CHECK_THROWS_AS(evaluation::solver_options(lightest, options), std::invalid_argument);
  // Every candidate is every one that may be among the best by what is asked.
  const evaluation::MachineModel all(problem(), tiny.parts(), {}, {.every_candidate = true, .objectives = {"cost"}});
  CHECK_NOTHROW(evaluation::solver_options(all, options));
  options.objectives = {"mass"};
  CHECK_THROWS_AS(evaluation::solver_options(all, options), std::invalid_argument);
  // A limit is read whatever the objective.
  machine::Problem limited = problem();
  limited.limits[machine::Quantity::mass] = 100.0;
  const evaluation::MachineModel both(limited, tiny.parts(), {}, {.objectives = {"cost"}});
  CHECK_NOTHROW(evaluation::solver_options(both, options));
  // A front by neither tells equals apart by neither.
  machine::Problem counting = problem();
  counting.counted = {machine::Quantity::cycle_time, machine::Quantity::energy};
  const evaluation::MachineModel front(counting, tiny.parts(), {}, {.objectives = {"cycle_time", "energy"}});
  CHECK_NOTHROW(evaluation::solver_options(front, options));
}

// A driver bears its greatest RMS current over a period of the phase current, a sine of sqrt(2) times that amplitude.
TEST_CASE("A driver gives its peak current, or the peak of its RMS current where that is less") {
  using evaluation::largest_amplitude;
  CHECK(largest_amplitude(4.7, 3.0) == Approx(3.0 * 1.41421356));  // 4.7 A for moments only
  CHECK(largest_amplitude(2.0, 5.0) == 2.0);
  CHECK(largest_amplitude(2.8, 2.0) == 2.8);   // 2.828 A, rounded down
  CHECK(largest_amplitude(2.0, 1.4) == 2.0);   // 1.980 A, rounded: the same statement
  CHECK(largest_amplitude(2.05, 1.4) < 1.98);  // not the same any more
  const double not_stated = std::numeric_limits<double>::quiet_NaN();
  CHECK(largest_amplitude(2.0, not_stated) == 2.0);
  CHECK(std::isnan(largest_amplitude(not_stated, 2.0)));
  const scalar::Interval alone = largest_amplitude(scalar::Interval(1.9, 2.1), scalar::Interval(not_stated));
  CHECK(alone.lower == 1.9);
  CHECK(alone.upper == 2.1);

  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int n = 0; n < 20000; ++n) {
    const double peak = 1.0 + 4.0 * uniform(random), rms = peak * (0.6 + 0.2 * uniform(random));
    const double peak_width = 0.05 * uniform(random), rms_width = 0.05 * uniform(random);
    const scalar::Interval bounds =
        largest_amplitude(scalar::Interval(peak, peak + peak_width), scalar::Interval(rms, rms + rms_width));
    for (int k = 0; k < 5; ++k) {
      const double amplitude =
          largest_amplitude(peak + peak_width * uniform(random), rms + rms_width * uniform(random));
      REQUIRE(bounds.lower <= amplitude);
      REQUIRE(amplitude <= bounds.upper);
    }
  }
}

TEST_CASE("No shipped motor is asked for more RMS current than its driver states") {
  const evaluation::MachineModel model(shipped_problem("lifter"), shipped_catalogue());
  const catalogue::Table& drivers = shipped_catalogue().table(catalogue::Family::drivers);
  const auto rms_column = catalogue::column(catalogue::Family::drivers, "rms_current");
  int limited = 0;
  for (const auto& entry : model.entries())
    if (const auto* drive = std::get_if<std::unique_ptr<evaluation::ScrewDriveStage>>(&entry.stage))
      for (solver::Row row = 0; row < (*drive)->motors().pairs().size(); ++row) {
        const auto& parts = (*drive)->tables()[evaluation::ScrewDriveStage::motor_slot].candidate(row).parts;
        const double rms = drivers.number(rms_column, parts[1].row);
        if (std::isnan(rms)) continue;
        const solver::RowsAlive alive{std::span(&row, 1)};
        const double current = (*drive)->motors().reading<double>(alive, 0).current;
        REQUIRE(current <= 1.011 * std::sqrt(2.0) * rms);
        limited += current == std::sqrt(2.0) * rms;
      }
  CHECK(limited > 0);
}

}  // namespace driver_choices_test
