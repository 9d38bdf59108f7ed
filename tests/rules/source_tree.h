// SPDX-License-Identifier: Apache-2.0
// The project's own files, as the rule tests read them.
#pragma once

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace millwright::rules {

/// A file of the project: path from the root ("src/text/csv.h") and content.
struct ProjectFile {
  std::string path;
  std::string content;
};

inline std::vector<std::string> lines_of(const std::string& content) {
  std::vector<std::string> lines;
  std::istringstream stream(content);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

inline ProjectFile read_project_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + path.string());
  return {path.lexically_relative(MILLWRIGHT_SOURCE_DIR).generic_string(),
          std::string(std::istreambuf_iterator<char>(stream), {})};
}

/// Every file below `folder` of the project ("src", "." for all), sorted. Left out: what git ignores, and git's own.
inline std::vector<ProjectFile> project_files(const std::string& folder,
                                              const std::vector<std::string>& extensions = {}) {
  namespace fs = std::filesystem;
  std::vector<ProjectFile> files;
  for (auto entry = fs::recursive_directory_iterator(fs::path(MILLWRIGHT_SOURCE_DIR) / folder);
       entry != fs::recursive_directory_iterator();
       ++entry) {
    const std::string name = entry->path().filename().string();
    if (entry->is_directory() && (name == ".git" || name == "build" || name == ".cache" || name == "node_modules")) {
      entry.disable_recursion_pending();
      continue;
    }
    if (!entry->is_regular_file()) continue;
    const std::string extension = entry->path().extension().string();
    if (extensions.empty() || std::find(extensions.begin(), extensions.end(), extension) != extensions.end())
      files.push_back(read_project_file(entry->path().lexically_normal()));
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return files;
}

/// The files git tracks; in an unpacked archive, where git knows nothing, every file.
inline std::vector<ProjectFile> tracked_files() {
  std::vector<ProjectFile> files;
  std::string names;
  const std::string command = "git -C '" MILLWRIGHT_SOURCE_DIR "' ls-files -z 2>/dev/null";
  if (FILE* pipe = popen(command.c_str(), "r")) {
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) names.push_back(static_cast<char>(c));
    pclose(pipe);
  }
  if (names.empty()) return project_files(".");
  std::istringstream stream(names);
  for (std::string name; std::getline(stream, name, '\0');) {
    const auto path = std::filesystem::path(MILLWRIGHT_SOURCE_DIR) / name;
    if (std::filesystem::is_regular_file(path)) files.push_back(read_project_file(path));
  }
  return files;
}

/// C++ sources of the project below `folder`.
inline std::vector<ProjectFile> cpp_files(const std::string& folder) { return project_files(folder, {".h", ".cpp"}); }

/// "src/text/csv.h" -> "text"; empty for a file that is in no room.
inline std::string room_of(const std::string& path) {
  const std::string prefix = "src/";
  const std::size_t end = path.find('/', prefix.size());
  if (path.rfind(prefix, 0) != 0 || end == std::string::npos) return {};
  return path.substr(prefix.size(), end - prefix.size());
}

/// For failure messages: one finding a line.
inline std::string joined(const std::vector<std::string>& findings) {
  std::string text;
  for (const std::string& finding : findings) text += finding + '\n';
  return text;
}

}  // namespace millwright::rules
