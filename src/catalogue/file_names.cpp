// SPDX-License-Identifier: Apache-2.0
#include "catalogue/file_names.h"

#include <algorithm>
#include <string>
#include <vector>

namespace millwright::catalogue {
namespace {

std::string in_small_letters(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

}  // namespace

bool is_named(const std::filesystem::path& file, std::string_view name) {
  return in_small_letters(file.filename().string()) == name;
}

std::optional<std::filesystem::path> named_in(const std::filesystem::path& folder, std::string_view name) {
  std::error_code failure;
  if (!std::filesystem::is_directory(folder, failure)) return std::nullopt;
  std::vector<std::filesystem::path> found;
  for (std::filesystem::directory_iterator each(folder, failure), end; !failure && each != end; each.increment(failure))
    if (is_named(each->path(), name)) found.push_back(each->path());
  if (found.empty()) return std::nullopt;
  return *std::max_element(found.begin(), found.end());  // small letters come after capitals
}

bool is_csv_name(const std::filesystem::path& file) { return in_small_letters(file.extension().string()) == ".csv"; }

}  // namespace millwright::catalogue
