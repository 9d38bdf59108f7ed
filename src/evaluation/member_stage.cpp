// SPDX-License-Identifier: Apache-2.0
#include "evaluation/member_stage.h"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "evaluation/figure_reader.h"
#include "evaluation/section_figures.h"
#include "machine/word_column.h"

namespace millwright::evaluation {

using catalogue::column;
using catalogue::Family;
using machine::MemberKind;
using machine::StructureMember;

MemberStage::MemberStage(const machine::Axis& axis,
                         const machine::Member& member,
                         AxisPlace place,
                         const catalogue::Catalogue& catalogue,
                         const PriceBook& prices)
    : data_{.member = member,
            .require = axis.require,
            .riding_mass = member.rides ? 0.0 : machine::riding_mass_allowance(axis)},
      place_(place) {
  name_ = axis.name + "." + member.name;
  data_.acceleration = machine::largest_acceleration(motion_of(axis));
  data_.lifting_acceleration = place.lifting_acceleration;
  data_.climbing_acceleration = place.lifting_acceleration + machine::climbing_acceleration(motion_of(axis));
  take_material(catalogue.table(Family::materials), prices);
  if (!member.sections.empty()) {
    take_sections(catalogue, prices);
  } else {
    const auto variable = [&](const char* name, const machine::Range& range) {
      variables_.push_back({name, range.lower, range.upper});
    };
    if (member.kind == MemberKind::round_shaft) variable("diameter", member.diameter);
    if (member.kind == MemberKind::rectangular_bar) {
      variable("width", member.width);
      variable("height", member.height);
    }
    if (member.kind == MemberKind::weld) variable("leg", member.leg);
    if (member.kind == MemberKind::plate) variable("thickness", member.thickness);
  }
  finish_slots();
  machine::member_constraints([&](const machine::Declaration& d, auto&&, auto&&, auto&&) {
    constraint_count_ += machine::is_searched(d, axis.require);
  });
}

void MemberStage::take_material(const catalogue::Table& materials, const PriceBook& prices) {
  const std::string& name = data_.member.material;
  const auto found = materials.find(name);
  if (!found || found.rows.empty()) {
    missing_ = fmt::format("there is no material '{}' in the catalogues", name);
    return;
  }
  const int row = found.rows.front();
  data_.elastic_modulus = materials.number(column(Family::materials, "elastic_modulus"), row);
  data_.yield_strength = materials.number(column(Family::materials, "yield_strength"), row);
  data_.density = materials.number(column(Family::materials, "density"), row);
  const catalogue::Price price = materials.price(row);
  data_.price_per_mass = price.mass * prices.rate(price.currency);
  if (std::isnan(data_.elastic_modulus + data_.yield_strength + data_.density))
    missing_ = fmt::format("material '{}' lacks its elastic modulus, yield strength or density", name);
  else if (data_.member.sections.empty() && std::isnan(data_.price_per_mass))
    missing_ = fmt::format("material '{}' has no price per mass in a currency of the problem", name);
  data_.shear_modulus = materials.number(column(Family::materials, "shear_modulus"), row);
  const std::vector<std::string>& families = data_.member.sections;
  const bool has_its_own = families.size() == 1 && families.front() == "extrusions";
  if ((place_.tool || asks_for_twist()) && !has_its_own && missing_.empty() && std::isnan(data_.shear_modulus))
    missing_ = fmt::format(
        "material '{}' lacks its shear modulus, which {} needs", name, place_.tool ? "[tool]" : "frame_twist");
  if (data_.member.rotating && missing_.empty()) take_fatigue(materials, row);
}

bool MemberStage::asks_for_twist() const {
  return data_.member.torque > 0.0 && data_.require.known(machine::Requirement::frame_twist);
}

/// The endurance limit of steel follows from its tensile strength; of other metals it must have been measured.
void MemberStage::take_fatigue(const catalogue::Table& materials, int row) {
  data_.ultimate_strength = materials.number(column(Family::materials, "ultimate_strength"), row);
  const bool steel = materials.text(column(Family::materials, "class"), row) == "steel";
  if (!steel) data_.endurance_limit = materials.number(column(Family::materials, "endurance_limit"), row);
  if (std::isnan(data_.ultimate_strength + data_.endurance_limit))
    missing_ = fmt::format("material '{}' lacks its ultimate strength{}, which a rotating shaft needs",
                           data_.member.material,
                           steel ? "" : " or endurance limit");
}

void MemberStage::take_sections(const catalogue::Catalogue& catalogue, const PriceBook& prices) {
  const machine::Member& m = data_.member;
  SlotTable table(m.name, machine::section_reading_fields);
  const bool turned_by_tool =
      place_.tool && place_.tool->height_arm + place_.tool->across_arm + place_.tool->along_arm > 0.0;
  const bool twisted = turned_by_tool || m.torque > 0.0;
  // Beside what all need J, and for an angle of twist G, which stands behind it.
  const std::size_t needed = turned_by_tool || asks_for_twist() ? machine::section_reading_fields
                             : twisted                          ? machine::section_readings_needed + 1
                                                                : machine::section_readings_needed;
  const SectionGrade steel{data_.elastic_modulus, data_.yield_strength, data_.shear_modulus};
  // A portal frame is cut of one length: two columns and a beam.
  const bool portal = m.kind == MemberKind::portal_frame;
  const double piece = portal ? m.length + 2.0 * m.column_height : m.length;
  std::vector<CutPieces> pieces{{m.count, m.length}};
  if (portal) pieces.push_back({2.0 * m.count, m.column_height});
  const auto take = [&](Family family) {
    const catalogue::Table& t = catalogue.table(family);
    const SectionFigures figures(t);
    const catalogue::Column torsion = figures.torsion_constant, mass = figures.mass_per_length;
    for (const int row : t.rows_in_order()) {
      if (family == Family::steel_sections && !machine::word_columns::section_kind.takes(m.section_kinds, t, row))
        continue;
      const std::span<const catalogue::Column> soft(&torsion, twisted ? 0 : 1);
      std::vector<catalogue::Column> missing;
      const auto readings = figures.readings(row, steel, FigureReader(t, row, missing, soft));
      const double length = m.count * piece;
      CandidateDraft candidate = candidate_of(
          {{m.name, family, row, m.count, piece, prices.cut(t, row, pieces), t.number(mass, row) * length}}, 0.0);
      if (t.has_ranges())
        candidate.ranges =
            candidate_ranges(figures.readings(row, steel, [&](catalogue::Column c) { return t.range(c, row); }),
                             candidate.price,
                             {},
                             length * t.range(mass, row));
      if (!table.admits(candidate, std::span(readings).first(needed), missing)) continue;
      table.add(std::move(candidate), readings);
    }
  };
  for (const std::string& family : m.sections) {
    if (family == "steel_sections") take(Family::steel_sections);
    if (family == "extrusions") take(Family::extrusions);
  }
  tables_.push_back(std::move(table));
}

template <class T>
StructureMember<T> MemberStage::design(const Selection<T>& s) const {
  StructureMember<T> d;
  d.data = &data_;
  if (!tables_.empty()) {
    std::size_t field = 0;
    visit_section_reading(d.section, [&](T& x) {
      x = tables_[0].template read<T>(s.rows[0], field);
      ++field;
    });
  } else if (data_.member.kind == MemberKind::round_shaft) {
    d.diameter = s.variables[0];
  } else if (data_.member.kind == MemberKind::rectangular_bar) {
    d.width = s.variables[0];
    d.height = s.variables[1];
  } else if (data_.member.kind == MemberKind::weld) {
    d.leg = s.variables[0];
  } else if (data_.member.kind == MemberKind::plate) {
    d.thickness = s.variables[0];
  }
  d.carried_mass = s.inherited[place_.load_state];
  d.derive();
  return d;
}

template <class T>
void MemberStage::answer(const Selection<T>& s, solver::Answer<T>& out) const {
  const StructureMember<T> d = design(s);
  machine::member_constraints(UtilisationVisitor<T, StructureMember<T>>(d, s.kept, out.utilisation));
  T mass = d.mass;
  if (!tables_.empty()) {
    out.resources[cost_resource] = total<T>(s, Total::price);
    mass = total<T>(s, Total::mass);
  } else {
    out.resources[cost_resource] = d.mass * data_.price_per_mass;
  }
  out.resources[mass_resource] = mass;
  add_compliance(place_, d, out);
  if (data_.member.rides)
    out.handed_on[place_.load_state] = d.carried_mass + mass;
  else if (place_.parent_load_state)
    out.handed_on[*place_.parent_load_state] = s.inherited[*place_.parent_load_state] + mass;
}

template StructureMember<double> MemberStage::design(const Selection<double>&) const;

template class ElementStage<MemberStage>;

}  // namespace millwright::evaluation
