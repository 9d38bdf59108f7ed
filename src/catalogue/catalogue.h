// SPDX-License-Identifier: Apache-2.0
// What can be bought: one table a family, read from the shipped folder and the user's overlays.
//
//   text::Diagnostics diagnostics;
//   const Catalogue catalogue = Catalogue::load({shipped_catalogues(), "my-parts"}, diagnostics);
//   constexpr Column inertia = column(Family::steppers, "rotor_inertia");
//   const Table& motors = catalogue.table(Family::steppers);
//   for (int row = 0; row < motors.rows(); ++row) use(motors.number(inertia, row));
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/location.h"
#include "catalogue/stock.h"
#include "catalogue/suppliers.h"
#include "catalogue/table.h"
#include "text/diagnostic.h"

namespace millwright::catalogue {

/// A row of a family.
struct Part {
  Family family;
  int row;
};

/// The rows, of any family, that answer to a part number; or why there is none.
struct FoundParts {
  std::vector<Part> parts;
  std::string error;
  std::string hint;
};

class Catalogue {
 public:
  /// Empty.
  Catalogue();

  /// Reads folders (or single files) in order. Within one of them a part may stand once; a row of a later one replaces
  /// the row of the same (manufacturer, part number), others are added. Later folders may hold any subset of the
  /// families, a stock file and files of suppliers and offers. Everything wrong is reported, and what could be read is
  /// returned; no part at all is an error too.
  static Catalogue load(const std::vector<std::filesystem::path>& places, text::Diagnostics& diagnostics);

  /// The parts alone: stock files and those of suppliers and offers are passed over, and a place may hold nothing else.
  static Catalogue load_parts(const std::vector<std::filesystem::path>& places, text::Diagnostics& diagnostics);

  const Table& table(Family family) const { return tables_[static_cast<std::size_t>(family)]; }
  /// To take figures otherwise than they stand (Table::set_number, set_range): of with_offers(), if it is not the
  /// catalogue itself, because models read that. Throws std::logic_error of another.
  Table& changeable_table(Family family);
  /// What the overlays say about parts beside their figures.
  const Stock& stock() const { return stock_; }
  /// What the overlays say about who sells them.
  const Suppliers& suppliers() const { return suppliers_; }
  /// The catalogue with a row more for every offer of a part; itself where nobody offers anything. Rows of the
  /// catalogue keep their numbers there. Lives as long as the catalogue, until parts are dropped.
  const Catalogue& with_offers() const { return with_offers_ ? *with_offers_ : *this; }
  /// The places as given to load(); Table::layer(row) counts in them.
  const std::vector<std::filesystem::path>& layers() const { return layers_; }
  /// Rows of all families.
  int rows() const;

  /// Looks through all families (a motor is found with the points of its torque curves).
  FoundParts find(std::string_view part_number, std::string_view manufacturer = {}) const;
  /// The same for one text: a part number, or maker and part number with a blank between ("Mean Well LRS-50-24").
  FoundParts find_named(std::string_view name) const;

  /// A catalogue of these parts and no others; rows of a family keep their order. With the same stock, suppliers and
  /// offers.
  Catalogue only(const std::vector<Part>& parts) const;
  /// Takes parts out, as if they were in none of the places.
  void drop(const std::vector<Part>& parts);

 private:
  std::vector<Table> tables_;
  std::vector<std::filesystem::path> layers_;
  Stock stock_;
  Suppliers suppliers_;
  std::shared_ptr<const Catalogue> with_offers_;
  bool has_offers_ = false;  ///< they are among its rows

  void add_offers();
};

}  // namespace millwright::catalogue
