// SPDX-License-Identifier: Apache-2.0
// The one way to every file that the program writes, and what may become of one that is there already: nothing that is
// read is written over, nothing is written through a symbolic link, and a file of somebody else's gives way only to
// --force.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "text/diagnostic.h"
#include "text/output_file.h"

namespace millwright::app {

/// What an output is. Results that nobody edits are known again by how they begin, and renewed without a word; tables
/// and TOML files are made to be worked on, and whoever did so would lose it.
enum class OutputKind {
  json,   ///< {"schema": "millwright....
  page,   ///< its generator is Millwright
  lock,   ///< begins with report::lock_heading
  edited  ///< bill of materials, order, table, problem, catalogue, mapping
};

struct OutputTarget {
  std::string file;
  OutputKind kind = OutputKind::edited;
  bool force = false;  ///< a file that is there gives way, whatever it is
};

/// Reports, before any work is done, why the file could not or must not be written later; among that, that it is one of
/// `sources`, which are read. True if it can.
bool check_target(const OutputTarget& target, const std::vector<std::string>& sources, text::Diagnostics& diagnostics);

/// Opens it to be written piece by piece. Null, reported, if it cannot or must not be: it is judged again, because much
/// may have happened since the work began.
std::unique_ptr<text::OutputFile> open_target(const OutputTarget& target, text::Diagnostics& diagnostics);

/// Writes it at once: completely or not at all. False, reported, if that failed.
bool write_target(const OutputTarget& target, std::string_view contents, text::Diagnostics& diagnostics);

/// Whether two names, neither empty, are one file, which need not be there yet.
bool is_same_file(const std::string& one, const std::string& other);

}  // namespace millwright::app
