// SPDX-License-Identifier: Apache-2.0
#include "catalogue/inventory.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "catalogue/stock.h"
#include "catalogue/suppliers.h"
#include "text/csv.h"
#include "text/sha256.h"

namespace millwright::catalogue {

std::string name_in_place(const std::string& file, const std::string& place) {
  const std::filesystem::path path(file);
  const std::string name = path.lexically_normal().lexically_relative(std::filesystem::path(place).lexically_normal());
  return name.empty() || name == "." ? path.filename().string() : name;
}

namespace {

std::vector<RemarkFile> remark_files(const std::filesystem::path& place) {
  std::vector<std::filesystem::path> files = supplier_files(place);
  if (const auto stock = stock_file(place)) files.insert(files.begin(), *stock);
  std::vector<RemarkFile> found;
  text::Diagnostics unused;  // they have been read already
  for (const std::filesystem::path& file : files)
    if (const auto csv = text::read_csv_file(file.string(), unused))
      found.push_back({file.filename().string(), csv->row_count(), text::sha256(csv->text()->bytes())});
  return found;
}

}  // namespace

Inventory inventory(const Catalogue& catalogue) {
  Inventory all;
  for (const std::filesystem::path& place : catalogue.layers())
    all.layers.push_back({place.string(), 0, 0, {}, remark_files(place)});
  for (const FamilyDeclaration& each : families) {
    const Table& table = catalogue.table(each.family);
    std::vector<int> rows(table.files().size(), 0);
    for (int row = 0; row < table.rows(); ++row) ++rows[table.file(row)];
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const SourceFile& file = table.files()[i];
      const std::string& place = all.layers[static_cast<std::size_t>(file.layer)].place;
      all.files.push_back({file.layer,
                           each.family,
                           name_in_place(file.text->path(), place),
                           rows[i],
                           text::sha256(file.text->bytes())});
    }
  }
  std::sort(all.files.begin(), all.files.end(), [](const FileRecord& a, const FileRecord& b) {
    return std::tie(a.layer, a.name, a.family) < std::tie(b.layer, b.name, b.family);
  });
  std::vector<std::string> lists(all.layers.size());
  for (const FileRecord& file : all.files) {
    const auto layer = static_cast<std::size_t>(file.layer);
    ++all.layers[layer].files;
    all.layers[layer].rows += file.rows;
    lists[layer] += file.sha256 + "  " + file.name + "\n";
  }
  for (std::size_t i = 0; i < lists.size(); ++i) all.layers[i].sha256 = text::sha256(lists[i]);
  return all;
}

}  // namespace millwright::catalogue
