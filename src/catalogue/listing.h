// SPDX-License-Identifier: Apache-2.0
// What `catalogue list` and `catalogue show` tell, as plain data for whoever prints it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "catalogue/catalogue.h"

namespace millwright::catalogue {

/// The range of one kind of price in one currency.
struct PriceRange {
  std::string_view column;  ///< price, price_per_length or price_per_mass
  std::string_view per;     ///< "" a piece, "1/m", "1/kg"
  std::string_view currency;
  double lowest = 0.0;  ///< in that currency per declared unit
  double highest = 0.0;
  int rows = 0;
};

/// A family in a few figures. Shares are of known numbers (prices apart), 0 to 1.
struct FamilySummary {
  Family family;
  std::string_view name;
  std::string_view title;
  int rows = 0;
  int manufacturers = 0;
  std::vector<PriceRange> prices;
  double estimated_share = 0.0;        ///< of its figures, how many are estimates
  double estimated_price_share = 0.0;  ///< of its prices
  double low_confidence_share = 0.0;   ///< of its rows
};

FamilySummary summarise(const Table& table);
std::vector<FamilySummary> summarise(const Catalogue& catalogue);

/// One line of a family's list: a part with its key figures (required numbers) in words.
struct PartLine {
  int row;
  std::string_view manufacturer;
  std::string_view part_number;
  std::string figures;  ///< "holding_torque 1.26 N.m, rated_current 2.8 A"
  Price price;
  bool price_estimate = false;
  std::string_view confidence;
};
std::vector<PartLine> list_parts(const Table& table);

/// One figure of a part as declared: number in its customary unit, or text.
struct Figure {
  std::string_view column;
  std::string_view meaning;
  std::string value;  ///< "1.26", "yes", "NEMA23"
  std::string unit;   ///< "N.m", "USD", "USD/m", "" for texts
  double si = 0.0;    ///< NaN for texts
  bool estimate = false;
  Standing standing = Standing::unstated;
  std::string_view basis;       ///< what the catalogue says about where the figure comes from
  std::string_view confidence;  ///< in this figure alone; empty: that of the row
  double tolerance = 0.0;       ///< relative, NaN if not stated
  std::string place;            ///< file:line:column
};

/// All that is known about a row; columns that are not given are left out.
struct PartSheet {
  Family family;
  int row;
  std::string_view manufacturer;
  std::string_view part_number;
  std::string place;  ///< file:line
  std::vector<Figure> figures;
};
PartSheet show(const Table& table, int row);

}  // namespace millwright::catalogue
