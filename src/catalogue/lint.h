// SPDX-License-Identifier: Apache-2.0
// Doubts about a catalogue: what is missing, what is of the wrong magnitude, what cannot be. See lint_drive.cpp and
// lint_structure.cpp for the rules.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "catalogue/table.h"
#include "text/diagnostic.h"

namespace millwright::catalogue {

/// Examines rows that were read: expected values that are missing (one warning a column and file), figures outside
/// their plausible range, and rows whose figures contradict each other. Impossible ones are errors, odd ones warnings.
/// A message ends with the name of its rule in brackets; a row whose `waiver` column names the rule is excused.
void lint(const Table& table, text::Diagnostics& diagnostics);

struct LintSummary {
  int files = 0;
  int rows = 0;
  std::size_t errors = 0;
  std::size_t warnings = 0;
};

/// Reads and examines files and folders; duplicates are looked for across all of them. `family` says what they are
/// where folder, name and header do not. Files of stock, suppliers and offers (lint_overlay.h) may name parts of the
/// places and of the catalogues `beside` them.
LintSummary lint_files(const std::vector<std::filesystem::path>& places,
                       std::optional<Family> family,
                       text::Diagnostics& diagnostics,
                       const std::vector<std::filesystem::path>& beside = {});

}  // namespace millwright::catalogue
