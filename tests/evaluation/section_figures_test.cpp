// SPDX-License-Identifier: Apache-2.0
// Catalogue sections that are not the same on both sides: angles and channels, against tables of EN 10056-1 and DIN
// 1026-1 and against unsymmetric bending worked by hand.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "evaluation/machines.h"
#include "evaluation/section_figures.h"
#include "machine/member_constraints.h"

namespace section_figures_test {

using namespace millwright;
using catalogue::Family;
using machine::StructureMember;

namespace {

machine::SectionReading<double> section_of(const std::string& part_number, Family family = Family::steel_sections) {
  const catalogue::Table& table = shipped_catalogue().table(family);
  const auto found = table.find(part_number);
  REQUIRE(found.rows.size() == 1);
  const int row = found.rows.front();
  const evaluation::SectionGrade grade{206e9, 235e6, 79e9};
  const auto readings =
      evaluation::SectionFigures(table).readings(row, grade, [&](catalogue::Column c) { return table.number(c, row); });
  machine::SectionReading<double> section;
  std::size_t field = 0;
  machine::visit_section_reading(section, [&](double& x) {
    x = readings.at(field);
    ++field;
  });
  return section;
}

/// A steel member of 1 m with this section and load.
StructureMember<double> member_of(machine::MemberData& data, machine::MemberKind kind, const std::string& part_number) {
  data.member.kind = kind;
  data.member.length = 1.0;
  data.member.extra_force = 100.0;
  data.elastic_modulus = 206e9;
  data.yield_strength = 235e6;
  StructureMember<double> member;
  member.data = &data;
  member.section = section_of(part_number);
  member.section.mass_per_length = 0.0;
  member.derive();
  return member;
}

}  // namespace

// item 5 40x20 is of EN AW-6060 T66: 70 GPa, 195 MPa; Poisson's ratio 0.33.
TEST_CASE("A steel section is of the grade of its member, an extrusion of its own alloy") {
  const auto steel = section_of("UPN 80");
  CHECK(steel.elastic_modulus == 206e9);
  CHECK(steel.yield_strength == 235e6);
  CHECK(steel.shear_modulus == 79e9);
  const auto extruded = section_of("Profile 5 40x20", Family::extrusions);
  CHECK(extruded.elastic_modulus == Approx(70e9));
  CHECK(extruded.yield_strength == Approx(195e6));
  CHECK(extruded.shear_modulus == Approx(70e9 / (2.0 * 1.33)));
}

TEST_CASE("An angle buckles about its weak principal axis") {
  // I_v of the tables [mm^4].
  const std::pair<const char*, double> tabulated[] = {
      {"L25x25x3", 3340}, {"L30x30x3", 5850}, {"L40x40x4", 18600}, {"L50x50x5", 45500}, {"L80x80x8", 299000}};
  for (const auto& [part_number, least] : tabulated) {
    INFO(part_number);
    CHECK(section_of(part_number).least_second_moment == Approx(least * 1e-12).epsilon(0.03));
  }
  // Of others the smaller of the two.
  CHECK(section_of("UPN 80").least_second_moment == Approx(194000e-12));
  CHECK(section_of("FL 40x5").least_second_moment == Approx(417e-12));
  CHECK(section_of("SHS 40x40x2").least_second_moment == Approx(69402e-12));
}

TEST_CASE("A column of an angle is permitted a third of what buckles it") {
  machine::MemberData data;
  const auto column = member_of(data, machine::MemberKind::column, "L20x20x3");
  CHECK(column.axial_force == Approx(100.0));
  double permitted = 0.0;
  machine::member_constraints([&](const machine::Declaration& d, auto&&, auto&&, auto&& limit) {
    if constexpr (std::is_same_v<decltype(limit(column)), double>)
      if (d.id == std::string("C-FR-BUCK")) permitted = limit(column);
  });
  // Euler, slenderness 1 m / sqrt(1600/112) mm = 264; pinned at both ends.
  constexpr double pi = 3.14159265358979323846;
  CHECK(permitted == Approx(pi * pi * 206e9 * 0.41 * 3900e-12 / 3.0));
}

TEST_CASE("An angle bends askew") {
  // L100x100x10 with 100 N in the middle of 1 m: unsymmetric bending about the principal axes at 45 degrees, with the
  // tabulated I_u 2.80e6, I_v 0.733e6 mm^4 and the centroid 28.2 mm from the back of a leg.
  machine::MemberData data;
  const auto beam = member_of(data, machine::MemberKind::section_beam, "L100x100x10");
  const double M = 25.0, a = 0.1, t = 0.01, e = 0.0282, Iu = 2.80e-6, Iv = 0.733e-6, half = std::sqrt(0.5);
  // At (x, y) from the centroid, legs along x and y, load along y.
  const auto stress_at = [&](double x, double y) { return M * half * (half * (x + y) / Iv + half * (y - x) / Iu); };
  const double stress = std::max(stress_at(-e, a - e), stress_at(t - e, a - e));
  CHECK(beam.stress >= stress);
  CHECK(beam.stress < 1.05 * stress);
  const double per_moment = 100.0 / (48.0 * 206e9);
  const double along = 0.5 * per_moment * (1.0 / Iv + 1.0 / Iu), aside = 0.5 * per_moment * (1.0 / Iv - 1.0 / Iu);
  CHECK(beam.deflection >= std::hypot(along, aside));
  CHECK(beam.deflection < 1.5 * std::hypot(along, aside));
  // Loads along both legs may act across the weak principal axis.
  machine::MemberData both_data;
  both_data.member.lateral_force = 100.0;
  const auto both = member_of(both_data, machine::MemberKind::section_beam, "L100x100x10");
  CHECK(both.deflection >= std::sqrt(2.0) * per_moment / Iv);
  CHECK(both.deflection < 1.05 * std::sqrt(2.0) * per_moment / Iv);
}

TEST_CASE("The outermost fibre of a channel pushed sideways is not half its width away") {
  machine::MemberData data;
  data.member.lateral_force = 50.0;
  const auto beam = member_of(data, machine::MemberKind::section_beam, "UPN 50");
  CHECK(beam.stress == Approx(25.0 / 10600e-9 + 12.5 / 3750e-9));
}

TEST_CASE("A torque that twists a beam counts in its stress") {
  machine::MemberData data;
  data.member.torque = 40.0;
  data.member.support = machine::BeamSupport::cantilever;
  const auto stress = [&](const char* part_number) {
    return member_of(data, machine::MemberKind::section_beam, part_number).stress;
  };
  const auto both = [](double modulus, double shear) { return std::hypot(100.0 / modulus, 2.0 * shear); };
  // EN 10219-2, annex B: J = t^3 s/3 + 2 K A and C = J/(t + K/t) with K = 2 A t/s; corners of 1.5 t in mid-wall.
  struct Tube {
    const char* name;
    double h, b, t, modulus;
  };
  for (const Tube& tube : {Tube{"SHS 40x40x2", 0.04, 0.04, 0.002, 3470e-9},
                           Tube{"SHS 40x40x4", 0.04, 0.04, 0.004, 5537e-9},
                           Tube{"RHS 60x40x3", 0.06, 0.04, 0.003, 8460e-9},
                           Tube{"RHS 120x60x4", 0.12, 0.06, 0.004, 40123e-9}}) {
    const double r = 1.5 * tube.t, off = 4.0 - 3.14159265358979323846;
    const double a = tube.h - tube.t, c = tube.b - tube.t;
    const double area = a * c - off * r * r, round = 2.0 * (a + c) - 2.0 * off * r;
    const double K = 2.0 * area * tube.t / round, J = std::pow(tube.t, 3) * round / 3.0 + 2.0 * K * area;
    const double exact = both(tube.modulus, 40.0 * (tube.t + K / tube.t) / J);
    INFO(tube.name);
    CHECK(stress(tube.name) >= 0.999 * exact);  // J is rounded in the catalogue
    CHECK(stress(tube.name) < 1.05 * exact);
  }
  constexpr double pi = 3.14159265358979323846;
  CHECK(stress("RD 25") == Approx(both(1534e-9, 16.0 * 40.0 / (pi * std::pow(0.025, 3)))).epsilon(1e-3));
  CHECK(stress("UPN 80") == Approx(both(26500e-9, 40.0 * 0.008 / 21600e-12)));
  CHECK(stress("FL 60x10") >= both(6000e-9, 40.0 / (0.299 * 0.06 * 0.01 * 0.01)));
  // Between two held ends half of the torque goes to each.
  data.member.support = machine::BeamSupport::supported;
  CHECK(stress("UPN 80") == Approx(std::hypot(25.0 / 26500e-9, 40.0 * 0.008 / 21600e-12)));
}

TEST_CASE("A torque that twists a bar counts in its stress") {
  machine::MemberData data;
  data.member.kind = machine::MemberKind::rectangular_bar;
  data.member.length = 0.5;
  data.member.torque = 60.0;
  data.member.support = machine::BeamSupport::cantilever;
  data.elastic_modulus = 206e9;
  machine::StructureMember<double> bar;
  bar.data = &data;
  // Largest shear stress T/(a b t^2) [timoshenko_elasticity, section 109].
  for (const auto& [height, a] : {std::pair{0.02, 0.208}, {0.04, 0.246}, {0.08, 0.282}, {0.2, 0.313}}) {
    bar.width = 0.02;
    bar.height = height;
    bar.derive();
    const double shear = 60.0 / (a * height * 0.02 * 0.02);
    INFO(height);
    CHECK(bar.stress >= 2.0 * shear * 0.998);
    CHECK(bar.stress < 2.0 * shear * 1.5);
  }
}

}  // namespace section_figures_test
