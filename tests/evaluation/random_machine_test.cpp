// SPDX-License-Identifier: Apache-2.0
// Random machines on random catalogues, read from problem files and solved as users do it, against all of their builds.
//
// What is compared, and how closely:
// - Without free dimensions cost, mass and front must be those of all builds. A ramp time moves neither cost nor mass
//   nor load (EveryBuild looks that this is so), it only decides whether a build complies. The enumeration tries it on
//   a grid, so it can miss a narrow window that the search finds; what the search finds is therefore evaluated anew and
//   must comply, and what the enumeration finds must never be better.
// - Free dimensions (diameter, thickness, height) move cost and mass. Each point of the grid is a build, so no point
//   may be better than the proved bound (but for 1e-9, the rounding of sums in another order), and the build found,
//   which is evaluated anew, is above that bound by the promised gap of 1e-6 at the most. Of a front, every point of
//   the grid must be covered to the stated tolerance.
// - Limits of cost and mass are drawn between the ends of the front; the answers then follow from the front.
// - Position errors, and fronts of cost and position error, are not enumerated: there the two methods of the search
//   must agree, which bound and compare differently.
//
// MILLWRIGHT_RANDOM_MACHINES=20000 tries more when evaluation or search have been changed;
// MILLWRIGHT_RANDOM_MACHINE=SEED looks at a single one and prints it.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

#include "catch.h"
#include "evaluation/design_bill.h"
#include "evaluation/every_build.h"
#include "evaluation/random_machine.h"
#include "evaluation/random_machine_counts.h"
#include "evaluation/synthesis.h"
#include "evaluation/unmet_checks.h"
#include "sanitized.h"

namespace random_machine_test {

using namespace millwright;
using evaluation::Design;
using evaluation::MachineModel;
using evaluation::Synthesis;
using Counts = RandomMachineCounts;
using Value = EveryBuild::Value;

namespace {

constexpr double rounding = 1e-9;
constexpr double gap = 1e-6;

std::uint64_t asked(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

bool looks_at_one() { return std::getenv("MILLWRIGHT_RANDOM_MACHINE") != nullptr; }

/// Nothing is limited in time but fronts of free dimensions, which can take long: where one is not finished in time it
/// is counted and left alone.
constexpr double no_limit = 1e9;
constexpr double front_limit = 4.0;

Synthesis solved(const MachineModel& model,
                 std::vector<std::string> objectives,
                 unsigned threads = 1,
                 double limit = no_limit) {
  evaluation::SearchOptions options;
  options.objectives = std::move(objectives);
  options.threads = threads;
  options.time_limit_seconds = limit;
  Synthesis found = evaluation::synthesise(model, options);
  if (looks_at_one())
    fmt::print("{}: {}, {} designs in {:.3f} s, {} nodes\n",
               fmt::join(options.objectives, ","),
               found.status == solver::Status::limit ? "not finished" : "finished",
               found.designs.size(),
               found.seconds,
               found.nodes);
  return found;
}

class Trial {
 public:
  Trial(std::uint64_t seed, Counts& counts)
      : draw_(seed), parts_(draw_, draw_.of<std::size_t>({2, 3, 4})), counts_(counts) {
    const RandomMachine machine(draw_);
    text_ = machine.text();
  }
  [[nodiscard]] const std::string& text() const { return text_; }

  void run() {
    std::optional<machine::Problem> problem;
    try {
      problem = problem_of_text(text_);
    } catch (const std::runtime_error& complaint) {
      ++counts_.unreadable;
      if (looks_at_one()) fmt::print("{}\n", complaint.what());
      return;
    }
    problem_ = &*problem;
    machine::Problem everything = *problem;
    // Also drivers that another one beats, and those that no supply of the problem can run; but no current that a
    // driver does not give: no check says that.
    for (machine::Axis& axis : everything.axes) axis.keep_every_driver = true;
    const MachineModel model(*problem, parts_.parts()), whole(everything, parts_.parts());
    if (!model.empty_slots().empty()) {
      ++counts_.nothing_to_choose;
      CHECK(solved(model, {"cost"}).designs.empty());
      return;
    }
    std::optional<EveryBuild> every;
    try {
      every.emplace(whole);
    } catch (const EveryBuild::TooMany&) {
      ++counts_.too_large;
      return;
    }
    ++counts_.machines;
    counts_.on_grid += every->on_grid();
    const std::vector<Value>& front = every->front();
    INFO("front of all builds: " << front.size() << ", tried " << every->tried());
    if (front.empty()) ++counts_.infeasible;
    if (looks_at_one()) {
      for (const Value& value : front) fmt::print("{:.17g} {:.17g} kg\n", value.cost, value.mass);
      for (const auto& slot : model.empty_slots()) fmt::print("{} {}: {}\n", slot.axis, slot.slot, slot.reason);
      for (const auto& unmet : evaluation::unmet_checks(model))
        fmt::print("{} {} at least {}\n", unmet.axis, unmet.id, unmet.least_utilisation);
    }
    if (front.size() > 1) ++counts_.long_fronts;
    every_ = &*every;
    const Synthesis cheapest = compare(made_for("cost", *problem), "cost", 1.0, 0.0, front);
    if (!every_->on_grid() && !cheapest.designs.empty() && cheapest.designs.front().cost <= front.front().cost)
      CHECK(cheapest.designs.front().mass <= front.front().mass * (1.0 + rounding));
    compare(made_for("mass", *problem), "mass", 0.0, 1.0, front);
    compare(model, "cost + 20*mass", 1.0, 20.0, front);
    const Synthesis all = compare_front(model, front);
    same_answers(model, cheapest, all);
    if (!cheapest.designs.empty()) check_again(cheapest.designs.front());
    if (!front.empty()) limits(front);
    compare_methods();
  }

 private:
  /// By what an axis carries its error grows, and so what a stage adds depends on what arrives: stage by stage,
  /// patiently and not, as label by label.
  void compare_methods() {
    if (every_->on_grid()) return;
    for (const machine::Axis& axis : problem_->axes)
      if (!axis.require.known(machine::Requirement::position_error)) return;
    for (const bool front : {false, true}) {
      evaluation::SearchOptions options;
      options.objectives = {"position_error"};
      if (front) options.objectives = {"cost", "position_error"};
      INFO("by " << fmt::format("{}", fmt::join(options.objectives, ", ")));
      machine::Problem counted = *problem_;
      counted.counted = machine::counted_quantities(options.objectives);
      const MachineModel model(counted, parts_.parts(), {}, {.objectives = options.objectives});
      solver::Options each = evaluation::solver_options(model, options);
      each.time_limit_seconds = front_limit;
      each.stagewise = false;
      each.labels_together = each.labels_together_for_one = 1;
      const solver::Summary expected = solver::solve(model.problem(), each);
      each.stagewise = true;
      each.patience = 0;
      for (const std::uint64_t patience : {std::uint64_t{30000}, std::uint64_t{0}}) {
        INFO("patience " << patience);
        each.stage_patience = patience;
        const solver::Summary found = solver::solve(model.problem(), each);
        if (found.status == solver::Status::limit || expected.status == solver::Status::limit) {
          ++counts_.unfinished;
          continue;
        }
        REQUIRE(found.builds.empty() == expected.builds.empty());
        if (found.builds.empty()) continue;
        const auto check_same = [&](machine::Quantity quantity, std::size_t i, double tolerance) {
          const std::size_t resource = model.compared(quantity);
          CHECK(found.builds[i].resources[resource] ==
                Approx(expected.builds[i].resources[resource]).epsilon(tolerance));
        };
        const bool exact = found.front_tolerance == 0.0 && (front || (found.gap == 0.0 && expected.gap == 0.0));
        if (!exact && !front) check_same(machine::Quantity::position_error, 0, 2.0 * gap);
        if (!exact) continue;
        ++counts_.by_both;
        REQUIRE(found.builds.size() == expected.builds.size());
        for (std::size_t i = 0; i < found.builds.size(); ++i) {
          check_same(machine::Quantity::cost, i, rounding);
          check_same(machine::Quantity::position_error, i, rounding);
        }
      }
    }
  }

  /// As the command line makes it: without what cannot be best by this objective.
  [[nodiscard]] MachineModel made_for(const std::string& objective, const machine::Problem& problem) const {
    return MachineModel(problem, parts_.parts(), {}, {.objectives = {objective}});
  }

  void limits(const std::vector<Value>& front) {
    ++counts_.limited;
    const double share = draw_.between(-0.1, 1.1);
    machine::Problem limited = *problem_;
    const auto within = [&](double least, double most) { return least + share * (most - least) + 1e-7 * most; };
    std::optional<double>& most_mass = limited.limits[machine::Quantity::mass];
    std::optional<double>& most_cost = limited.limits[machine::Quantity::cost];
    most_mass = within(front.back().mass, front.front().mass);
    if (draw_.chance(0.5)) most_cost = within(front.front().cost, front.back().cost);
    std::vector<Value> left;
    for (const Value& value : front)
      if (value.mass <= *most_mass && (!most_cost || value.cost <= *most_cost)) left.push_back(value);
    INFO("limits: " << *most_mass << " kg, " << most_cost.value_or(-1.0));
    const MachineModel model(limited, parts_.parts());
    compare(made_for("cost", limited), "cost", 1.0, 0.0, left);
    compare(made_for("mass", limited), "mass", 0.0, 1.0, left);
    if (!every_->on_grid()) compare_front(model, left);
  }

  /// The search may find what the grid of ramps or dimensions misses.
  [[nodiscard]] bool may_be_better() const { return every_->on_grid() || every_->ramps_on_grid(); }

  static void comply(const Design& design) {
    CHECK(design.satisfied());
    for (const auto& check : design.checks) {
      INFO(check.axis << " " << check.id << " " << check.utilisation);
      if (check.kind != machine::ConstraintKind::soft) CHECK(check.utilisation <= 1.0 + rounding);
    }
  }

  Synthesis compare(const MachineModel& model,
                    const std::string& objective,
                    double of_cost,
                    double of_mass,
                    const std::vector<Value>& front) {
    INFO("objective " << objective);
    Synthesis found = solved(model, {objective});
    double least = std::numeric_limits<double>::infinity();
    for (const Value& value : front) least = std::min(least, of_cost * value.cost + of_mass * value.mass);
    if (found.designs.empty()) {
      CHECK(front.empty());
      return found;
    }
    CHECK(found.status == solver::Status::optimal);
    const Design& design = found.designs.front();
    comply(design);
    const double value = of_cost * design.cost + of_mass * design.mass;
    CHECK(found.lower_bound <= least * (1.0 + rounding));
    CHECK(value <= found.lower_bound * (1.0 + 1.1 * gap));
    CHECK(value >= found.lower_bound * (1.0 - 1.1 * gap));
    if (value < least * (1.0 - 1.1 * gap)) {
      ++counts_.missed_windows;
      CHECK(may_be_better());
    }
    return found;
  }

  /// A front of which one build is known, and that is ended soon, states to what tolerance it is covered.
  void end_front(const MachineModel& model, const solver::Build& known, const std::vector<Value>& front) {
    evaluation::SearchOptions asked_for;
    asked_for.objectives = {"cost", "mass"};
    solver::Options options = evaluation::solver_options(model, asked_for);
    options.most_nodes = front.size() % 2 == 0 ? 20 : 200;
    const solver::Summary ended = solver::cover_front(model.problem(), options, std::vector{known});
    INFO("ended after " << options.most_nodes << " nodes, covered to " << ended.front_tolerance);
    if (!std::isfinite(ended.front_tolerance)) return;
    ++counts_.covered;
    std::vector<Value> builds;
    for (const solver::Build& build : ended.builds)
      builds.push_back({build.resources[options.objectives[0]], build.resources[options.objectives[1]]});
    for (const Value& value : front) {
      INFO("a build of " << value.cost << " and " << value.mass << " kg");
      CHECK(any_covers(builds, value, ended.front_tolerance + rounding));
    }
  }

  Synthesis compare_front(const MachineModel& model, const std::vector<Value>& front) {
    Synthesis found = solved(model, {"cost", "mass"}, 1, every_->on_grid() ? front_limit : no_limit);
    if (!found.builds.empty()) end_front(model, found.builds.front(), front);
    if (found.status == solver::Status::limit) {
      ++counts_.unfinished;
      return found;
    }
    for (const Design& design : found.designs) comply(design);
    if (!may_be_better()) {
      // Where [tool] reads how far a drive gives way, the search does not prove that a ramp moves nothing that is
      // handed on.
      CHECK((found.front_tolerance == 0.0 || problem_->tool));
      if (found.front_tolerance == 0.0) CHECK(found.designs.size() == front.size());
    }
    std::vector<Value> builds;
    for (const Design& design : found.designs) builds.push_back({design.cost, design.mass});
    for (const Value& value : front) {
      INFO("a build of " << value.cost << " and " << value.mass << " kg");
      CHECK(any_covers(builds, value, found.front_tolerance + rounding));
    }
    const double tolerance = 1.0 + found.front_tolerance + rounding;
    // Nothing on the front is beaten by a build by more than the tolerance.
    for (const Design& design : found.designs) {
      INFO("of the front: " << design.cost << " and " << design.mass << " kg");
      CHECK(std::none_of(front.begin(), front.end(), [&](const Value& value) {
        return (value.cost * tolerance < design.cost && value.mass <= design.mass) ||
               (value.mass * tolerance < design.mass && value.cost <= design.cost);
      }));
    }
    return found;
  }

  static void require_same(const std::vector<Design>& a, const std::vector<Design>& b) {
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      CHECK(a[i].cost == b[i].cost);
      CHECK(a[i].mass == b[i].mass);
      REQUIRE(a[i].parts.size() == b[i].parts.size());
      for (std::size_t k = 0; k < a[i].parts.size(); ++k) CHECK(a[i].parts[k].part_number == b[i].parts[k].part_number);
      REQUIRE(a[i].dimensions.size() == b[i].dimensions.size());
      for (std::size_t k = 0; k < a[i].dimensions.size(); ++k)
        CHECK(a[i].dimensions[k].value == b[i].dimensions[k].value);
    }
  }

  /// The same for two threads, and for another order of the catalogues' rows and files.
  void same_answers(const MachineModel& model, const Synthesis& cheapest, const Synthesis& all) {
    const bool exact = !every_->on_grid() && all.front_tolerance == 0.0;
    {
      INFO("two threads");
      require_same(cheapest.designs, solved(made_for("cost", *problem_), {"cost"}, 2).designs);
      if (exact) require_same(all.designs, solved(model, {"cost", "mass"}, 2).designs);
    }
    INFO("another order of the rows");
    const Synthesis cost = solved(MachineModel(*problem_, parts_.shuffled(), {}, {.objectives = {"cost"}}), {"cost"});
    require_same(cheapest.designs, cost.designs);
    CHECK(cost.nodes == cheapest.nodes);
    if (every_->on_grid()) return;
    const Synthesis both = solved(MachineModel(*problem_, parts_.shuffled()), {"cost", "mass"});
    require_same(all.designs, both.designs);
    CHECK(both.nodes == all.nodes);
  }

  /// The bill of materials of a design, checked as a user checks one.
  void check_again(const Design& design) {
    INFO("its bill of materials");
    const evaluation::BomCheck again =
        evaluation::check(*problem_, parts_.parts(), evaluation::bill_of(design), false, {});
    for (const auto& problem : again.problems) UNSCOPED_INFO(problem.message);
    REQUIRE(again.problems.empty());
    REQUIRE(again.empty_slots.empty());
    CHECK(again.design.satisfied());
    CHECK(again.design.cost == Approx(design.cost).epsilon(1e-12));
    CHECK(again.design.mass == Approx(design.mass).epsilon(1e-12));
  }

  Draw draw_;
  RandomCatalogue parts_;
  Counts& counts_;
  std::string text_;
  const machine::Problem* problem_ = nullptr;
  const EveryBuild* every_ = nullptr;
};

}  // namespace

TEST_CASE("Random machines equal all of their builds") {
  Counts counts;
  const std::uint64_t single = asked("MILLWRIGHT_RANDOM_MACHINE", 0);
  const std::uint64_t first = single > 0 ? single : asked("MILLWRIGHT_RANDOM_MACHINES_FROM", 1);
  const std::uint64_t machines = single > 0 ? 1 : asked("MILLWRIGHT_RANDOM_MACHINES", sanitized ? 6 : 40);
  for (std::uint64_t seed = first; seed < first + machines; ++seed) {
    Trial trial(seed, counts);
    if (single > 0) fmt::print("{}\n", trial.text());
    INFO("machine " << seed << "\n" << trial.text());
    const auto start = std::chrono::steady_clock::now();
    trial.run();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (machines > 1000 && seconds > 5.0) fmt::print(stderr, "machine {}: {:.1f} s\n", seed, seconds);
    if (machines > 1000 && (seed - first + 1) % 100 == 0)
      fmt::print(stderr, "{} machines, {} infeasible\n", counts.machines, counts.infeasible);
  }
  counts.print();
  if (machines < 20) return;
  // The machines are of the kinds that matter.
  CHECK(counts.infeasible * 10 >= counts.machines);
  CHECK(counts.long_fronts * 6 >= counts.machines);
  CHECK(counts.on_grid * 20 >= counts.machines);
  CHECK(counts.by_both * 10 >= counts.machines);
  CHECK(counts.covered * 5 >= counts.machines);
  CHECK((counts.unreadable + counts.too_large + counts.nothing_to_choose) * 5 <= static_cast<int>(machines));
}

// What may arrive at its supply has no end: a compliance that some drives hand on is infinite.
TEST_CASE("A machine whose labels hand on compliances without a bound equals all of its builds") {
  Counts counts;
  Trial trial(26748, counts);
  INFO(trial.text());
  trial.run();
  CHECK(counts.by_both >= 1);  // each of four comparisons has a time limit
}

}  // namespace random_machine_test
