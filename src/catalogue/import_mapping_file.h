// SPDX-License-Identifier: Apache-2.0
// What a person says about a table, on the command line or in a mapping file, and a confirmed mapping as such a file:
//
//   family = "steppers"
//   encoding = "windows-1252"              # if it is not UTF-8; also: sheet, separator, decimal
//   [constants]
//   manufacturer = "ACT"
//   currency = "EUR"
//   [columns]
//   holding_torque = { from = "Haltemoment (N.cm)", unit = "N.cm", decimal = "comma" }
//   price = { from = "Preis", occurrence = 2 }
#pragma once

#include <optional>
#include <string>

#include "catalogue/import_mapping.h"
#include "text/diagnostic.h"

namespace millwright::catalogue {

/// What is said: the choices, and how the file is to be read.
struct ImportRequest {
  std::optional<Family> family;
  SheetFormat format;
  ImportChoices choices;  ///< its family is that of the request, once there is one
};

/// Reads a mapping file into the request; what it holds already (from the command line) goes before. Everything wrong
/// is reported at its place.
void read_mapping(const std::string& path, ImportRequest& request, text::Diagnostics& diagnostics);

/// `name=value` for all rows: a text, or a number with the unit of its column. `where` is the place of `value`.
void add_constant(ImportRequest& request,
                  std::string_view name,
                  std::string_view value,
                  const text::SourceSpan& where,
                  text::Diagnostics& diagnostics);

/// `column=unit` for the figures of one of our columns.
void add_unit(ImportRequest& request,
              std::string_view name,
              std::string_view unit,
              const text::SourceSpan& where,
              text::Diagnostics& diagnostics);

/// The family of that name; reports if there is none.
std::optional<Family> family_named(std::string_view name,
                                   const text::SourceSpan& where,
                                   text::Diagnostics& diagnostics);

/// The mapping as a file that read_mapping() takes. A unit that is merely assumed is left open, unless `confirmed`.
std::string mapping_text(const ImportMapping& mapping, const ImportRequest& request, bool confirmed);

}  // namespace millwright::catalogue
