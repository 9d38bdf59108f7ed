// SPDX-License-Identifier: Apache-2.0
// compare_results COMMITTED FRESH: compares the .json and .txt files of two folders; exit code 1 if they differ.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "results/json_difference.h"

namespace {

namespace fs = std::filesystem;
namespace results = millwright::results;

std::set<std::string> result_files(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && (entry.path().extension() == ".json" || entry.path().extension() == ".txt"))
      names.insert(entry.path().lexically_relative(folder).generic_string());
  return names;
}

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> differences_of(const fs::path& committed, const fs::path& fresh) {
  if (!fs::exists(committed)) return {"is new"};
  if (!fs::exists(fresh)) return {"is no longer made"};
  std::vector<std::string> lines;
  if (committed.extension() == ".txt") {
    results::text_differences(content_of(committed), content_of(fresh), lines);
  } else {
    results::differences(
        results::Json::parse(content_of(committed)), results::Json::parse(content_of(fresh)), "", lines);
  }
  return lines;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::fputs("usage: compare_results COMMITTED FRESH\n", stderr);
    return 2;
  }
  constexpr std::size_t most_lines = 20;
  const fs::path committed = argv[1];
  const fs::path fresh = argv[2];
  std::set<std::string> names = result_files(committed);
  names.merge(result_files(fresh));
  int differing = 0;
  for (const std::string& name : names) {
    const std::vector<std::string> lines = differences_of(committed / name, fresh / name);
    differing += lines.empty() ? 0 : 1;
    for (std::size_t i = 0; i < std::min(lines.size(), most_lines); ++i)
      std::printf("results/%s: %s\n", name.c_str(), lines[i].c_str());
    if (lines.size() > most_lines)
      std::printf("results/%s: ... and %zu more\n", name.c_str(), lines.size() - most_lines);
  }
  std::printf("%zu result files compared, %d differ\n", names.size(), differing);
  return differing == 0 && !names.empty() ? 0 : 1;
} catch (const std::exception& problem) {
  std::fprintf(stderr, "compare_results: %s\n", problem.what());
  return 2;
}
