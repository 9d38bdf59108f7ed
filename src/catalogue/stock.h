// SPDX-License-Identifier: Apache-2.0
//
// What a user says about parts beside their figures: `stock.csv` in the folder of an overlay.
//
//   manufacturer,part_number,owned,available
//   OMC,17HS19-2004S1,2,            two lie in the drawer: they cost nothing, more of them cost their price
//   ,DM542T,,no                     cannot be had: is not chosen
//   ,BK12,,preferred                is chosen where it costs little more than another one
//
// A row of a catalogue may say the same of itself in its columns owned_quantity and availability (unavailable,
// preferred); a stock file goes first. The maker may be left out where only one has the part. A later overlay's word on
// a part replaces an earlier one's.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "catalogue/family.h"
#include "text/csv.h"
#include "text/diagnostic.h"

namespace millwright::catalogue {

class Catalogue;
class Table;

/// What is known of one part.
struct StockMark {
  double owned = 0.0;  ///< pieces
  bool available = true;
  bool preferred = false;
  text::SourceSpan where;
};

class Stock {
 public:
  /// Nothing if nothing is said about it.
  [[nodiscard]] const StockMark* find(Family family, std::string_view manufacturer, std::string_view part_number) const;
  void set(Family family, std::string_view manufacturer, std::string_view part_number, StockMark mark);
  [[nodiscard]] bool empty() const { return marks_.empty(); }

 private:
  using Key = std::tuple<Family, std::string, std::string>;  ///< family, manufacturer, part number
  std::map<Key, StockMark> marks_;
};

/// Whether pieces of that family can be owned: it is sold by the piece alone, so that a piece is a piece whatever the
/// machine. (Screws and rails are cut: whether what lies in the drawer is long enough is another question.)
constexpr bool can_be_owned(Family family) {
  const FamilyDeclaration& declared = declaration(family);
  return declared.priced_per_piece && !declared.priced_per_length && !declared.priced_per_mass;
}

/// Pieces of a row's part that are owned, as a stock file or else the row itself says.
double owned_pieces(const Table& table, int row, const Stock& stock);

/// The word in a row's `availability` that says the same as `no` in a stock file.
inline constexpr std::string_view unavailable = "unavailable";
/// The word for parts that are chosen where they cost little more than others, in rows and in stock files.
inline constexpr std::string_view preferred = "preferred";

/// Whether a row's part is preferred, as a stock file or else the row itself says.
bool is_preferred(const Table& table, int row, const Stock& stock);

/// The stock file of a place as given to Catalogue::load: the place itself, or in its folder.
std::optional<std::filesystem::path> stock_file(const std::filesystem::path& place);
/// Whether a file is one, by its name.
bool is_stock_file(const std::filesystem::path& file);

/// Adds what a file says about the parts of `catalogue`. Reported: unknown columns, parts that no catalogue has (with
/// the nearest) or that several makers have, what is no count, a part that stands twice, lines that say nothing.
void read_stock(const std::filesystem::path& file,
                const Catalogue& catalogue,
                Stock& stock,
                text::Diagnostics& diagnostics);
/// Reports what is wrong with its lines, whatever parts they name: all of that but the parts.
void check_stock_lines(const text::CsvTable& csv, text::Diagnostics& diagnostics);

}  // namespace millwright::catalogue
