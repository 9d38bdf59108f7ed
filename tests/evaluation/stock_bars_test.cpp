// SPDX-License-Identifier: Apache-2.0
// Machines whose screws, rails and profiles are cut from whole bars: the best builds against all builds, whose price is
// worked out from the pieces that each of them takes, by trying every way of cutting them.
#include "evaluation/stock_bars.h"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "catch.h"
#include "evaluation/best_of_all.h"
#include "evaluation/every_packing.h"
#include "evaluation/exhaustive.h"
#include "evaluation/two_axes.h"
#include "sanitized.h"

namespace stock_bars_test {

using namespace millwright;
using evaluation::Design;
using evaluation::MachineModel;
using evaluation::Synthesis;

namespace {

/// How a part is sold that is cut; lengths in mm.
struct Terms {
  double stock = 0.0;  ///< 0 = by the metre
  double loss = 0.0, cut = 0.0, end = 0.0;
};
using TermsOf = std::map<std::string, Terms>;  ///< by part number

/// Tables of the tiny catalogue once more, with these terms.
void write_terms(const TinyCatalogue& tiny, const TemporaryFolder& folder, const TermsOf& terms) {
  for (const char* family : {"lead_screws", "linear_guides", "steel_sections", "extrusions"}) {
    std::ifstream file(tiny.path() / family / "tiny.csv");
    std::string line, text;
    for (bool header = true; std::getline(file, line); header = false) {
      std::istringstream cells(line);
      std::string maker, part;
      std::getline(std::getline(cells, maker, ','), part, ',');
      const bool screw = std::string(family) == "lead_screws";
      if (header) {
        text += line + ",stock_length [mm],cutting_loss [mm],cut_price" + (screw ? ",end_machining_price\n" : "\n");
        continue;
      }
      const auto found = terms.find(part);
      const Terms of = found == terms.end() ? Terms() : found->second;
      text += fmt::format("{},{},{},{}", line, of.stock > 0.0 ? fmt::format("{}", of.stock) : "", of.loss, of.cut);
      text += screw ? fmt::format(",{}\n", of.end) : "\n";
    }
    folder.write(std::string(family) + "/tiny.csv", text);
  }
}

/// Two axes with lead screws and beams; x has rails too. `strokes` in mm.
machine::Problem bar_machine(double x_stroke, double y_stroke, double beam, const std::string& tables = {}) {
  const auto axis = [&](const char* name, const char* more, double stroke, double length, const char* guide) {
    return fmt::format(R"(
[[axis]]
name = "{}"
{}
stroke = "{} mm"
structure_mass = "6 kg"
guide_friction = 0.05
acceleration_time = "0.2 s"
mechanism = {{ kind = "screw", screw = ["lead_screws"], ends = "fixed-supported" }}
motor = {{ microsteps = 8, frame = ["NEMA23"] }}
{}
[[axis.members]]
name = "beam"
kind = "beam"
support = "supported"
length = "{} mm"
material = "steel"
sections = ["steel_sections"]
[[axis.moves]]
distance = "200 mm"
time = "10 s"
force = "40 N"
)",
                       name,
                       more,
                       stroke,
                       guide,
                       length);
  };
  return problem_of_text(
      "[currency]\nUSD = 1.0\n[supply]\nvoltage = \"24 V\"\n" + tables +
      axis("x",
           "",
           x_stroke,
           beam,
           "guide = { rails = 2, carriages = 4, carriage_spacing = \"100 mm\", rail_spacing = \"200 mm\" }") +
      axis("y", "carries = [\"x\"]", y_stroke, 1.3 * beam, ""));
}

/// How many pieces a slot takes of its length.
double count_of(std::string_view slot, double spares) { return (slot == "guide" ? 2.0 : 1.0) + spares; }

using Factors = std::map<std::string, double>;  ///< by part number: of its price, where builds are compared

double factor_of(const Factors& factors, const std::string& part) {
  return factors.count(part) > 0 ? factors.at(part) : 1.0;
}

/// What a build costs less than its lengths by the metre: less than nothing where bars are left over. With factors,
/// what it costs less where they are compared.
Discount saving(const MachineModel& model, const TermsOf& terms, double spare_screws, const Factors& factors = {}) {
  return [&model, terms, spare_screws, factors](const std::vector<std::vector<solver::Row>>& rows) {
    std::map<std::string, std::pair<std::vector<double>, double>> taken;  // lengths, price of a metre
    double saved = 0.0;
    for (std::size_t stage = 0; stage < rows.size(); ++stage)
      for (std::size_t slot = 0; slot < rows[stage].size(); ++slot)
        for (const evaluation::PartUse& use : model.candidate(stage, slot, rows[stage][slot]).parts) {
          if (!(use.length > 0.0)) continue;
          const catalogue::Table& table = model.catalogue().table(use.family);
          const std::string part(table.part_number(use.row));
          const double count = count_of(use.slot, use.slot == "screw" ? spare_screws : 0.0);
          const double usual = count_of(use.slot, 0.0) * use.length * table.price(use.row).length;
          const Terms of = terms.count(part) ? terms.at(part) : Terms();
          const double factor = factor_of(factors, part);
          // The carriages of a guide cost what they do.
          saved += usual + (1.0 - factor) * (use.price - usual);
          saved -= factor * count * (of.cut + (use.slot == "screw" ? 2.0 * of.end : 0.0));
          auto& [lengths, metre] = taken[part];
          metre = table.price(use.row).length;
          lengths.insert(lengths.end(), static_cast<std::size_t>(count), use.length);
        }
    for (const auto& [part, pieces] : taken) {
      const Terms of = terms.count(part) ? terms.at(part) : Terms();
      const auto& [lengths, metre] = pieces;
      const double factor = factor_of(factors, part);
      if (of.stock > 0.0)
        saved -= factor * 1e-3 * of.stock * metre *
                 static_cast<double>(fewest_bars(lengths, 1e-3 * of.stock, 1e-3 * of.loss));
      else
        for (const double length : lengths) saved -= factor * (length + 1e-3 * of.loss) * metre;
    }
    return saved;
  };
}

/// The lines add up to the cost, and the pieces of the bars are those of the lines.
void require_sound(const Design& design) {
  double cost = 0.0;
  std::map<std::string, double> of_lines, of_bars, paid_bars, price_of_bars;
  for (const evaluation::PartLine& part : design.parts) {
    cost += part.price;
    if (!part.from_bars) continue;
    double work = part.ends * part.end_price;
    for (const evaluation::Cut& cut : part.cuts) {
      of_lines[part.part_number] += cut.count * cut.length;
      work += cut.count * part.cut_price;
    }
    paid_bars[part.part_number] += part.length_price - work;
  }
  for (const evaluation::ShopOrder& order : design.orders) cost += order.shipping_fee + order.top_up;
  CHECK(design.cost == Approx(cost).epsilon(1e-12));
  for (const evaluation::BarPurchase& purchase : design.bars) {
    price_of_bars[purchase.part_number] += purchase.bar_price * static_cast<double>(purchase.bars.size());
    for (const evaluation::CutBar& bar : purchase.bars) {
      double used = bar.left_over + purchase.cutting_loss * (static_cast<double>(bar.pieces.size()) - 1.0);
      for (const evaluation::BarPiece& piece : bar.pieces) {
        of_bars[purchase.part_number] += piece.length;
        used += piece.length;
      }
      // The last piece needs no cut where nothing is left behind it.
      CHECK(used <= purchase.stock_length + 1e-9);
      CHECK(used >= purchase.stock_length - purchase.cutting_loss - 1e-9);
    }
  }
  for (const auto& [part, metres] : of_lines) CHECK(of_bars[part] == Approx(metres).epsilon(1e-12));
  for (const auto& [part, price] : paid_bars) CHECK(price_of_bars[part] == Approx(price).epsilon(1e-9));
  CHECK(of_bars.size() == of_lines.size());
}

TermsOf random_terms(std::mt19937& random) {
  TermsOf terms;
  for (const char* part : {"Tr10x2", "Tr16x4", "R12", "R20", "LB16", "box20", "box60"}) {
    if (random() % 4 == 0) continue;
    constexpr double stocks[] = {0.0, 800.0, 1000.0, 1200.0, 1500.0, 2000.0, 3000.0};
    Terms of;
    of.stock = stocks[random() % 7];
    of.loss = static_cast<double>(random() % 3) * 2.5;
    of.cut = 0.5 * static_cast<double>(random() % 4);
    of.end = std::string(part).rfind("Tr", 0) == 0 ? static_cast<double>(random() % 6) : 0.0;
    terms[part] = of;
  }
  return terms;
}

}  // namespace

TEST_CASE("With pieces cut from whole bars the cheapest build and the front equal those of all builds") {
  std::size_t compared = 0, changed = 0, shared = 0, fronts = 0;
  for (unsigned seed = 0; seed < (sanitized ? 4 : 14); ++seed) {
    std::mt19937 random(seed);
    const TermsOf terms = random_terms(random);
    const double dear = 1.0 + static_cast<double>(seed % 5);
    const TinyCatalogue tiny([dear](const std::string& part, PriceAndMass usual) {
      return PriceAndMass{part == "Tr10x2" || part == "R12" ? dear * usual.price : usual.price, usual.mass};
    });
    TemporaryFolder overlay;
    write_terms(tiny, overlay, terms);
    const catalogue::Catalogue sold = catalogue_of({tiny.path(), overlay.path()});
    const double spares = seed % 3 == 2 ? 1.0 : 0.0;
    const double x = 250.0 + 50.0 * (seed % 4), y = 300.0 + 30.0 * (seed % 3), beam = 400.0 + 60.0 * (seed % 4);
    const machine::Problem plain_problem = bar_machine(x, y, beam);
    const machine::Problem problem = bar_machine(x, y, beam, spares > 0.0 ? "[spares]\nscrew = 1\n" : "");
    machine::Problem everything = plain_problem;
    for (machine::Axis& axis : everything.axes) axis.keep_every_candidate = true;
    const MachineModel plain(everything, tiny.parts());
    const Exhaustive all(plain, saving(plain, terms, spares));
    const MachineModel model(problem, sold);
    INFO("machine " << seed << ", " << all.builds.size() << " compliant builds");
    const Synthesis cost = solved(model, {"cost"});
    REQUIRE(cost.designs.size() == (all.builds.empty() ? 0 : 1));
    if (all.builds.empty()) continue;
    ++compared;
    require_cheapest_of(all, cost, require_sound);
    const Synthesis front = solved(model, {"cost", "mass"});
    require_front_of(all, front, require_sound);
    if (seed % 4 == 2) require_next_best_of(all, problem, sold, 3 + seed / 4, require_sound);
    fronts += front.designs.size() > 1;
    for (const evaluation::BarPurchase& purchase : cost.designs[0].bars)
      for (const evaluation::CutBar& bar : purchase.bars)
        for (const evaluation::BarPiece& piece : bar.pieces) shared += piece.axis != bar.pieces.front().axis;
    const Synthesis without = solved(MachineModel(plain_problem, tiny.parts()), {"cost"});
    REQUIRE(without.designs.size() == 1);
    for (std::size_t i = 0; i < without.designs[0].parts.size(); ++i)
      changed += without.designs[0].parts[i].part_number != cost.designs[0].parts[i].part_number;
    if (sanitized) continue;
    require_same_costs(front, solved(model, {"cost", "mass"}, 2));
  }
  CHECK(compared >= 3);
  CHECK(changed > 0);
  CHECK(shared > 0);
  CHECK(fronts > 0);
}

TEST_CASE("With pieces cut from bars of preferred parts the best build is that of all builds") {
  std::size_t compared = 0, dearer = 0, shared = 0;
  for (unsigned seed = 0; seed < (sanitized ? 3 : 16); ++seed) {
    std::mt19937 random(500 + seed);
    const TermsOf terms = random_terms(random);
    const TinyCatalogue tiny;
    constexpr double premiums[] = {0.05, 0.5, 2.0};
    const double premium = premiums[seed % 3];
    Factors factors;
    std::string stock = "part_number,available\n";
    for (const char* part : {"Tr10x2", "Tr16x4", "R12", "R20", "box20", "box60"})
      if (random() % 3 == 0) {
        factors[part] = 1.0 / (1.0 + premium);
        stock += fmt::format("{},preferred\n", part);
      }
    if (factors.empty()) continue;
    TemporaryFolder overlay;
    write_terms(tiny, overlay, terms);
    overlay.write("stock.csv", stock);
    const catalogue::Catalogue sold = catalogue_of({tiny.path(), overlay.path()});
    machine::Problem problem =
        bar_machine(250.0 + 50.0 * (seed % 4), 300.0 + 30.0 * (seed % 3), 400.0 + 60.0 * (seed % 4));
    problem.preference = premium;
    const MachineModel plain(problem, tiny.parts());
    const Exhaustive all(plain, saving(plain, terms, 0.0, factors));
    INFO("machine " << seed << ", " << all.builds.size() << " compliant builds");
    const Synthesis best = solved(MachineModel(problem, sold), {"cost"});
    REQUIRE(best.designs.size() == (all.builds.empty() ? 0 : 1));
    if (all.builds.empty()) continue;
    ++compared;
    const Design& design = best.designs[0];
    require_sound(design);
    REQUIRE(design.preference);
    CHECK(design.preference->compared_cost == Approx(all.least(&BuildValue::cost)).epsilon(3e-6));
    for (const evaluation::BarPurchase& purchase : design.bars)
      if (factors.count(purchase.part_number) > 0)
        for (const evaluation::CutBar& bar : purchase.bars) shared += bar.pieces.size() > 1;
    problem.preference.reset();
    dearer += design.cost > solved(MachineModel(problem, sold), {"cost"}).designs[0].cost + 1e-6;
  }
  CHECK(compared >= 3);
  if (sanitized) return;
  CHECK(dearer > 0);
  CHECK(shared > 0);
}

namespace {

/// A shop that charges for an order, and how it sells parts that are cut.
struct BarShop {
  double shipping = 0.0, minimum = 0.0;
  std::map<std::string, std::pair<double, Terms>> sells;  ///< price of a metre, terms
};

/// What a build costs less where every line that is cut may come from the catalogue's seller or from the shop: all
/// ways of ordering are tried.
Discount saving_with_shop(const MachineModel& model, const TermsOf& terms, const BarShop& shop) {
  return [&model, terms, shop](const std::vector<std::vector<solver::Row>>& rows) {
    struct Line {
      std::string part, slot;
      double length = 0.0, metre = 0.0;
    };
    std::vector<Line> lines;
    double usual = 0.0;
    for (std::size_t stage = 0; stage < rows.size(); ++stage)
      for (std::size_t slot = 0; slot < rows[stage].size(); ++slot)
        for (const evaluation::PartUse& use : model.candidate(stage, slot, rows[stage][slot]).parts) {
          if (!(use.length > 0.0)) continue;
          const catalogue::Table& table = model.catalogue().table(use.family);
          lines.push_back({std::string(table.part_number(use.row)),
                           std::string(use.slot),
                           use.length,
                           table.price(use.row).length});
          usual += count_of(use.slot, 0.0) * use.length * lines.back().metre;
        }
    double least = std::numeric_limits<double>::infinity();
    for (unsigned from_shop = 0; from_shop < (1U << lines.size()); ++from_shop) {
      std::map<std::pair<bool, std::string>, std::vector<double>> pieces;
      double paid = 0.0, at_shop = 0.0;
      bool sold = true;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        const Line& line = lines[i];
        const bool there = (from_shop >> i & 1U) != 0;
        if (there && shop.sells.count(line.part) == 0) sold = false;
        if (!sold) break;
        const Terms of = there                    ? shop.sells.at(line.part).second
                         : terms.count(line.part) ? terms.at(line.part)
                                                  : Terms();
        const double metre = there ? shop.sells.at(line.part).first : line.metre;
        const double count = count_of(line.slot, 0.0);
        double own = count * (of.cut + (line.slot == "screw" ? 2.0 * of.end : 0.0));
        if (of.stock > 0.0) {
          auto& all = pieces[{there, line.part}];
          all.insert(all.end(), static_cast<std::size_t>(count), line.length);
        } else {
          own += count * (line.length + 1e-3 * of.loss) * metre;
        }
        (there ? at_shop : paid) += own;
      }
      if (!sold) continue;
      for (const auto& [from, lengths] : pieces) {
        const bool there = from.first;
        const auto part = from.second;
        const Terms of = there ? shop.sells.at(part).second : terms.at(part);
        const auto line = std::find_if(lines.begin(), lines.end(), [&](const Line& each) { return each.part == part; });
        const double metre = there ? shop.sells.at(part).first : line->metre;
        (there ? at_shop : paid) +=
            1e-3 * of.stock * metre * static_cast<double>(fewest_bars(lengths, 1e-3 * of.stock, 1e-3 * of.loss));
      }
      if (from_shop != 0) paid += shop.shipping + std::max(at_shop, shop.minimum);
      least = std::min(least, paid);
    }
    return usual - least;
  };
}

}  // namespace

TEST_CASE("Where a shop offers bars on other terms the cheapest build and order are those of all builds and orders") {
  std::size_t compared = 0, ordered = 0, mixed = 0;
  for (unsigned seed = 0; seed < (sanitized ? 3 : 16); ++seed) {
    std::mt19937 random(100 + seed);
    const TinyCatalogue tiny;
    const TermsOf terms = random_terms(random);
    BarShop shop{static_cast<double>(random() % 3) * 4.0, static_cast<double>(random() % 3) * 20.0, {}};
    const TermsOf others = random_terms(random);
    const std::map<std::string, double> usual = {{"Tr10x2", 10.0}, {"Tr16x4", 20.0}, {"box20", 4.0}, {"box60", 15.0}};
    std::string offers =
        "part_number,supplier,price_per_length [1/m],currency,stock_length [mm],cutting_loss [mm],cut_price,"
        "end_machining_price\n";
    for (const auto& [part, metre] : usual) {
      if (random() % 4 == 0) continue;
      const Terms of = others.count(part) ? others.at(part) : Terms();
      shop.sells[part] = {0.25 * metre * static_cast<double>(1 + random() % 4), of};
      const bool screw = part.rfind("Tr", 0) == 0;
      offers += fmt::format("{},Shop,{},USD,{},{},{},{}\n",
                            part,
                            shop.sells[part].first,
                            of.stock > 0.0 ? fmt::format("{}", of.stock) : "",
                            of.loss,
                            of.cut,
                            screw ? fmt::format("{}", of.end) : "");
    }
    if (shop.sells.empty()) continue;
    TemporaryFolder overlay;
    write_terms(tiny, overlay, terms);
    overlay.write(
        "suppliers.csv",
        fmt::format("supplier,shipping_fee,minimum_order,currency\nShop,{},{},USD\n", shop.shipping, shop.minimum));
    overlay.write("offers.csv", offers);
    const catalogue::Catalogue sold = catalogue_of({tiny.path(), overlay.path()});
    const machine::Problem problem = bar_machine(250.0 + 50.0 * (seed % 4), 300.0, 400.0 + 60.0 * (seed % 3));
    const MachineModel plain(problem, tiny.parts());
    const Exhaustive all(plain, saving_with_shop(plain, terms, shop));
    const MachineModel model(problem, sold);
    INFO("machine " << seed << ", " << all.builds.size() << " compliant builds");
    const Synthesis cost = solved(model, {"cost"});
    REQUIRE(cost.designs.size() == (all.builds.empty() ? 0 : 1));
    if (all.builds.empty()) continue;
    ++compared;
    require_cheapest_of(all, cost, require_sound);
    bool here = false, there = false;
    for (const evaluation::BarPurchase& purchase : cost.designs[0].bars)
      (purchase.supplier.empty() ? here : there) = true;
    ordered += there;
    mixed += here && there;
  }
  CHECK(compared >= 3);
  if (sanitized) return;  // too few are tried there
  CHECK(ordered > 0);
  CHECK(mixed > 0);
}

// Screws of some 0.4 and 0.5 m: Tr10x2 at 10 USD a metre, and Tr16x4 at 100.
TEST_CASE("Two screws come from one bar, and a row whose bar is too short for one of them is not chosen there") {
  const TinyCatalogue tiny([](const std::string& part, PriceAndMass usual) {
    return PriceAndMass{part == "Tr16x4" ? 100.0 : usual.price, usual.mass};
  });
  const machine::Problem problem = bar_machine(300.0, 400.0, 500.0);
  const auto screws = [&](const TermsOf& terms) {
    TemporaryFolder overlay;
    write_terms(tiny, overlay, terms);
    const catalogue::Catalogue sold = catalogue_of({tiny.path(), overlay.path()});
    const MachineModel model(problem, sold);
    const Synthesis found = solved(model, {"cost"});
    REQUIRE(found.designs.size() == 1);
    require_sound(found.designs[0]);
    std::vector<std::string> result;
    for (const evaluation::PartLine& part : found.designs[0].parts)
      if (part.slot == "screw") result.push_back(part.part_number);
    result.push_back(std::to_string(found.designs[0].bars.empty() ? 0 : found.designs[0].bars[0].bars.size()));
    return result;
  };
  CHECK(screws({{"Tr10x2", {2000.0}}}) == std::vector<std::string>{"Tr10x2", "Tr10x2", "1"});
  // One axis is longer than the bar.
  CHECK(screws({{"Tr10x2", {420.0}}}) == std::vector<std::string>{"Tr10x2", "Tr16x4", "1"});
  // Ends that cost 120 USD in all make the dear one the cheaper one.
  CHECK(screws({{"Tr10x2", {0.0, 0.0, 0.0, 30.0}}}) == std::vector<std::string>{"Tr16x4", "Tr16x4", "0"});
}

TEST_CASE("Where every bar is shorter than the pieces the answer says so, with both lengths") {
  const TinyCatalogue tiny;
  const machine::Problem problem = bar_machine(300.0, 400.0, 500.0);
  const auto reasons = [&](const TermsOf& terms) {
    TemporaryFolder overlay;
    write_terms(tiny, overlay, terms);
    const catalogue::Catalogue sold = catalogue_of({tiny.path(), overlay.path()});
    std::string text;
    for (const evaluation::EmptySlot& slot : solved(MachineModel(problem, sold), {"cost"}).empty_slots)
      text += slot.axis + "." + slot.slot + ": " + slot.reason + "\n";
    return text;
  };
  CHECK(reasons({{"box20", {2000.0}}, {"box60", {2000.0}}}).empty());
  // The beams are of 500 mm on x and 650 mm on y.
  const std::string beams = reasons({{"box20", {400.0}}, {"box60", {450.0}}});
  CHECK(beams.find("x.beam: what fits axis 'x' there is sold in bars of at most 450 mm (tiny box60), and the shortest "
                   "piece that it takes is 500 mm") != std::string::npos);
  CHECK(beams.find("takes is 650 mm") != std::string::npos);
  // Where one can be had, it is no reason.
  CHECK(reasons({{"box20", {400.0}}, {"box60", {700.0}}}).empty());
  const std::string screws = reasons({{"Tr10x2", {200.0}}, {"Tr16x4", {150.0}}});
  CHECK(screws.find("x.screw: what fits axis 'x' there is sold in bars of at most 200 mm (tiny Tr10x2)") !=
        std::string::npos);
  CHECK(screws.find("guide") == std::string::npos);
}

}  // namespace stock_bars_test
