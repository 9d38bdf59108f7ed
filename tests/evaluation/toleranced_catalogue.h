// SPDX-License-Identifier: Apache-2.0
//
// A catalogue with tolerances: every figure of another one written out again, with a tolerance where `share` says so.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>

#include "catalogue/column_unit.h"
#include "catalogue/companions.h"
#include "catalogue/header.h"
#include "catalogue/temporary_folder.h"
#include "evaluation/machines.h"

namespace millwright {

class TolerancedCatalogue {
 public:
  /// Relative, 0 = none. `name`: "steppers.rotor_inertia".
  using Share = std::function<double(const std::string& name, int row)>;

  TolerancedCatalogue(const catalogue::Catalogue& from, const Share& share) {
    for (const catalogue::FamilyDeclaration& family : catalogue::families)
      if (!from.table(family.family).empty())
        folder_.write(std::string(family.name) + "/all.csv", written(from.table(family.family), share));
    parts_ = catalogue_of({folder_.path()});
  }
  [[nodiscard]] const catalogue::Catalogue& parts() const { return parts_; }

 private:
  static std::string written(const catalogue::Table& table, const Share& share) {
    using namespace catalogue;
    const Family family = table.family();
    std::string head;
    std::vector<std::string> rows(static_cast<std::size_t>(table.rows()));
    for (std::size_t index = 0; index < column_count(family); ++index) {
      const Column column{family, static_cast<std::uint8_t>(index)};
      const ColumnDeclaration& declared = declaration(column);
      head += (index > 0 ? "," : "") + header_cell(column);
      const bool may = takes_tolerance(column);
      if (may) head += fmt::format(",{}_tolerance", declared.name);
      for (int row = 0; row < table.rows(); ++row) {
        std::string& line = rows[static_cast<std::size_t>(row)];
        if (index > 0) line += ",";
        if (declared.kind == Kind::text) {
          line += '"';
          for (const char c : table.text(column, row)) line += c == '"' ? std::string("\"\"") : std::string(1, c);
          line += '"';
          continue;
        }
        const double value = table.number(column, row);
        if (declared.kind == Kind::flag)
          line += std::isnan(value) ? "" : value != 0.0 ? "yes" : "no";
        else if (!std::isnan(value))
          line += fmt::format("{:.17g}", display_unit(column).from_si(value));
        if (!may) continue;
        const double part = std::isnan(value) || value == 0.0
                                ? 0.0
                                : share(fmt::format("{}.{}", declaration(family).name, declared.name), row);
        line += part > 0.0 ? fmt::format(",{:.6g} %", 100.0 * part) : ",";
      }
    }
    std::string text = head + "\n";
    for (const std::string& row : rows) text += row + "\n";
    return text;
  }

  TemporaryFolder folder_;
  catalogue::Catalogue parts_;
};

}  // namespace millwright
