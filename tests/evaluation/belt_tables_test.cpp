// SPDX-License-Identifier: Apache-2.0
// Belts, drive pulleys and idlers stand in slots of their own; which of them run together is found here by looking at
// every belt with every two pulleys.
#include "evaluation/belt_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "catch.h"
#include "evaluation/design_bill.h"
#include "evaluation/machine_stages.h"
#include "evaluation/synthesis.h"
#include "evaluation/tiny_catalogue.h"

namespace belt_tables_test {

using namespace millwright;
using catalogue::Family;
using catalogue::Table;

namespace {

const char* const belt_axis = R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V"]
[[axis]]
name = "x"
direction = "horizontal"
stroke = "500 mm"
structure_mass = "2 kg"
mechanism = { kind = "belt", idler_distance = "80 mm" }
[[axis.moves]]
distance = "400 mm"
time = "1 s"
[axis.require]
overtravel = "10 mm"
)";
constexpr double span = 0.5 + 2.0 * 0.01 + 0.08;  // stroke, overtravel on either side, to the idler

/// What a belt with its pulleys is: rows of the catalogue, then what is read of the three together.
struct Triple {
  int belt = 0, drive = 0, idler = 0;
  double length = 0.0, price = 0.0, mass = 0.0, inertia = 0.0, idler_inertia = 0.0, diameter = 0.0,
         idler_diameter = 0.0;
  friend bool operator<(const Triple& a, const Triple& b) {
    return std::tie(a.belt, a.drive, a.idler) < std::tie(b.belt, b.drive, b.idler);
  }
};

std::vector<Triple> every_triple(const Table& belts, const Table& pulleys) {
  std::vector<Triple> found;
  const auto is_idler = [&](int row) { return pulleys.text("type", row) == "idler"; };
  const auto same = [&](int p, int q) {
    return pulleys.part_number(p) == pulleys.part_number(q) && pulleys.manufacturer(p) == pulleys.manufacturer(q);
  };
  for (int b = 0; b < belts.rows(); ++b)
    for (int d = 0; d < pulleys.rows(); ++d)
      for (int i = 0; i < pulleys.rows(); ++i) {
        if (is_idler(d) || (!is_idler(i) && !same(i, d))) continue;
        bool runs = true;
        for (const int p : {d, i})
          runs = runs && pulleys.text("profile", p) == belts.text("profile", b) &&
                 std::abs(pulleys.number("belt_width", p) - belts.number("width", b)) < 1e-6;
        if (!runs) continue;
        Triple t{b, d, i};
        t.diameter = pulleys.number("pitch_diameter", d);
        t.idler_diameter = pulleys.number("pitch_diameter", i);
        t.length = 2.0 * span + 0.5 * std::numbers::pi * (t.diameter + t.idler_diameter);
        t.price =
            belts.number("price_per_length", b) * t.length + pulleys.number("price", d) + pulleys.number("price", i);
        t.mass = belts.number("mass_per_length", b) * t.length + pulleys.number("mass", d) + pulleys.number("mass", i);
        t.inertia = pulleys.number("inertia", d);
        t.idler_inertia = pulleys.number("inertia", i);
        if (!std::isnan(t.length + t.price + t.mass + t.inertia + t.idler_inertia)) found.push_back(t);
      }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Triple> triples_that_fit(const evaluation::BeltDriveStage& stage) {
  using Stage = evaluation::BeltDriveStage;
  const std::vector<evaluation::SlotTable>& tables = stage.tables();
  std::vector<Triple> found;
  for (solver::Row b = 0; b < tables[Stage::belt_slot].rows(); ++b)
    for (solver::Row d = 0; d < tables[Stage::pulley_slot].rows(); ++d)
      for (solver::Row i = 0; i < tables[Stage::idler_slot].rows(); ++i) {
        const bool fits = stage.fits({}, Stage::belt_slot, b, Stage::pulley_slot, d) &&
                          stage.fits({}, Stage::idler_slot, i, Stage::belt_slot, b) &&
                          stage.fits({}, Stage::pulley_slot, d, Stage::idler_slot, i);
        const solver::Row own[]{b, d, i, 0};
        std::vector<solver::RowsAlive> rows;
        for (const solver::Row& row : own) rows.emplace_back(std::span(&row, 1));
        const std::vector<double> inherited(8, 1.0);
        const evaluation::Selection<double> selection{
            .shared = {}, .rows = rows, .inherited = inherited, .variables = {0.1}};
        const machine::BeltDrive<double> design = stage.design<double>(selection);
        // The check that judges in the end says the same.
        CHECK((design.belt.kinds == 1.0) == fits);
        if (!fits) continue;
        Triple t;
        std::size_t parts = 0;
        for (std::size_t slot = Stage::belt_slot; slot <= Stage::idler_slot; ++slot) {
          const evaluation::Candidate& candidate = tables[slot].candidate(own[slot]);
          t.price += candidate.price;
          t.mass += candidate.mass;
          for (const evaluation::PartUse& use : candidate.parts) {
            (use.slot == "belt" ? t.belt : use.slot == "pulley_drive" ? t.drive : t.idler) = use.row;
            ++parts;
          }
        }
        CHECK(parts == 3);
        t.length = design.belt.belt_length;
        t.inertia = design.belt.pulley_inertia;
        t.idler_inertia = design.belt.idler_inertia;
        t.diameter = design.belt.pitch_diameter;
        t.idler_diameter = design.belt.idler_diameter;
        found.push_back(t);
      }
  std::sort(found.begin(), found.end());
  return found;
}

/// Motors, supplies and guides of the tiny catalogue, with belts and pulleys drawn here.
catalogue::Catalogue random_parts(std::mt19937& rng, bool tolerances, const TemporaryFolder& folder) {
  const auto one_of = [&](std::initializer_list<const char*> words) {
    return std::string(*(words.begin() + static_cast<std::ptrdiff_t>(rng() % words.size())));
  };
  const auto known = [&](const std::string& text) { return rng() % 12 == 0 ? std::string() : text; };
  const char* const said = "USD,test,computed,test,high\n";
  std::string belts =
      "manufacturer,part_number,profile,pitch [mm],width [mm],allowable_tension [N],mass_per_length "
      "[kg/m],tensile_stiffness [N],minimum_pulley_teeth [1],maximum_speed [m/s],price_per_length "
      "[1/m],currency,price_basis,evidence,source,confidence\n";
  for (int n = 0; n < 6; ++n)
    belts += fmt::format("test,B{},{},2,{},180,{},60000,12,40,{},{}",
                         n,
                         one_of({"GT2", "T2"}),
                         one_of({"6", "9"}),
                         known(fmt::format("0.0{}", 1 + rng() % 5)),
                         known(fmt::format("{}", 1 + rng() % 5)),
                         said);
  std::string pulleys = fmt::format(
      "manufacturer,part_number,type,profile,pitch [mm],teeth [1],belt_width [mm],bore [mm],pitch_diameter "
      "[mm],{}inertia [g.cm2],mass [kg],price,currency,price_basis,evidence,source,confidence\n",
      tolerances ? "pitch_diameter_tolerance," : "");
  for (int n = 0; n < 14; ++n) {
    const unsigned teeth = 16 + 4 * static_cast<unsigned>(rng() % 3);
    pulleys += fmt::format("test,P{},{},{},2,{},{},{},{},{}{},{},{},{}",
                           n,
                           one_of({"pulley", "pulley", "idler"}),
                           one_of({"GT2", "T2"}),
                           teeth,
                           one_of({"6", "9"}),
                           one_of({"5", "6.35"}),
                           known(fmt::format("{:.3f}", 2.0 * teeth / std::numbers::pi)),
                           tolerances ? one_of({"0.01,", ","}) : std::string(),
                           known(fmt::format("{}", 1 + rng() % 9)),
                           known(fmt::format("0.0{}", 1 + rng() % 9)),
                           known(fmt::format("{}", 1 + rng() % 9)),
                           said);
  }
  folder.write("belts/test.csv", belts);
  folder.write("pulleys/test.csv", pulleys);
  static const TinyCatalogue tiny({}, {"belts", "pulleys"});
  return catalogue_of({tiny.path(), folder.path()});
}

}  // namespace

TEST_CASE("The belts and pulleys that fit are all that run together, and no others") {
  std::mt19937 rng(11);
  std::size_t triples = 0, twice = 0;
  for (int n = 0; n < 60; ++n) {
    const TemporaryFolder folder;
    const catalogue::Catalogue parts = random_parts(rng, n % 3 == 2, folder);
    const evaluation::MachineModel model(problem_of_text(belt_axis), parts);
    const auto& stage = *std::get<std::unique_ptr<evaluation::BeltDriveStage>>(model.entries().front().stage);
    const std::vector<Triple> expected = every_triple(parts.table(Family::belts), parts.table(Family::pulleys));
    const std::vector<Triple> found = triples_that_fit(stage);
    CAPTURE(n);
    REQUIRE(found.size() == expected.size());
    double others = 1.0;
    std::vector<std::vector<solver::Row>> rows;
    for (std::size_t slot = 0; slot < stage.tables().size(); ++slot) {
      rows.emplace_back(stage.tables()[slot].rows());
      std::iota(rows.back().begin(), rows.back().end(), solver::Row{0});
      if (slot > evaluation::BeltDriveStage::idler_slot) others *= static_cast<double>(rows.back().size());
    }
    CHECK(stage.combinations(rows) == static_cast<double>(expected.size()) * others);
    for (std::size_t k = 0; k < found.size(); ++k) {
      const Triple &a = found[k], &b = expected[k];
      REQUIRE((a.belt == b.belt && a.drive == b.drive && a.idler == b.idler));
      CHECK(a.length == Approx(b.length).epsilon(1e-12));
      CHECK(a.price == Approx(b.price).epsilon(1e-12));
      CHECK(a.mass == Approx(b.mass).epsilon(1e-12));
      CHECK(a.inertia == b.inertia);
      CHECK(a.idler_inertia == b.idler_inertia);
      CHECK(a.diameter == b.diameter);
      CHECK(a.idler_diameter == b.idler_diameter);
      twice += a.drive == a.idler;
    }
    triples += found.size();
  }
  CHECK(triples > 500);
  CHECK(twice > 100);
  CHECK(triples - twice > 200);
}

TEST_CASE("What a bill says of a belt and its pulleys is one belt with two pulleys, or none") {
  std::string text = belt_axis;
  static const TinyCatalogue tiny;
  const auto checked = [&](const std::vector<std::pair<std::string, std::string>>& parts, bool complete) {
    machine::BillOfMaterials bom;
    for (const auto& [slot, number] : parts) {
      machine::BomLine line;
      line.axis = "x";
      line.slot = slot;
      line.part_number = number;
      bom.lines.push_back(line);
    }
    return evaluation::check(problem_of_text(text), tiny.parts(), bom, complete, {});
  };
  const auto parts_of = [](const evaluation::BomCheck& result) {
    std::vector<std::string> parts;
    for (const evaluation::PartLine& part : result.design.parts)
      if (part.slot.find("pulley") != std::string::npos || part.slot == "belt") parts.push_back(part.part_number);
    return parts;
  };
  const auto says = [](const evaluation::BomCheck& result, const std::string& words) {
    return std::any_of(result.problems.begin(), result.problems.end(), [&](const evaluation::BomProblem& problem) {
      return problem.message.find(words) != std::string::npos;
    });
  };
  using Parts = std::vector<std::string>;
  SECTION("an idler, or the drive pulley once more") {
    for (const char* const idler : {"I20", "G20-5"}) {
      const auto result = checked(
          {{"belt", "GT3-9"}, {"pulley_drive", "G20-5"}, {"pulley_idle", idler}, {"motor", "M17"}, {"driver", "D2"}},
          true);
      REQUIRE(result.problems.empty());
      CHECK(parts_of(result) == Parts{"GT3-9", "G20-5", idler});
      CHECK(std::count_if(result.design.checks.begin(), result.design.checks.end(), [](const evaluation::Check& check) {
              return check.id == "F-BELT-PULLEYS" && check.verdict == evaluation::Verdict::satisfied;
            }) == 1);
    }
  }
  SECTION("what is not given is completed with what fits it") {
    CHECK(parts_of(checked({{"pulley_idle", "G20-6.35"}}, true)) == Parts{"GT3-9", "G20-6.35", "G20-6.35"});
    // The idler is cheaper than a second pulley.
    CHECK(parts_of(checked({{"motor", "M23"}}, true)) == Parts{"GT3-9", "G20-6.35", "I20"});
  }
  SECTION("a machine that cannot be built is judged with parts that run together") {
    text.replace(text.find("time = \"1 s\""), 12, "time = \"1 s\"\nforce = \"5000 N\"");
    const auto result = checked({{"pulley_idle", "G20-5"}}, true);
    REQUIRE(result.problems.empty());
    CHECK_FALSE(result.design.satisfied());
    CHECK(parts_of(result) == Parts{"GT3-9", "G20-5", "G20-5"});
  }
  SECTION("another pulley than that on the motor does not turn as an idler") {
    const auto result = checked({{"pulley_drive", "G20-5"}, {"pulley_idle", "G20-6.35"}}, true);
    CHECK(result.problems.size() == 1);
    CHECK(says(result, "'G20-5' as pulley_drive, 'G20-6.35' as pulley_idle of axis 'x': they do not run together"));
  }
  SECTION("an idler does not drive, and a motor is no idler") {
    CHECK(says(checked({{"pulley_drive", "I20"}}, true), "'I20' cannot be the pulley_drive of axis 'x'"));
    CHECK(says(checked({{"pulley_idle", "M17"}}, true), "'M17' cannot be the pulley_idle of axis 'x'"));
    CHECK(says(checked({{"pulley_idle", "I21"}}, true), "no part 'I21'"));
    const auto both = checked({{"pulley_drive", "I20"}, {"pulley_idle", "I21"}}, true);
    CHECK(both.problems.size() == 2);
    CHECK(says(both, "'I20' cannot be the pulley_drive of axis 'x'"));
    CHECK(says(both, "no part 'I21'"));
  }
  SECTION("what is missing is said") {
    const auto result = checked({{"belt", "GT3-9"}}, false);
    CHECK(says(result, "has no pulley_drive"));
    CHECK(says(result, "has no pulley_idle"));
    CHECK_FALSE(says(result, "has no belt"));
  }
}

}  // namespace belt_tables_test
