// SPDX-License-Identifier: Apache-2.0
#include "app/output_target.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "report/lock.h"
#include "text/file_bytes.h"

namespace millwright::app {

namespace {

namespace fs = std::filesystem;

/// Whether the program made the file, told from its first bytes; an empty one is nobody's.
bool is_ours(const std::string& file, OutputKind kind) {
  constexpr std::size_t judged = 4096;
  std::error_code failure;
  if (fs::file_size(file, failure) == 0 && !failure) return true;
  const std::string head = text::first_bytes(file, judged);
  switch (kind) {
    case OutputKind::json:
      return head.starts_with("{\n  \"schema\": \"millwright.");
    case OutputKind::page:
      return head.starts_with("<!DOCTYPE html>") &&
             head.find("<meta name=\"generator\" content=\"Millwright\">") != std::string::npos;
    case OutputKind::lock:
      return head.starts_with(report::lock_heading);
    case OutputKind::edited:
      return false;
  }
  return false;
}

std::string_view no_such_thing(OutputKind kind) {
  switch (kind) {
    case OutputKind::json:
      return " that is no result of millwright";
    case OutputKind::page:
      return " that is no page of millwright";
    case OutputKind::lock:
      return " that is no lock";
    case OutputKind::edited:
      return "";
  }
  return "";
}

/// Why what is there must not be written over, and what to do; empty if nothing is there or it may.
std::pair<std::string, std::string> objection(const OutputTarget& target) {
  std::error_code failure;
  const fs::file_status status = fs::symlink_status(target.file, failure);
  if (fs::is_symlink(status)) return {"is a symbolic link and is not written through", "name the file itself"};
  if (fs::is_directory(status)) return {"cannot be written: it is a folder", "name a file in it"};
  if (!fs::exists(status)) return {};
  if (!fs::is_regular_file(status)) return {"cannot be written: it is a device, not a file", "name a file"};
  if (target.force || is_ours(target.file, target.kind)) return {};
  return {fmt::format("there is such a file already{}", no_such_thing(target.kind)),
          "name another one, or say --force to overwrite it"};
}

/// Reports it, if there is one.
bool is_free(const OutputTarget& target, text::Diagnostics& diagnostics) {
  const auto [message, hint] = objection(target);
  if (!message.empty()) diagnostics.error(fmt::format("{}: {}", text::printable(target.file), message), hint);
  return message.empty();
}

}  // namespace

bool is_same_file(const std::string& one, const std::string& other) {
  if (one.empty() || other.empty()) return false;
  std::error_code failure;
  if (fs::equivalent(one, other, failure)) return true;
  const fs::path first = fs::weakly_canonical(fs::absolute(one, failure), failure);
  if (failure) return one == other;
  const fs::path second = fs::weakly_canonical(fs::absolute(other, failure), failure);
  return failure ? one == other : first == second;
}

bool check_target(const OutputTarget& target, const std::vector<std::string>& sources, text::Diagnostics& diagnostics) {
  const std::string shown = text::printable(target.file);
  const auto refuse = [&](const std::string& message, const std::string& hint = {}) {
    diagnostics.error(shown + ": cannot be written: " + message, hint);
    return false;
  };
  std::error_code failure;
  const auto is_target = [&](const std::string& source) { return fs::equivalent(source, target.file, failure); };
  const bool is_link = fs::is_symlink(fs::symlink_status(target.file, failure));
  if (!is_link && std::any_of(sources.begin(), sources.end(), is_target))
    return refuse("it is read too", "name another file for the output");
  const fs::path parent = fs::path(target.file).parent_path();
  const fs::path folder = parent.empty() ? fs::path(".") : parent;
  if (!fs::is_directory(folder, failure))
    return refuse("there is no folder " + text::in_quotes(folder.string()), "make the folder first");
  if (access(folder.c_str(), W_OK) != 0) return refuse("no right to write in its folder");
  // Opening finds what else there is: names that are too long, a full disk. What was opened vanishes again.
  return open_target(target, diagnostics) != nullptr;
}

std::unique_ptr<text::OutputFile> open_target(const OutputTarget& target, text::Diagnostics& diagnostics) {
  return is_free(target, diagnostics) ? text::OutputFile::open(target.file, diagnostics) : nullptr;
}

bool write_target(const OutputTarget& target, std::string_view contents, text::Diagnostics& diagnostics) {
  const auto file = open_target(target, diagnostics);
  return file && file->append(contents) && file->commit();
}

}  // namespace millwright::app
