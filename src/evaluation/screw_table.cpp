// SPDX-License-Identifier: Apache-2.0
//
// Which screws, each with a nut that runs on it, an axis may use. Screw and nut are one candidate: a ball nut comes
// with its screw, and a lead nut fits one thread.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "evaluation/cuts.h"
#include "evaluation/drive_tables.h"
#include "evaluation/figure_reader.h"
#include "machine/screw.h"
#include "machine/word_column.h"

namespace millwright::evaluation {
namespace {

using catalogue::column;
using catalogue::Family;
using catalogue::Table;
using machine::ScrewFigures;
using machine::ScrewKind;

constexpr double steel_modulus = 206e9;  // materials, C45
constexpr double steel_shear_modulus = 79.2e9;
constexpr double steel_density = 7850.0;
constexpr double ball_screw_yield = 345e6;  // C45 core of an induction-hardened shaft; makers give no figure

template <class T>
std::vector<T> flat(const machine::ScrewReading<T>& reading) {
  std::vector<T> values;
  const auto keep = [&](const T& field) { values.push_back(field); };
  visit_screw_reading(reading, keep);
  visit_shown_screw_reading(reading, keep);
  return values;
}

machine::ScrewSite site_of(const machine::Axis& axis, ScrewKind kind) {
  return {.kind = kind,
          .stroke = axis.stroke,
          .overtravel = axis.require(machine::Requirement::overtravel),
          .end_allowance = axis.mechanism.end_allowance,
          .length = axis.mechanism.length.value_or(0.0),
          .ends = axis.mechanism.ends,
          .preload_fraction = axis.mechanism.preload_fraction,
          .permissible_axial_stress = axis.require(machine::Requirement::permissible_axial_stress),
          .load_sharing_turns = axis.require(machine::Requirement::load_sharing_turns)};
}

using scalar::Interval;

/// `ranges`: the same figures as intervals, null where they are what they are. False: something is missing, or nothing
/// so long is sold.
bool finish(ScrewTable& result,
            ScrewKind kind,
            const ScrewFigures<double>& figures,
            const ScrewFigures<Interval>* ranges,
            ScrewTable::Pair pair,
            CandidateDraft candidate) {
  const machine::ScrewSite& site = result.sites[static_cast<std::size_t>(kind)];
  const machine::ScrewReading<double> reading = screw_reading(figures, site);
  const std::vector<double> values = flat(reading);
  if (!can_be_added(candidate, std::span(values).first(machine::screw_reading_fields))) return false;
  for (PartUse& part : candidate.parts)
    if (part.slot == "screw") part.length = reading.cut_length;
  if (ranges != nullptr) {
    const machine::ScrewReading<Interval> intervals = screw_reading(*ranges, site);
    candidate.ranges = candidate_ranges(flat(intervals), candidate.price, intervals.nut_mass, intervals.screw_mass);
  }
  result.table.add(std::move(candidate), values);
  result.kinds.push_back(kind);
  result.pairs.push_back(pair);
  return true;
}

/// Pairs grow with the product of their parts: a table that moves while it grows touches twice the memory.
void reserve(std::size_t more, ScrewTable& result) {
  result.table.reserve(result.table.rows() + more, 2);
  result.kinds.reserve(result.kinds.size() + more);
  result.pairs.reserve(result.pairs.size() + more);
}

std::uint32_t next_index(const std::vector<ScrewFigures<double>>& figures) {
  return static_cast<std::uint32_t>(figures.size());
}

double supported_length(const machine::Axis& axis, double nut_length) {
  return axis.mechanism.length.value_or(axis.stroke + 2.0 * axis.require(machine::Requirement::overtravel) +
                                        nut_length);
}

/// `figure` reads a column of the row, as a number or as an interval.
template <class Figure>
auto ball_screw_figures(const Table& t, int row, const machine::Axis& axis, Figure figure) {
  using T = decltype(figure(column(Family::ball_screws, "lead")));
  ScrewFigures<T> f;
  f.nominal_diameter = figure(column(Family::ball_screws, "nominal_diameter"));
  f.root_diameter = figure(column(Family::ball_screws, "root_diameter"));
  f.mean_diameter = 0.5 * (figure(column(Family::ball_screws, "outside_diameter")) + f.root_diameter);
  constexpr catalogue::Column ball_circle = column(Family::ball_screws, "pitch_circle_diameter");
  f.ball_circle_diameter = std::isnan(t.number(ball_circle, row)) ? f.nominal_diameter : figure(ball_circle);
  f.lead = figure(column(Family::ball_screws, "lead"));
  f.pitch = f.lead;
  f.friction = axis.mechanism.ball_friction;
  f.yield_strength = ball_screw_yield;
  f.mass_per_length = figure(column(Family::ball_screws, "screw_mass_per_length"));
  f.nut_mass = figure(column(Family::ball_screws, "nut_mass"));
  f.nut_length = figure(column(Family::ball_screws, "nut_length"));
  f.lead_error_300 = figure(column(Family::ball_screws, "lead_error_per_300mm"));
  // A nut without preload has play; makers of the rolled class state up to 0.05 mm.
  f.backlash =
      t.flag(column(Family::ball_screws, "preloaded"), row).value_or(false) || axis.mechanism.preload_fraction > 0.0
          ? 0.0
          : 5e-5;
  f.dynamic_rating = figure(column(Family::ball_screws, "dynamic_load_rating"));
  f.static_rating = figure(column(Family::ball_screws, "static_load_rating"));
  const bool stiffness_known = !std::isnan(t.number(column(Family::ball_screws, "nut_stiffness"), row));
  f.nut_stiffness =
      !stiffness_matters(axis) && !stiffness_known ? T(0.0) : figure(column(Family::ball_screws, "nut_stiffness"));
  f.speed_value_limit = figure(column(Family::ball_screws, "dn_limit"));
  f.largest_length = figure(column(Family::ball_screws, "maximum_length"));
  f.elastic_modulus = steel_modulus;
  f.shear_modulus = steel_shear_modulus;
  f.density = steel_density;
  return f;
}

void add_ball_screws(const catalogue::Catalogue& catalogue,
                     const machine::Axis& axis,
                     const PriceBook& prices,
                     ScrewTable& result) {
  const Table& t = catalogue.table(Family::ball_screws);
  reserve(static_cast<std::size_t>(t.rows()), result);
  for (const int row : t.rows_in_order()) {
    std::vector<catalogue::Column> missing;
    const ScrewFigures<double> f = ball_screw_figures(t, row, axis, FigureReader(t, row, missing));
    std::optional<ScrewFigures<Interval>> ranges;
    if (t.has_ranges()) ranges = ball_screw_figures(t, row, axis, [&](catalogue::Column c) { return t.range(c, row); });
    const double cut = supported_length(axis, f.nut_length) + axis.mechanism.end_allowance;
    const double shaft_price = prices.cut(t, row, {{1.0, cut, machined_ends(axis)}});
    const double nut_price = prices.line(t, row, 1.0, 0.0);
    const bool added =
        finish(result,
               ScrewKind::ball,
               f,
               ranges ? &*ranges : nullptr,
               {next_index(result.shafts), 0},
               candidate_of({{"screw", Family::ball_screws, row, 1.0, cut, shaft_price, f.mass_per_length * cut},
                             {"nut", Family::ball_screws, row, 1.0, 0.0, nut_price, f.nut_mass}},
                            f.nut_mass));
    if (added)
      result.shafts.push_back(f);
    else if (!std::isinf(shaft_price))
      result.table.note_incomplete({{Family::ball_screws, row}, std::move(missing)});
  }
}

/// Yield strength of the material a text names ("bronze CuSn8/CuSn12"): the lowest of all materials that share a
/// designation with it.
double yield_of(const Table& materials, std::string_view text) {
  double yield = std::numeric_limits<double>::quiet_NaN();
  const auto names = [&](std::string_view word) {
    return word.size() >= 4 && word.find_first_of("0123456789-") != std::string_view::npos &&
           text.find(word) != std::string_view::npos;
  };
  for (int row = 0; row < materials.rows(); ++row) {
    std::string_view rest = materials.part_number(row);
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      const double candidate = materials.number(column(Family::materials, "yield_strength"), row);
      if (names(rest.substr(0, end)) && !(candidate >= yield)) yield = candidate;
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  return yield;
}

/// Specific wear rate [m^2/N] of a nut on steel, the upper end of what is usual for its material; NaN where nothing
/// usual is known (a bronze that runs dry).
double wear_rate_of(std::string_view material, bool greased) {
  const auto names = [&](std::string_view word) { return material.find(word) != std::string_view::npos; };
  if (names("POM")) return 1e-14;
  if (names("polymer") || names("iglidur")) return 3e-15;
  if (greased && (names("bronze") || names("brass"))) return 1e-15;
  return std::numeric_limits<double>::quiet_NaN();
}

/// What the screw says; `figure` as above.
template <class Figure>
auto lead_screw_figures(const Table& screws, int row, Figure figure) {
  using T = decltype(figure(column(Family::lead_screws, "lead")));
  ScrewFigures<T> f;
  f.nominal_diameter = figure(column(Family::lead_screws, "major_diameter"));
  f.mean_diameter = figure(column(Family::lead_screws, "pitch_diameter"));
  f.root_diameter = figure(column(Family::lead_screws, "minor_diameter"));
  f.nut_thread_diameter = f.nominal_diameter;
  f.pitch = figure(column(Family::lead_screws, "pitch"));
  f.lead = figure(column(Family::lead_screws, "lead"));
  f.flank_angle = figure(column(Family::lead_screws, "flank_half_angle"));
  const std::string_view form = screws.text(column(Family::lead_screws, "thread_form"), row);
  // Engaged depth: half the pitch, or 0.5413 pitch for the metric 60 degree thread (ISO 724).
  f.thread_depth = form.find("metric") != std::string_view::npos ? 0.541266 * f.pitch : 0.5 * f.pitch;
  f.yield_strength = figure(column(Family::lead_screws, "yield_strength"));
  f.mass_per_length = figure(column(Family::lead_screws, "screw_mass_per_length"));
  f.lead_error_300 = figure(column(Family::lead_screws, "lead_error_per_300mm"));
  f.largest_length = figure(column(Family::lead_screws, "maximum_length"));
  f.elastic_modulus = steel_modulus;
  f.shear_modulus = steel_shear_modulus;
  f.density = steel_density;
  return f;
}

/// What the nut adds.
template <class T, class Figure>
void add_nut_figures(
    ScrewFigures<T>& f, std::string_view material, const Table& materials, const machine::Axis& axis, Figure figure) {
  f.friction = axis.mechanism.thread_friction
                   ? T(*axis.mechanism.thread_friction)
                   : figure(axis.mechanism.greased ? column(Family::lead_nuts, "friction_greased")
                                                   : column(Family::lead_nuts, "friction_dry"));
  f.nut_yield_strength = yield_of(materials, material);
  f.wear_rate = axis.require.known(machine::Requirement::nut_wear_rate)
                    ? axis.require(machine::Requirement::nut_wear_rate)
                    : wear_rate_of(material, axis.mechanism.greased);
  f.nut_mass = figure(column(Family::lead_nuts, "mass"));
  f.nut_length = figure(column(Family::lead_nuts, "length"));
  f.backlash = figure(column(Family::lead_nuts, "backlash"));
  f.drag_torque = figure(column(Family::lead_nuts, "preload_drag_torque"));
  f.allowable_pressure = figure(column(Family::lead_nuts, "allowable_pressure"));
  f.pv_limit = figure(column(Family::lead_nuts, "maximum_pv"));
  f.sliding_speed_limit = figure(column(Family::lead_nuts, "maximum_sliding_speed"));
}

/// All of that from where it stands.
template <class T>
void take_nut_figures(ScrewFigures<T>& f, const ScrewFigures<T>& nut) {
  using F = ScrewFigures<T>;
  for (T F::*const figure : {&F::friction,
                             &F::nut_yield_strength,
                             &F::wear_rate,
                             &F::nut_mass,
                             &F::nut_length,
                             &F::backlash,
                             &F::drag_torque,
                             &F::allowable_pressure,
                             &F::pv_limit,
                             &F::sliding_speed_limit})
    f.*figure = nut.*figure;
}

/// The nuts that an axis may use, by what they run on: each is read once, and not for each of its screws.
class LeadNuts {
 public:
  struct Nut {
    int row;
    std::uint32_t index;            ///< among the figures of all nuts
    ScrewFigures<double> figures;   ///< its own only
    ScrewFigures<Interval> ranges;  ///< where they are asked for
    double price;
    std::vector<catalogue::Column> missing;  ///< of its figures
  };

  LeadNuts(const catalogue::Catalogue& catalogue,
           const machine::Axis& axis,
           const PriceBook& prices,
           bool with_ranges) {
    const Table& nuts = catalogue.table(Family::lead_nuts);
    const Table& materials = catalogue.table(Family::materials);
    for (const int row : nuts.rows_in_order()) {
      const std::string_view material = machine::word_columns::nut_material.text(nuts, row);
      if (!machine::word_columns::nut_material.takes(axis.mechanism.nut_materials, material)) continue;
      Nut nut{row, next_index(figures_), {}, {}, prices.line(nuts, row, 1.0, 0.0), {}};
      add_nut_figures(nut.figures, material, materials, axis, FigureReader(nuts, row, nut.missing));
      if (std::isnan(nut.figures.nut_yield_strength))
        nut.missing.push_back(column(Family::materials, "yield_strength"));
      if (with_ranges)
        add_nut_figures(nut.ranges, material, materials, axis, [&](catalogue::Column c) { return nuts.range(c, row); });
      figures_.push_back(nut.figures);
      of_screw_[nuts.text(column(Family::lead_nuts, "for_screw"), row)].push_back(std::move(nut));
    }
  }

  /// [index]
  [[nodiscard]] const std::vector<ScrewFigures<double>>& figures() const { return figures_; }

  /// Those that name the screw by its part number or by its designation, in order.
  [[nodiscard]] std::vector<const Nut*> for_screw(std::string_view part_number, std::string_view designation) const {
    std::vector<const Nut*> result;
    const auto take = [&](std::string_view name) {
      if (const auto found = of_screw_.find(name); found != of_screw_.end())
        for (const Nut& nut : found->second) result.push_back(&nut);
    };
    take(part_number);
    if (designation != part_number) take(designation);
    std::sort(result.begin(), result.end(), [](const Nut* a, const Nut* b) { return a->index < b->index; });
    return result;
  }

 private:
  std::map<std::string_view, std::vector<Nut>> of_screw_;
  std::vector<ScrewFigures<double>> figures_;
};

/// The screws that an axis may use, each with the nuts that run on it.
struct LeadScrew {
  int row;
  std::vector<const LeadNuts::Nut*> nuts;
};

std::vector<LeadScrew> lead_screws_with(const LeadNuts& nuts, const Table& screws, const machine::Axis& axis) {
  std::vector<LeadScrew> result;
  for (const int row : screws.rows_in_order())
    if (machine::word_columns::thread_form.takes(axis.mechanism.thread_forms, screws, row))
      result.push_back(
          {row, nuts.for_screw(screws.part_number(row), screws.text(column(Family::lead_screws, "designation"), row))});
  return result;
}

void add_lead_screws(const catalogue::Catalogue& catalogue,
                     const machine::Axis& axis,
                     const PriceBook& prices,
                     ScrewTable& result) {
  const Table& screws = catalogue.table(Family::lead_screws);
  const bool has_ranges = screws.has_ranges() || catalogue.table(Family::lead_nuts).has_ranges();
  const LeadNuts nuts(catalogue, axis, prices, has_ranges);
  const std::vector<LeadScrew> with_nuts = lead_screws_with(nuts, screws, axis);
  std::size_t pairs = 0;
  for (const LeadScrew& screw : with_nuts) pairs += screw.nuts.size();
  reserve(pairs, result);
  for (const LeadScrew& screw : with_nuts) {
    const int row = screw.row;
    std::vector<catalogue::Column> missing;
    const ScrewFigures<double> base = lead_screw_figures(screws, row, FigureReader(screws, row, missing));
    const std::size_t first = result.pairs.size();
    std::map<double, double> price_of_cut;  // most nuts are as long as some other one
    for (const LeadNuts::Nut* nut : screw.nuts) {
      ScrewFigures<double> f = base;
      take_nut_figures(f, nut->figures);
      std::optional<ScrewFigures<Interval>> ranges;
      if (has_ranges) {
        ranges = lead_screw_figures(screws, row, [&](catalogue::Column c) { return screws.range(c, row); });
        take_nut_figures(*ranges, nut->ranges);
      }
      const double cut = supported_length(axis, f.nut_length) + axis.mechanism.end_allowance;
      double shaft_price = std::numeric_limits<double>::quiet_NaN();
      if (!std::isnan(cut)) {  // of a nut of unknown length nothing is known
        const auto [price, is_new] = price_of_cut.try_emplace(cut);
        if (is_new) price->second = prices.cut(screws, row, {{1.0, cut, machined_ends(axis)}});
        shaft_price = price->second;
      }
      const bool added =
          finish(result,
                 ScrewKind::sliding,
                 f,
                 ranges ? &*ranges : nullptr,
                 {next_index(result.shafts), nut->index},
                 candidate_of({{"screw", Family::lead_screws, row, 1.0, cut, shaft_price, f.mass_per_length * cut},
                               {"nut", Family::lead_nuts, nut->row, 1.0, 0.0, nut->price, f.nut_mass}},
                              f.nut_mass));
      if (added || std::isinf(shaft_price)) continue;
      result.table.note_incomplete({{Family::lead_screws, row}, missing});
      result.table.note_incomplete({{Family::lead_nuts, nut->row}, nut->missing});
    }
    if (result.pairs.size() > first) result.shafts.push_back(base);
  }
  result.nuts = nuts.figures();
}

}  // namespace

machine::ScrewFigures<double> ScrewTable::figures(std::size_t row) const {
  ScrewFigures<double> result = shaft(row);
  if (kinds[row] == ScrewKind::sliding) take_nut_figures(result, nuts[pairs[row].nut]);
  return result;
}

bool stiffness_matters(const machine::Axis& axis) {
  using enum machine::Requirement;
  return axis.stiffness_counts || axis.require.known(position_error) || axis.require.known(lost_motion) ||
         axis.require.known(axial_stiffness);
}

ScrewTable screw_table(const catalogue::Catalogue& catalogue, const machine::Axis& axis, const PriceBook& prices) {
  constexpr std::size_t fields = machine::screw_reading_fields + machine::shown_screw_reading_fields;
  ScrewTable result;
  result.table = SlotTable("screw", fields);
  result.sites = {site_of(axis, ScrewKind::ball), site_of(axis, ScrewKind::sliding)};
  if (axis.mechanism.ball_screws) add_ball_screws(catalogue, axis, prices, result);
  if (axis.mechanism.lead_screws) add_lead_screws(catalogue, axis, prices, result);
  return result;
}

}  // namespace millwright::evaluation
