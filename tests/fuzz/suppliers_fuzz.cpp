// SPDX-License-Identifier: Apache-2.0
// suppliers.csv and, below a line `---`, offers.csv, beside the shipped catalogues.
#include <filesystem>

#include "catalogue/catalogue.h"
#include "fuzz.h"

using namespace millwright;

namespace {

/// Two files in memory under the names that the reader goes by.
struct Overlay {
  Overlay() {
    std::filesystem::create_directories(folder);
    std::filesystem::create_symlink(suppliers.path(), folder / "suppliers.csv");
    std::filesystem::create_symlink(offers.path(), folder / "offers.csv");
  }
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;
  ~Overlay() {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }
  fuzz::MemoryFile suppliers, offers;
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("millwright-fuzz-suppliers-" + std::to_string(::getpid()));
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const Overlay overlay;
  static const catalogue::Catalogue shipped = [] {
    text::Diagnostics diagnostics;
    return catalogue::Catalogue::load({MILLWRIGHT_SOURCE_DIR "/catalogues"}, diagnostics);
  }();
  constexpr std::string_view border = "\n---\n";
  const std::string_view input = fuzz::view(bytes, size);
  const std::size_t at = input.find(border);
  overlay.suppliers.hold(input.substr(0, at));
  overlay.offers.hold(at == std::string_view::npos ? std::string_view() : input.substr(at + border.size()));
  text::Diagnostics diagnostics;
  catalogue::Suppliers suppliers;
  for (const std::filesystem::path& file : catalogue::supplier_files(overlay.folder))
    catalogue::read_suppliers(file, shipped, suppliers, diagnostics);
  catalogue::check_suppliers(shipped, suppliers, diagnostics);
  for (const catalogue::Supplier& each : suppliers.suppliers)
    fuzz::require(each.shipping_fee >= 0.0 && each.minimum_order >= 0.0, "an order never costs less than nothing");
  for (const catalogue::Offer& each : suppliers.offers)
    fuzz::require(!(each.price < 0.0) && !(each.price_per_length < 0.0), "a price is never below nothing");
  fuzz::check(diagnostics);
  return 0;
}
