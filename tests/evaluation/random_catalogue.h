// SPDX-License-Identifier: Apache-2.0
//
// A catalogue of a few parts, drawn: some rows of the tiny catalogue, and likenesses of them, with figures, prices and
// masses of their own. The same parts can be had in another order of the rows.
#pragma once

#include <charconv>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "evaluation/tiny_catalogue.h"

namespace millwright {

/// Draws that are the same everywhere (distributions of the standard library need not be).
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed * 0x9E3779B97F4A7C15U + 1) {}
  double uniform() { return static_cast<double>(random_() >> 11U) * 0x1p-53; }
  double between(double lower, double upper) { return lower + uniform() * (upper - lower); }
  /// Evenly in the logarithm.
  double scale(double lower, double upper) { return lower * std::pow(upper / lower, uniform()); }
  bool chance(double probability) { return uniform() < probability; }
  std::size_t below(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(uniform() * static_cast<double>(count)));
  }
  template <class T>
  T of(std::initializer_list<T> choices) {
    return *(choices.begin() + below(choices.size()));
  }
  template <class T>
  void shuffle(std::vector<T>& values) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(i)]);
  }

 private:
  std::mt19937_64 random_;
};

class RandomCatalogue {
 public:
  /// `most`: rows that a family of many choices keeps.
  RandomCatalogue(Draw& draw, std::size_t most) {
    const TinyCatalogue whole;
    for (const auto& entry : std::filesystem::directory_iterator(whole.path()))
      read(entry.path().filename().string(), entry.path() / "tiny.csv");
    for (auto& [family, table] : tables_) vary(draw, family, table, most);
    write(folder_, 1);
    parts_ = catalogue_of({folder_.path()});
    for (auto& [family, table] : tables_) draw.shuffle(table.rows);
    write(shuffled_folder_, 2);
    shuffled_ = catalogue_of({shuffled_folder_.path()});
  }
  [[nodiscard]] const catalogue::Catalogue& parts() const { return parts_; }
  [[nodiscard]] const catalogue::Catalogue& shuffled() const { return shuffled_; }

 private:
  using Cells = std::vector<std::string>;
  struct Table {
    Cells header;
    std::vector<Cells> rows;
  };

  void read(const std::string& family, const std::filesystem::path& path) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
      Cells cells;
      std::stringstream stream(line + ",");
      for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
      Table& table = tables_[family];
      if (table.header.empty())
        table.header = cells;
      else
        table.rows.push_back(cells);
    }
  }

  /// Figures that say how good a part is; what says which parts go together stays.
  static bool may_vary(const std::string& column) {
    static const std::vector<std::string> quality = {"price",
                                                     "mass",
                                                     "nut_mass",
                                                     "screw_mass_per_length",
                                                     "rail_mass_per_length",
                                                     "carriage_mass",
                                                     "inertia",
                                                     "rotor_inertia",
                                                     "yield_strength",
                                                     "holding_torque",
                                                     "phase_inductance",
                                                     "phase_resistance",
                                                     "detent_torque",
                                                     "rated_torque",
                                                     "torsional_stiffness",
                                                     "axial_stiffness",
                                                     "permissible_axial_load",
                                                     "maximum_speed",
                                                     "dynamic_load_rating",
                                                     "static_load_rating",
                                                     "nut_stiffness",
                                                     "lead_error_per_300mm",
                                                     "allowable_tension",
                                                     "tensile_stiffness",
                                                     "power",
                                                     "allowable_stress",
                                                     "friction_greased",
                                                     "backlash",
                                                     "allowable_pressure",
                                                     "maximum_pv",
                                                     "radial_stiffness",
                                                     "mass_per_length",
                                                     "price_per_length",
                                                     "price_per_mass",
                                                     "pitch_error_per_1000mm",
                                                     "dn_limit"};
    return std::find(quality.begin(), quality.end(), column.substr(0, column.find(' '))) != quality.end();
  }

  static void vary_row(Draw& draw, const Cells& header, Cells& row, double by) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      double value = 0.0;
      const auto read = std::from_chars(row[i].data(), row[i].data() + row[i].size(), value);
      if (read.ec != std::errc() || read.ptr != row[i].data() + row[i].size() || !may_vary(header[i])) continue;
      row[i] = fmt::format("{:.6g}", value * draw.scale(1.0 / by, by));
    }
  }

  /// Supports at both ends may have to hold the screw along its axis.
  static void take_thrust(Table& table) {
    for (Cells& row : table.rows)
      for (std::size_t i = 0; i < row.size(); ++i)
        if (row[i].empty() && table.header[i].starts_with("permissible_axial_load"))
          row[i] = "700";
        else if (row[i].empty() && table.header[i].starts_with("axial_stiffness"))
          row[i] = "30";
  }

  static void vary(Draw& draw, const std::string& family, Table& table, std::size_t most) {
    const bool named_elsewhere = family == "stepper_curves" || family == "materials" || family == "lead_nuts";
    const double by = draw.of({1.0, 1.3, 2.5});
    for (Cells& row : table.rows) vary_row(draw, table.header, row, by);
    if (named_elsewhere) return;
    if (family == "support_bearings") take_thrust(table);
    const bool many = family == "steppers" || family == "drivers" || family == "power_supplies" || family == "screws" ||
                      family == "linear_guides" || family == "couplings" || family == "pinions";
    if (many) {
      // A likeness or two: the same part of another maker's make.
      const std::size_t likenesses = draw.below(3);
      for (std::size_t i = 0; i < likenesses; ++i) {
        Cells row = table.rows[draw.below(table.rows.size())];
        row[1] += fmt::format(" like {}", i);
        vary_row(draw, table.header, row, draw.of({1.05, 1.5, 3.0}));
        table.rows.push_back(row);
      }
      draw.shuffle(table.rows);
      if (table.rows.size() > most) table.rows.resize(most);
    } else if (family != "pulleys" && family != "support_bearings" && table.rows.size() > 1 && draw.chance(0.3)) {
      table.rows.erase(table.rows.begin() + static_cast<std::ptrdiff_t>(draw.below(table.rows.size())));
    }
  }

  /// Rows in turn in so many files.
  void write(const TemporaryFolder& folder, std::size_t files) const {
    for (const auto& [family, table] : tables_)
      for (std::size_t file = 0; file < std::min(files, table.rows.size()); ++file) {
        std::string text = fmt::format("{}\n", fmt::join(table.header, ","));
        for (std::size_t row = file; row < table.rows.size(); row += files)
          text += fmt::format("{}\n", fmt::join(table.rows[row], ","));
        folder.write(fmt::format("{}/drawn-{}.csv", family, file), text);
      }
  }

  std::map<std::string, Table> tables_;
  TemporaryFolder folder_, shuffled_folder_;
  catalogue::Catalogue parts_, shuffled_;
};

}  // namespace millwright
