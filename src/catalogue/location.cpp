// SPDX-License-Identifier: Apache-2.0
#include "catalogue/location.h"

#include <cstdlib>
#include <system_error>

namespace millwright::catalogue {
namespace {

namespace fs = std::filesystem;

bool holds_catalogues(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(folder / "steppers", ignored);
}

}  // namespace

fs::path shipped_catalogues(const fs::path& executable) {
  const fs::path folder = executable.parent_path();
  const fs::path installed = folder.parent_path() / "share" / "millwright" / "catalogues";
  if (holds_catalogues(installed)) return installed;
#ifdef MILLWRIGHT_SOURCE_CATALOGUES
  if (holds_catalogues(MILLWRIGHT_SOURCE_CATALOGUES)) return MILLWRIGHT_SOURCE_CATALOGUES;
#endif
  for (fs::path above = folder; !above.empty(); above = above.parent_path()) {
    if (holds_catalogues(above / "catalogues")) return above / "catalogues";
    if (above == above.parent_path()) break;
  }
  return {};
}

fs::path shipped_catalogues() {
  if (const char* set = std::getenv("MILLWRIGHT_CATALOGUES"); set != nullptr && *set != '\0') return set;
  std::error_code problem;
  const fs::path executable = fs::read_symlink("/proc/self/exe", problem);
  return problem ? fs::path() : shipped_catalogues(executable);
}

}  // namespace millwright::catalogue
