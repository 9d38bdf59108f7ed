// SPDX-License-Identifier: Apache-2.0
// Compliance over stated tolerances, and the best robust build, against corners of the tolerances tried one by one: the
// judge makes the whole machine anew from a changed catalogue for each, and knows neither intervals nor directions.
#include "evaluation/tolerance_check.h"

#include <fmt/format.h>

#include "catch.h"
#include "evaluation/design_bill.h"
#include "evaluation/random_machine.h"
#include "evaluation/synthesis.h"
#include "evaluation/toleranced_catalogue.h"
#include "sanitized.h"

namespace tolerance_check_test {

using namespace millwright;
using catalogue::Catalogue;
using catalogue::Family;
using evaluation::Design;
using evaluation::MachineModel;
using evaluation::ToleranceCheck;
using evaluation::TolerancedFigure;
using evaluation::ToleranceVerdict;

namespace {

/// One upright axis on a screw with fixed ramps, so that all there is to choose is parts.
machine::Problem lift(double inertia_ratio) {
  return problem_of_text(fmt::format(R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V"]
[[axis]]
name = "z"
direction = "vertical"
stroke = "200 mm"
structure_mass = "6 kg"
guide_friction = 0.05
acceleration_time = "0.1 s"
mechanism = {{ kind = "screw", screw = ["lead_screws"], ends = "fixed-supported", greased = true }}
motor = {{ microsteps = 8 }}
guide = {{ kinds = ["profile rail"], carriages = 4, carriage_spacing = "100 mm", rail_spacing = "150 mm" }}
[[axis.moves]]
distance = "150 mm"
time = "6 s"
force = "40 N"
[axis.require]
inertia_ratio = {}
)",
                                     inertia_ratio));
}

evaluation::Synthesis solved(const machine::Problem& problem, const Catalogue& parts) {
  evaluation::SearchOptions options;
  options.tolerances = true;
  return evaluation::synthesise(MachineModel(problem, parts), options);
}

evaluation::RobustSynthesis solved_robustly(const machine::Problem& problem, const Catalogue& parts) {
  return evaluation::synthesise_robustly(problem, parts, {}, {});
}

using Values = std::vector<std::pair<std::size_t, double>>;

Catalogue with_values(const Catalogue& parts, const std::vector<TolerancedFigure>& figures, const Values& values) {
  Catalogue changed = parts;
  for (const auto& [figure, value] : values)
    changed.changeable_table(figures[figure].family).set_number(figures[figure].row, figures[figure].column, value);
  return changed;
}

/// The same build of a machine whose catalogue says these values.
Design with_values(const machine::Problem& problem,
                   const Catalogue& parts,
                   const solver::Build& build,
                   const std::vector<TolerancedFigure>& figures,
                   const Values& values) {
  return MachineModel(problem, with_values(parts, figures, values)).design(build);
}

/// Values at a corner of the tolerances: bit i says which end figure i is at.
Values corner(const std::vector<TolerancedFigure>& figures, std::uint64_t bits) {
  Values values;
  for (std::size_t i = 0; i < figures.size(); ++i)
    values.emplace_back(i, figures[i].value + ((bits >> i) % 2 == 0 ? -1.0 : 1.0) * figures[i].half_width);
  return values;
}

double utilisation_of(const Design& design, const std::string& id) {
  for (const auto& check : design.checks)
    if (check.id == id) return check.utilisation;
  throw std::runtime_error("no check " + id);
}

const TolerancedCatalogue& with_inertias(double share) {
  static std::map<double, std::unique_ptr<TolerancedCatalogue>> known;
  auto& there = known[share];
  if (!there)
    there = std::make_unique<TolerancedCatalogue>(TinyCatalogue().parts(), [share](const std::string& name, int) {
      return name == "steppers.rotor_inertia" ? share : 0.0;
    });
  return *there;
}

}  // namespace

TEST_CASE("without tolerances there is nothing to break") {
  const auto found = solved(lift(20), TinyCatalogue().parts());
  REQUIRE(found.designs.size() == 1);
  CHECK(found.designs.front().tolerances->verdict == ToleranceVerdict::none_stated);
  CHECK(found.designs.front().tolerances->figures.empty());
}

// The inertia ratio is load inertia over rotor inertia: with a rotor of (1 - t) J it is 1/(1 - t) times as large. A
// limit a tenth above the ratio of the build holds for t up to 1 - 1/1.1 = 1/11, and no further.
TEST_CASE("the inertia ratio breaks where a hand calculation says") {
  const std::string id = "C-ST-INERTIA";
  const auto first = solved(lift(1000), with_inertias(0.05).parts());
  REQUIRE(first.designs.size() == 1);
  const double ratio = 1000 * utilisation_of(first.designs.front(), id);
  const auto tight = solved(lift(1.1 * ratio), with_inertias(1.0 / 11 - 1e-6).parts());
  CHECK(tight.designs.front().tolerances->verdict == ToleranceVerdict::compliant);
  const auto loose = solved(lift(1.1 * ratio), with_inertias(0.2).parts());
  const ToleranceCheck& check = *loose.designs.front().tolerances;
  REQUIRE(check.verdict == ToleranceVerdict::broken);
  REQUIRE(check.single.size() == 1);
  CHECK_FALSE(check.combination);
  const auto& only = check.single.front();
  const TolerancedFigure& figure = check.figures[only.values.front().first];
  CHECK(catalogue::declaration(figure.column).name == "rotor_inertia");
  CHECK(figure.places == std::vector<std::string>{"z.motor"});
  CHECK(only.check == id);
  CHECK(only.values.front().second == Approx(0.8 * figure.value));
  CHECK(only.utilisation == Approx(1.0 / 1.1 / 0.8));
  CHECK(*only.from == Approx(10.0 / 11 * figure.value).epsilon(1e-3));
}

// A journal is turned from the core of the screw: a core of 5.6 mm gives none of 6 mm. With those figures the parts do
// not go together any more, which is a check that fails and nothing else.
TEST_CASE("a screw that may be too thin for its support breaks that check") {
  const TolerancedCatalogue inexact(TinyCatalogue().parts(), [](const std::string& name, int) {
    return name == "lead_screws.minor_diameter" ? 0.25 : 0.0;
  });
  const auto found = solved(lift(1000), inexact.parts());
  REQUIRE(found.designs.size() == 1);
  REQUIRE(utilisation_of(found.designs.front(), "F-SUPPORT-FIXED") > 0.75);
  const ToleranceCheck& check = *found.designs.front().tolerances;
  REQUIRE(check.verdict == ToleranceVerdict::broken);
  const Design thin =
      with_values(lift(1000), inexact.parts(), found.builds.front(), check.figures, corner(check.figures, 0));
  CHECK(utilisation_of(thin, "F-SUPPORT-FIXED") > 1.0);
}

TEST_CASE("a build that must hold for every value takes another motor") {
  const auto first = solved(lift(1000), with_inertias(0.05).parts());
  const double ratio = 1000 * utilisation_of(first.designs.front(), "C-ST-INERTIA");
  const machine::Problem problem = lift(1.1 * ratio);
  const auto robust = solved_robustly(problem, with_inertias(0.2).parts());
  CHECK(robust.best.status == solver::Status::optimal);
  REQUIRE(robust.best.designs.size() == 1);
  const Design& design = robust.best.designs.front();
  CHECK(design.tolerances->verdict == ToleranceVerdict::compliant);
  CHECK(robust.without == Approx(first.designs.front().cost));
  CHECK(design.cost > robust.without);
  CHECK(robust.scenarios == 1);
  const auto same = solved_robustly(problem, with_inertias(0.05).parts());
  CHECK(same.scenarios == 0);
  CHECK(same.best.designs.front().cost == Approx(first.designs.front().cost));
}

// A stepper's copper loss grows with the resistance of its windings, and with that the energy of a cycle: a limit is
// kept for every resistance within the tolerance where it is kept with the largest.
TEST_CASE("a limit of the energy holds for every value within the tolerances") {
  constexpr double share = 0.1;
  const auto resistances = [](double tolerance) {
    return [tolerance](const std::string& name, int) { return name == "steppers.phase_resistance" ? tolerance : 0.0; };
  };
  const TolerancedCatalogue inexact(shipped_catalogue(), resistances(share));
  catalogue::Catalogue largest = shipped_catalogue();
  catalogue::Table& steppers = largest.changeable_table(Family::steppers);
  const auto resistance = catalogue::column(Family::steppers, "phase_resistance");
  for (int row = 0; row < steppers.rows(); ++row)
    steppers.set_number(row, resistance, (1.0 + share) * steppers.number(resistance, row));

  // From where hardly any build keeps the limit to where the one that is best as stated breaks it.
  machine::Problem problem = lift(1000);
  std::optional<double>& limit = problem.limits[machine::Quantity::energy];
  limit = 20.0;
  evaluation::Synthesis stated, expected;
  const auto differ = [&] {
    return !expected.designs.empty() && stated.designs.front().cost < expected.designs.front().cost - 1e-6;
  };
  while (!differ() && *limit < 1e3) {
    limit = 1.07 * *limit;
    expected = solved(problem, largest);
    stated = solved(problem, inexact.parts());
  }
  REQUIRE(differ());
  const ToleranceCheck& check = *stated.designs.front().tolerances;
  REQUIRE(check.verdict == ToleranceVerdict::broken);
  CHECK(check.single.front().check == "C-SYS-ENERGY");
  const auto robust = solved_robustly(problem, inexact.parts());
  CHECK(robust.best.status == solver::Status::optimal);
  REQUIRE(robust.best.designs.size() == 1);
  CHECK(robust.best.designs.front().cost == Approx(expected.designs.front().cost));
  CHECK(robust.best.designs.front().tolerances->verdict == ToleranceVerdict::compliant);
}

TEST_CASE("the robust build of a whole machine is settled where all its figures may be off") {
  if (sanitized) return;  // three minutes, of code that random machines go through as well
  const TolerancedCatalogue uncertain(shipped_catalogue(), [](const std::string&, int) { return 0.03; });
  const auto robust = solved_robustly(shipped_problem("lifter"), uncertain.parts());
  CHECK(robust.best.status == solver::Status::optimal);
  REQUIRE_FALSE(robust.best.designs.empty());
  const ToleranceCheck& check = *robust.best.designs.front().tolerances;
  CHECK(check.figures.size() > 30);
  CHECK(check.verdict == ToleranceVerdict::compliant);
}

TEST_CASE("a check that is stopped, or has no time, claims nothing, and a robust search says that it is open") {
  const Catalogue& parts = with_inertias(0.2).parts();
  const machine::Problem problem = lift(1000);
  const MachineModel model(problem, parts);
  evaluation::SearchOptions options;
  const auto found = evaluation::synthesise(model, options);
  REQUIRE(found.designs.size() == 1);
  const std::atomic<bool> stop{true};
  evaluation::ToleranceEffort stopped, no_time;
  stopped.stop = &stop;
  no_time.seconds = 0.0;
  const auto asked = [&](const evaluation::ToleranceEffort& effort) {
    return evaluation::check_tolerances(model, found.builds.front(), found.designs.front(), effort);
  };
  REQUIRE(asked({}).verdict == ToleranceVerdict::compliant);
  CHECK_FALSE(asked({}).stopped);
  for (const auto& effort : {stopped, no_time}) {
    const ToleranceCheck check = asked(effort);
    CHECK(check.verdict == ToleranceVerdict::unsettled);
    CHECK(check.stopped);
    CHECK(check.boxes == 0);
    CHECK(check.evaluations == 0);
    CHECK_FALSE(check.figures.empty());
  }
  options.tolerances = true;
  options.time_limit_seconds = 0.0;
  for (const Design& design : evaluation::synthesise(model, options).designs) {
    REQUIRE(design.tolerances);
    CHECK(design.tolerances->stopped);
  }
}

TEST_CASE("a search that was stopped asks its build no more, and claims nothing of it") {
  // To prove what takes the router the least energy takes far longer than to find a build; every rotor has a tolerance.
  const TolerancedCatalogue inexact(
      shipped_catalogue(), [](const std::string& name, int) { return name == "steppers.rotor_inertia" ? 0.01 : 0.0; });
  machine::Problem problem = shipped_problem("router");
  problem.objective = "energy";
  problem.counted = machine::counted_quantities({problem.objective});
  const MachineModel model(problem, inexact.parts());
  std::atomic<bool> stop{false};
  evaluation::SearchOptions options;
  options.objectives = {"energy"};
  options.tolerances = true;
  options.stop = &stop;
  options.progress = [&](const solver::Progress& progress) { stop = stop || std::isfinite(progress.incumbent); };
  const auto found = evaluation::synthesise(model, options);
  REQUIRE(stop);
  CHECK(found.status == solver::Status::limit);
  REQUIRE(found.designs.size() == 1);
  REQUIRE(found.designs.front().tolerances);
  CHECK(found.designs.front().tolerances->verdict == ToleranceVerdict::unsettled);
  CHECK(found.designs.front().tolerances->stopped);
  if (sanitized) return;  // the same search again
  const auto robust = evaluation::synthesise_robustly(problem, inexact.parts(), {}, options);
  CHECK(robust.best.status == solver::Status::limit);
}

// With a rotor of a tenth the ratio is ten times as large: where nothing keeps a tenth of the limit with the rotors as
// stated, nothing keeps the limit with tolerances of 90 %.
TEST_CASE("where no part holds for every value nothing does") {
  const Catalogue& parts = with_inertias(0.9).parts();
  double least = 100.0;
  while (!solved(lift(least), parts).designs.empty()) least /= 1.5;
  REQUIRE(least < 50.0);
  REQUIRE(solved(lift(5.0 * least), parts).designs.size() == 1);
  const auto robust = solved_robustly(lift(5.0 * least), parts);
  CHECK(robust.best.designs.empty());
  CHECK(robust.best.status == solver::Status::infeasible);
  CHECK(robust.scenarios > 0);
}

namespace {

struct Counts {
  int compliant = 0, broken = 0, combined = 0, unsettled = 0, robust = 0, dearer = 0, nothing = 0;
};

/// A random machine whose ramps are fixed, with tolerances of some figures.
class Trial {
 public:
  Trial(std::uint64_t seed, Counts& counts) : draw_(seed), counts_(counts) {
    const RandomCatalogue drawn(draw_, draw_.of<std::size_t>({2, 3}));
    const double share = draw_.of({0.05, 0.15, 0.3});
    parts_.emplace(drawn.parts(), [&](const std::string& name, int) {
      static const std::vector<std::string> may = {"steppers.rotor_inertia",
                                                   "steppers.holding_torque",
                                                   "steppers.mass",
                                                   "linear_guides.carriage_mass",
                                                   "lead_nuts.friction_greased",
                                                   "couplings.inertia",
                                                   "linear_guides.dynamic_load_rating",
                                                   "power_supplies.power",
                                                   "belts.mass_per_length",
                                                   "pulleys.pitch_diameter",
                                                   "pulleys.inertia",
                                                   "ball_screws.root_diameter",
                                                   "steppers.phase_inductance",
                                                   "stepper_curves.torque"};
      return std::find(may.begin(), may.end(), name) != may.end() && draw_.chance(0.4) ? share : 0.0;
    });
    text_ = RandomMachine(draw_).text();
  }
  [[nodiscard]] const std::string& text() const { return text_; }

  void run() {
    try {
      problem_ = problem_of_text(text_);
    } catch (const std::runtime_error&) {
      return;
    }
    const auto found = solved(problem_, parts_->parts());
    if (found.designs.empty()) return;
    judge(found.builds.front(), found.designs.front());
    judge_robust(found.designs.front().cost);
  }

 private:
  Design at(const solver::Build& build, const ToleranceCheck& check, const Values& values) const {
    return with_values(problem_, parts_->parts(), build, check.figures, values);
  }

  /// The parts and dimensions of a design judged with these values: which rows they are hangs on what a model was
  /// asked.
  bool holds(const Design& design, const Values& values) const {
    const Catalogue changed = with_values(parts_->parts(), design.tolerances->figures, values);
    machine::BillOfMaterials bill = evaluation::bill_of(design);
    for (machine::BomLine& line : bill.lines) line.length.reset();  // what is cut takes what the values make of it
    const evaluation::BomCheck judged = evaluation::check(problem_, changed, bill, false, {});
    for (const auto& problem : judged.problems) UNSCOPED_INFO(problem.message);
    REQUIRE(judged.problems.empty());
    REQUIRE_FALSE(judged.completed);
    return judged.design.satisfied();
  }

  /// A corner or, if there are too many, some of them, and values in between.
  bool some_break(const Design& design) {
    const ToleranceCheck& check = *design.tolerances;
    const std::size_t figures = check.figures.size();
    const std::uint64_t all = figures < 6 ? std::uint64_t{1} << figures : 64;
    for (std::uint64_t i = 0; i < all; ++i) {
      const std::uint64_t bits = figures < 6 ? i : draw_.below(std::size_t{1} << 40U);
      if (!holds(design, corner(check.figures, bits))) return true;
      Values values;
      for (std::size_t k = 0; k < figures; ++k)
        values.emplace_back(k, check.figures[k].value + draw_.between(-1.0, 1.0) * check.figures[k].half_width);
      if (i < 16 && !holds(design, values)) return true;
    }
    return false;
  }

  void within(const ToleranceCheck& check, const Values& values) {
    for (const auto& [figure, value] : values)
      CHECK(std::abs(value - check.figures[figure].value) <= check.figures[figure].half_width * (1.0 + 1e-12));
  }

  void judge(const solver::Build& build, const Design& design) {
    const ToleranceCheck& check = *design.tolerances;
    switch (check.verdict) {
      case ToleranceVerdict::none_stated:
      case ToleranceVerdict::not_asked:
        CHECK(check.figures.empty());
        return;
      case ToleranceVerdict::unsettled:
        ++counts_.unsettled;
        return;
      case ToleranceVerdict::compliant:
        ++counts_.compliant;
        CHECK_FALSE(some_break(design));
        return;
      case ToleranceVerdict::broken:
        break;
    }
    ++counts_.broken;
    for (const auto& each : check.single) {
      within(check, each.values);
      REQUIRE(each.values.size() == 1);
      const Design broken = at(build, check, each.values);
      CHECK_FALSE(broken.satisfied());
      const std::size_t figure = each.values.front().first;
      CHECK_FALSE(at(build, check, {{figure, *each.from}}).satisfied());
    }
    if (!check.combination) return;
    ++counts_.combined;
    within(check, check.combination->values);
    CHECK_FALSE(at(build, check, check.combination->values).satisfied());
  }

  void judge_robust(double nominal_cost) {
    const auto robust = solved_robustly(problem_, parts_->parts());
    if (robust.best.designs.empty()) {
      ++counts_.nothing;
      CHECK(robust.best.status == solver::Status::infeasible);
      return;
    }
    if (robust.best.status == solver::Status::limit) {
      ++counts_.unsettled;
      return;
    }
    ++counts_.robust;
    const Design& design = robust.best.designs.front();
    CHECK(design.satisfied());
    CHECK(design.cost >= nominal_cost * (1.0 - 1e-5));
    counts_.dearer += design.cost > nominal_cost * (1.0 + 1e-5);
    CHECK_FALSE(some_break(design));
  }

  Draw draw_;
  Counts& counts_;
  std::optional<TolerancedCatalogue> parts_;
  machine::Problem problem_;
  std::string text_;
};

}  // namespace

TEST_CASE("verdicts on random machines stand the trial of corners") {
  Counts counts;
  const char* asked = std::getenv("MILLWRIGHT_TOLERANCE_TRIALS");
  const std::uint64_t trials = asked != nullptr ? std::strtoull(asked, nullptr, 10) : sanitized ? 6 : 40;
  for (std::uint64_t seed = 1; seed <= trials; ++seed) {
    Trial trial(seed, counts);
    INFO("seed " << seed << "\n" << trial.text());
    trial.run();
  }
  INFO(fmt::format("{} compliant, {} broken ({} together), {} unsettled; robust {} ({} dearer), {} nothing",
                   counts.compliant,
                   counts.broken,
                   counts.combined,
                   counts.unsettled,
                   counts.robust,
                   counts.dearer,
                   counts.nothing));
  if (asked != nullptr) WARN("tried");
  CHECK(counts.compliant > 0);
  if (!sanitized) CHECK(counts.broken > 0);  // the few tried there may all be compliant
  CHECK(counts.unsettled <= static_cast<int>(trials) / 10);
}

namespace {

struct CostAndMass {
  double cost = 0.0, mass = 0.0;
};

/// The builds that no corner breaks and none of them beats in cost and mass: every combination of rows, cheapest first.
std::vector<CostAndMass> robust_front(const machine::Problem& problem,
                                      const Catalogue& parts,
                                      bool only_first = false) {
  machine::Problem everything = problem;
  for (machine::Axis& axis : everything.axes) axis.keep_every_candidate = true;
  const MachineModel model(everything, parts);
  struct Found {
    CostAndMass total;
    solver::Build build;
  };
  std::vector<Found> found;
  const solver::Problem& whole = model.problem();
  const std::function<void(std::size_t, solver::Build, std::vector<double>, CostAndMass)> extend =
      [&](std::size_t stage, solver::Build build, std::vector<double> state, CostAndMass total) {
        if (stage == whole.stages.size()) {
          found.push_back({total, std::move(build)});
          return;
        }
        const auto slots = whole.stages[stage]->slots();
        for (const solver::Slot& slot : slots)
          if (slot.rows == 0) return;
        std::vector<solver::Row> rows(slots.size(), 0);
        for (;;) {
          solver::Answer<double> answer;
          whole.stages[stage]->evaluate({build.shared, state, rows, {}}, answer);
          const bool good =
              std::all_of(answer.utilisation.begin(), answer.utilisation.end(), [](double u) { return u <= 1.0; });
          if (good) {
            solver::Build longer = build;
            longer.stages.push_back({rows, {}, state});
            extend(stage + 1,
                   longer,
                   answer.handed_on,
                   {total.cost + answer.resources[0], total.mass + answer.resources[1]});
          }
          std::size_t slot = 0;
          while (slot < rows.size() && ++rows[slot] == slots[slot].rows) rows[slot++] = 0;
          if (slot == rows.size()) return;
        }
      };
  extend(0, {.shared = {0}, .stages = {}, .resources = {}}, whole.first_state, {});
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    const double rounding = 1e-9 * a.total.cost;
    return std::abs(a.total.cost - b.total.cost) > rounding ? a.total.cost < b.total.cost : a.total.mass < b.total.mass;
  });
  std::vector<CostAndMass> front;
  for (const Found& each : found) {
    if (!front.empty() && (only_first || each.total.mass > front.back().mass * (1.0 - 1e-9))) continue;
    std::vector<TolerancedFigure> figures;
    for (std::size_t stage = 0; stage < each.build.stages.size(); ++stage)
      for (std::size_t slot = 0; slot < each.build.stages[stage].rows.size(); ++slot)
        for (const auto& use : model.candidate(stage, slot, each.build.stages[stage].rows[slot]).parts)
          for (std::size_t index = 0; index < catalogue::column_count(use.family); ++index) {
            const catalogue::Column column{use.family, static_cast<std::uint8_t>(index)};
            const catalogue::Table& table = parts.table(use.family);
            const double half = table.half_width(use.row, column);
            if (half > 0.0)
              figures.push_back(
                  {use.family, use.row, {use.row}, column, {}, {}, table.number(column, use.row), half, {}, {}});
          }
    bool holds = true;
    for (std::uint64_t bits = 0; holds && bits < (std::uint64_t{1} << figures.size()); ++bits)
      holds = with_values(everything, parts, each.build, figures, corner(figures, bits)).satisfied();
    if (holds) front.push_back(each.total);
  }
  return front;
}

/// The cheapest build that no corner breaks.
std::optional<double> cheapest_robust(const machine::Problem& problem, const Catalogue& parts) {
  const auto front = robust_front(problem, parts, true);
  return front.empty() ? std::nullopt : std::optional(front.front().cost);
}

/// A random machine whose figures are off by one share or another, for the upright axis.
Catalogue random_parts(Draw& draw, std::vector<std::unique_ptr<TolerancedCatalogue>>& kept) {
  const RandomCatalogue drawn(draw, 3);
  const double share = draw.of({0.1, 0.25, 0.4});
  kept.push_back(std::make_unique<TolerancedCatalogue>(drawn.parts(), [&](const std::string& name, int) {
    const bool may = name == "steppers.rotor_inertia" || name == "steppers.holding_torque" ||
                     name == "lead_nuts.friction_greased" || name == "linear_guides.carriage_mass";
    return may && draw.chance(0.8) ? share : 0.0;
  }));
  return kept.back()->parts();
}

}  // namespace

TEST_CASE("the best robust build is the cheapest that no corner breaks") {
  int robust = 0, dearer = 0;
  for (std::uint64_t seed = 1; seed <= (sanitized ? 6U : 40U); ++seed) {
    Draw draw(seed);
    const RandomCatalogue drawn(draw, 3);
    const double share = draw.of({0.1, 0.25, 0.4});
    const TolerancedCatalogue parts(drawn.parts(), [&](const std::string& name, int) {
      const bool may = name == "steppers.rotor_inertia" || name == "steppers.holding_torque" ||
                       name == "lead_nuts.friction_greased" || name == "linear_guides.carriage_mass";
      return may && draw.chance(0.8) ? share : 0.0;
    });
    const machine::Problem problem = lift(draw.scale(0.3, 10.0));
    const auto found = solved_robustly(problem, parts.parts());
    const auto cheapest = cheapest_robust(problem, parts.parts());
    INFO("seed " << seed << ", scenarios " << found.scenarios);
    REQUIRE(found.best.status != solver::Status::limit);
    REQUIRE(found.best.designs.empty() == !cheapest.has_value());
    if (!cheapest) continue;
    ++robust;
    CHECK(found.best.designs.front().cost == Approx(*cheapest).epsilon(2e-6));
    dearer += found.scenarios > 0 && found.best.designs.front().cost > found.without * (1.0 + 1e-5);
  }
  CHECK(robust > 0);
  if (!sanitized) CHECK(dearer > 0);
}

TEST_CASE("the front of robust builds is that of all builds that no corner breaks") {
  int fronts = 0, longer = 0, other = 0, open = 0;
  std::vector<std::unique_ptr<TolerancedCatalogue>> kept;
  for (std::uint64_t seed = 101; seed <= (sanitized ? 104U : 130U); ++seed) {
    Draw draw(seed);
    const Catalogue parts = random_parts(draw, kept);
    const machine::Problem problem = lift(draw.scale(0.3, 10.0));
    evaluation::SearchOptions options;
    options.objectives = {"cost", "mass"};
    const auto found = evaluation::synthesise_robustly(problem, parts, {}, options);
    INFO("seed " << seed << ", scenarios " << found.scenarios);
    if (found.best.status == solver::Status::limit) {  // a build of it is unsettled
      ++open;
      continue;
    }
    const auto expected = robust_front(problem, parts);
    REQUIRE(found.best.designs.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const Design& design = found.best.designs[i];
      CHECK(design.cost == Approx(expected[i].cost).epsilon(1e-9));
      CHECK(design.mass == Approx(expected[i].mass).epsilon(1e-9));
      REQUIRE(design.tolerances);
      CHECK(design.tolerances->verdict != ToleranceVerdict::broken);
    }
    ++fronts;
    longer += expected.size() > 1;
    other += found.scenarios > 0 && !expected.empty();
  }
  INFO(fmt::format("{} fronts, {} of several builds, {} that values changed", fronts, longer, other));
  CHECK(fronts > 0);
  CHECK(open <= 3);
  if (sanitized) return;
  CHECK(longer > 0);
  CHECK(other > 0);
}

}  // namespace tolerance_check_test
