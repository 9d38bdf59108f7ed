// SPDX-License-Identifier: Apache-2.0
// Which files a catalogue was read from, with the SHA-256 of each.
#pragma once

#include <string>
#include <vector>

#include "catalogue/catalogue.h"

namespace millwright::catalogue {

struct FileRecord {
  int layer = 0;  ///< 0 = the first place given to Catalogue::load
  Family family{};
  std::string name;    ///< within its place: "steppers/x.csv"
  int rows = 0;        ///< that are used: an upper layer may have replaced some
  std::string sha256;  ///< of its bytes
};

/// A file that holds no parts but says something of them: stock.csv, suppliers.csv, offers.csv.
struct RemarkFile {
  std::string name;  ///< within its place
  std::size_t lines = 0;
  std::string sha256;  ///< of its bytes
};

/// One place: a folder, or a single file.
struct LayerRecord {
  std::string place;
  int files = 0;       ///< with parts
  int rows = 0;        ///< of those
  std::string sha256;  ///< of the list "<sha256>  <name>\n" of its files with parts, ascending by name
  std::vector<RemarkFile> remarks = {};
};

struct Inventory {
  std::vector<LayerRecord> layers;
  std::vector<FileRecord> files;  ///< by layer, then by name
};

/// Files without a row in their family are left out: nothing hangs on them.
Inventory inventory(const Catalogue& catalogue);

/// The name of a file within its place: "steppers/x.csv", or just the file where that is the place.
std::string name_in_place(const std::string& file, const std::string& place);

}  // namespace millwright::catalogue
