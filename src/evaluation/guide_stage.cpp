// SPDX-License-Identifier: Apache-2.0
#include "evaluation/guide_stage.h"

#include <array>
#include <cmath>
#include <span>

#include "evaluation/figure_reader.h"
#include "machine/word_column.h"

namespace millwright::evaluation {

using catalogue::column;
using catalogue::Family;
using machine::Applies;
using machine::GuideSystem;

GuideStage::GuideStage(const machine::Axis& axis,
                       AxisPlace place,
                       const catalogue::Catalogue& catalogue,
                       const PriceBook& prices)
    : data_{.choice = *axis.guide,
            .motion = motion_of(axis),
            .require = axis.require,
            .riding_mass = machine::riding_mass_allowance(axis),
            .on_face = machine::rails_on_face(axis),
            .carried = place.carried_forces,
            .lifting_acceleration = place.lifting_acceleration},
      place_(place),
      acceleration_time_(axis.acceleration_time) {
  name_ = axis.name + ".guide";
  SlotTable table("guide", machine::guide_reading_fields);
  const catalogue::Table& t = catalogue.table(Family::linear_guides);
  const machine::GuideChoice& choice = *axis.guide;
  constexpr std::array soft_columns{column(Family::linear_guides, "friction_coefficient"),
                                    column(Family::linear_guides, "radial_stiffness")};
  const auto soft = std::span(soft_columns).first(place.tool ? 1 : 2);
  for (const int row : t.rows_in_order()) {
    const std::string_view kind = machine::word_columns::guide_kind.text(t, row);
    if (!machine::word_columns::guide_kind.takes(choice.kinds, kind)) continue;
    const bool bush = kind.find("bush") != std::string_view::npos;
    // A single bushing cannot take a moment.
    if (bush && choice.carriages < 2.0) continue;
    const auto readings_of = [&](auto figure) {
      using T = decltype(figure(column(Family::linear_guides, "size")));
      const T rail_length = axis.stroke + 2.0 * axis.require(machine::Requirement::overtravel) +
                            choice.carriage_spacing + figure(column(Family::linear_guides, "block_length"));
      // Moments of a single carriage; otherwise not read: pairs of carriages take them.
      const bool single = !(choice.carriages > 1.0);
      return std::array<T, machine::guide_reading_fields>{
          figure(column(Family::linear_guides, "dynamic_load_rating")),
          figure(column(Family::linear_guides, "static_load_rating")),
          figure(column(Family::linear_guides, "rating_distance")),
          single ? figure(column(Family::linear_guides, "roll_moment_rating")) : T(0.0),
          single ? figure(column(Family::linear_guides, "pitch_moment_rating")) : T(0.0),
          single ? figure(column(Family::linear_guides, "yaw_moment_rating")) : T(0.0),
          choice.carriages * figure(column(Family::linear_guides, "carriage_mass")),
          choice.rails * rail_length * figure(column(Family::linear_guides, "rail_mass_per_length")),
          rail_length,
          figure(column(Family::linear_guides, "maximum_rail_length")),
          bush ? figure(column(Family::linear_guides, "size")) : T(0.0),
          figure(column(Family::linear_guides, "friction_coefficient")),
          figure(column(Family::linear_guides, "radial_stiffness"))};
    };
    constexpr std::size_t carriages_field = 6, rails_field = 7, length_field = 8;
    std::vector<catalogue::Column> missing;
    const std::array<double, machine::guide_reading_fields> readings = readings_of(FigureReader(t, row, missing, soft));
    const double carriages = readings[carriages_field], rails = readings[rails_field];
    const double rail_length = readings[length_field];
    // Carriage and rail are one line: the carriages by piece, each rail cut to length.
    const double by_piece = std::isnan(t.price(row).piece) ? 0.0 : prices.line(t, row, choice.carriages, 0.0);
    const double price = by_piece + prices.cut(t, row, {{choice.rails, rail_length}});
    CandidateDraft candidate = candidate_of(
        {{"guide", Family::linear_guides, row, choice.carriages, rail_length, price, carriages + rails}}, carriages);
    if (t.has_ranges()) {
      const auto ranges = readings_of([&](catalogue::Column c) { return t.range(c, row); });
      candidate.ranges = candidate_ranges(ranges, price, ranges[carriages_field], ranges[rails_field]);
    }
    const auto needed = std::span(readings).first(machine::guide_readings_needed);
    if (!table.admits(candidate, needed, missing, place.tool ? readings.back() : 0.0)) continue;
    table.add(std::move(candidate), readings);
    unsupported_.push_back(bush);
    bushings_.push_back(bush || kind.find("round") != std::string_view::npos);
  }
  tables_.push_back(std::move(table));
  finish_slots();
  machine::guide_constraints([&](const machine::Declaration& d, auto&&, auto&&, auto&&) {
    constraint_count_ += machine::is_searched(d, axis.require);
  });
}

namespace {

/// Whether what is said of each row holds of all rows alive, of none, or of some.
Applies applies_to(std::span<const solver::Row> alive, const std::vector<bool>& said) {
  const bool first = said[alive.front()];
  for (const solver::Row row : alive)
    if (said[row] != first) return Applies::some;
  return first ? Applies::yes : Applies::no;
}

}  // namespace

template <class T>
GuideSystem<T> GuideStage::design(const Selection<T>& s) const {
  GuideSystem<T> d;
  d.data = &data_;
  std::size_t field = 0;
  visit_guide_reading(d.guide, [&](T& x) {
    x = tables_[0].template read<T>(s.rows[0], field);
    ++field;
  });
  d.unsupported_shaft = applies_to(s.rows[0], unsupported_);
  d.bushings = applies_to(s.rows[0], bushings_);
  d.carried_mass = s.inherited[place_.load_state];
  // The ramp time is the drive's to choose. The shortest one is the safe side: it accelerates hardest, and gives the
  // cycle the highest mean speed.
  d.acceleration_time = T(acceleration_time_.lower);
  d.derive();
  return d;
}

template <class T>
void GuideStage::answer(const Selection<T>& s, solver::Answer<T>& out) const {
  const GuideSystem<T> d = design(s);
  machine::guide_constraints(UtilisationVisitor<T, GuideSystem<T>>(d, s.kept, out.utilisation));
  out.resources[cost_resource] = total<T>(s, Total::price);
  out.resources[mass_resource] = total<T>(s, Total::mass);
  add_compliance(place_, d, out);
  if (place_.carriage_state) out.handed_on[*place_.carriage_state] = d.largest_load;
  out.handed_on[place_.load_state] = d.carried_mass + total<T>(s, Total::riding_mass);
  if (place_.parent_load_state)
    out.handed_on[*place_.parent_load_state] =
        s.inherited[*place_.parent_load_state] + total<T>(s, Total::standing_mass);
}

template GuideSystem<double> GuideStage::design(const Selection<double>&) const;

template class ElementStage<GuideStage>;

}  // namespace millwright::evaluation
