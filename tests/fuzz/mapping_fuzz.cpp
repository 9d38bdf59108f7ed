// SPDX-License-Identifier: Apache-2.0
// Mapping files of `catalogue import`.
#include "catalogue/import_mapping_file.h"
#include "fuzz.h"

using namespace millwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const fuzz::MemoryFile file;
  file.hold(fuzz::view(bytes, size));
  text::Diagnostics diagnostics;
  catalogue::ImportRequest request;
  catalogue::read_mapping(file.path(), request, diagnostics);
  fuzz::require(request.family || diagnostics.has_errors(), "a mapping without a family is complained about");
  fuzz::check(diagnostics);
  return 0;
}
