// SPDX-License-Identifier: Apache-2.0
// Stock files beside the shipped catalogues.
#include "catalogue/catalogue.h"
#include "fuzz.h"

using namespace millwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const fuzz::MemoryFile file;
  static const catalogue::Catalogue shipped = [] {
    text::Diagnostics diagnostics;
    return catalogue::Catalogue::load({MILLWRIGHT_SOURCE_DIR "/catalogues"}, diagnostics);
  }();
  file.hold(fuzz::view(bytes, size));
  text::Diagnostics diagnostics;
  catalogue::Stock stock;
  catalogue::read_stock(file.path(), shipped, stock, diagnostics);
  fuzz::check(diagnostics);
  return 0;
}
