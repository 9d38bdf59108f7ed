// SPDX-License-Identifier: Apache-2.0
// The lock of a result: a TOML file with the SHA-256 of everything that the result was made from, and the prices and
// figures of the parts that it chose.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "text/diagnostic.h"
#include "text/source_text.h"

namespace millwright::report {

/// A file beside the catalogues: "problem", "profile" (a measured motion) or "bill of materials".
struct LockedInput {
  std::string kind, file, sha256;
  text::SourceSpan where{};  ///< in the lock that was read; so below
};

/// A catalogue file, known by its layer (0 = the shipped catalogue) and its name there.
struct LockedFile {
  int layer = 0;
  std::string family, name;
  int rows = 0;
  std::string sha256;
  text::SourceSpan where{};
};

struct LockedFigure {
  std::string name, value;  ///< "price" is "9.62 USD"
  text::SourceSpan where{};
};

/// A part of the build, or a torque curve of one.
struct LockedPart {
  std::string family, manufacturer, part_number;
  std::string title;               ///< see catalogue::part_title()
  std::vector<std::string> slots;  ///< "x.motor"; of a curve those of its motor
  std::string file;                ///< catalogue file with its place: "catalogues/steppers/x.csv"
  std::vector<LockedFigure> figures;
  text::SourceSpan where{};
};

/// What the command line asked for.
struct LockedQuestion {
  std::string command;
  std::vector<std::string> settings, limits, without, fixed, objectives;
};

struct Lock {
  std::string version;  ///< of the program that wrote it
  LockedQuestion question;
  std::string cost, mass;  ///< of the one build, "360.11 USD"; empty where there is none or more than one
  std::vector<LockedInput> inputs;
  std::vector<std::string> places;  ///< of the layers
  std::vector<LockedFile> files;
  std::vector<LockedPart> parts;
  std::shared_ptr<const text::SourceText> source;  ///< from which it was read
};

/// How every lock begins: a file that does not is not overwritten by one.
inline constexpr std::string_view lock_heading = "# Lock of a millwright result";

/// Bytes that are no UTF-8, which TOML cannot hold, replaced. Names have to go through this before they are compared.
std::string lock_text(std::string_view text);

std::string lock_toml(const Lock& lock);

/// Everything that is wrong is reported at its place; also that the file is not as the program wrote it (its seal does
/// not hold). Nothing then.
std::optional<Lock> read_lock(const std::shared_ptr<const text::SourceText>& text, text::Diagnostics& diagnostics);

}  // namespace millwright::report
