// SPDX-License-Identifier: Apache-2.0
//
// What a member reads of a catalogue's section, as numbers or as ranges. A steel section is rolled of the grade that
// the member's material names; an extrusion is of the alloy of its row.
//
// An angle's second moments are tabulated about axes parallel to its legs, which are not its principal ones: a load
// along a leg bends it askew, further and to the side, and loads together may act across its weak principal axis. With
// equal legs the least second moment is 0.41 I (of L40x40x4 the tables have 18.6 of 44.7 mm^4); it serves for every
// direction. The largest stress, at the inner edge of a toe, is that of 0.8 times the section modulus [AISC 360, F10];
// sharp toes and unequal legs, loaded along the long one, need 0.77. Restraint by what is bolted to it is not counted.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "catalogue/catalogue.h"
#include "machine/structure_member.h"
#include "scalar/scalars.h"

namespace millwright::evaluation {

/// What the material of a member lends to its section [Pa].
struct SectionGrade {
  double elastic_modulus = 0.0, yield_strength = 0.0, shear_modulus = 0.0;
};

/// E = 2 (1 + v) G, Poisson's ratio of aluminium alloys 0.33.
inline constexpr double aluminium_modulus_ratio = 2.66;
inline constexpr double angle_least_second_moment = 0.41;
inline constexpr double angle_bending_modulus = 0.77;

/// Steel sections or extrusions, with the columns that a member reads.
class SectionFigures {
 public:
  explicit SectionFigures(const catalogue::Table& table) : table_(table), family_(table.family()) {}

  /// In the order of machine::visit_section_reading; `steel` is the grade of steel sections; `figure` reads a column of
  /// the row, as a number or as an interval.
  template <class Figure>
  [[nodiscard]] auto readings(int row, const SectionGrade& steel, Figure figure) const {
    using T = decltype(figure(mass_per_length));
    const T strong = figure(second_moment_x_);
    const T weak = figure(second_moment_y_);
    const T height = figure(height_);
    const T width = figure(width_);
    const bool angle = is(row, "angle") && !is(row, "rectangle");
    const bool channel = is(row, "channel");
    const T over_height = modulus(row, figure, section_modulus_x_, strong, height, !angle);
    const T over_width = modulus(row, figure, section_modulus_y_, weak, width, !angle && !channel);
    const double stressed = angle ? angle_bending_modulus : 1.0;
    const T least = (angle ? angle_least_second_moment : 1.0) * scalar::smaller(strong, weak);
    const bool extruded = family_ == catalogue::Family::extrusions;
    const T elastic_modulus = extruded ? figure(of("elastic_modulus")) : T(steel.elastic_modulus);
    return std::array<T, machine::section_reading_fields>{
        figure(area_),
        angle ? least : strong,
        angle ? least : weak,
        least,
        stressed * over_height,
        stressed * over_width,
        height,
        width,
        figure(mass_per_length),
        elastic_modulus,
        extruded ? figure(of("yield_strength")) : T(steel.yield_strength),
        torsion_width(row, figure, height, width),
        figure(torsion_constant),
        extruded ? T(elastic_modulus / aluminium_modulus_ratio) : T(steel.shear_modulus)};
  }

 private:
  /// By it the shear stress of torsion follows from the torsion constant J. Of a closed wall of thickness t around an
  /// area A of circumference s: t + 2 A/s, as J is 4 A^2 t/s + s t^3/3 [EN 10219-2, annex B]; round corners make A/s
  /// at most 4/(2 + sqrt(pi)) = 1.061 times as large (the Cheeger constant of a square). Of an open one its
  /// thickest wall. Of a solid rectangle at most its smaller side; that serves where nothing else is known.
  template <class Figure, class T>
  [[nodiscard]] T torsion_width(int row, Figure figure, const T& height, const T& width) const {
    if (is(row, "circular") || is(row, "round")) return 0.5 * height;
    const bool hollow = is(row, "hollow");
    if (!hollow && !is(row, "angle") && !is(row, "channel")) return scalar::smaller(height, width);
    const catalogue::Column web = of("web_thickness"), flange = of("flange_thickness");
    if (std::isnan(table_.number(web, row) + table_.number(flange, row))) return scalar::smaller(height, width);
    const T wall = scalar::larger(figure(web), figure(flange));
    constexpr double round_corners = 1.061;
    return hollow ? T(wall + round_corners * (height - wall) * (width - wall) / (height + width - 2.0 * wall)) : wall;
  }
  [[nodiscard]] catalogue::Column of(std::string_view name) const { return catalogue::column(family_, name); }
  /// Whether the kind of a steel section has this word.
  [[nodiscard]] bool is(int row, std::string_view word) const {
    return family_ == catalogue::Family::steel_sections &&
           table_.text(of("kind"), row).find(word) != std::string_view::npos;
  }
  /// A section that is the same on both sides needs no section modulus: its outermost fibre is half of it away.
  template <class Figure, class T>
  [[nodiscard]] T modulus(int row,
                          Figure figure,
                          catalogue::Column name,
                          const T& second_moment,
                          const T& extent,
                          bool same_on_both_sides) const {
    if (same_on_both_sides && std::isnan(table_.number(name, row))) return second_moment / (0.5 * extent);
    return figure(name);
  }

  const catalogue::Table& table_;
  catalogue::Family family_;
  catalogue::Column area_ = of("area"), height_ = of("height"), width_ = of("width");
  catalogue::Column second_moment_x_ = of("second_moment_x"), second_moment_y_ = of("second_moment_y");
  catalogue::Column section_modulus_x_ = of("section_modulus_x"), section_modulus_y_ = of("section_modulus_y");

 public:
  const catalogue::Column mass_per_length = of("mass_per_length"), torsion_constant = of("torsion_constant");
};

}  // namespace millwright::evaluation
