// SPDX-License-Identifier: Apache-2.0
//
// What a person asks for on the command line beside the problem file: budgets, parts that may not be used, slots and
// settings that are decided beforehand.
#pragma once

#include <string>
#include <vector>

#include "catalogue/catalogue.h"
#include "machine/bill_of_materials.h"
#include "machine/limits_file.h"
#include "machine/problem.h"
#include "text/diagnostic.h"

namespace millwright::machine {

/// A part that may not be used anywhere, with its rows in the catalogues.
struct ExcludedPart {
  std::string manufacturer, part_number;
  std::vector<catalogue::Part> rows;
  std::string said_in = {};  ///< "parts/stock.csv:3" where a stock file says that it cannot be had; else --without
};

struct Steering {
  std::vector<LimitOption> limits;
  std::vector<ExcludedPart> without;
  BillOfMaterials fixed;              ///< each line a part for a slot, or a setting; `where` is in the option's word
  std::vector<std::string> settings;  ///< values of the problem file that are others: "axis.z.payload_mass=30 kg"
  [[nodiscard]] bool empty() const {
    return limits.empty() && without.empty() && fixed.lines.empty() && settings.empty();
  }
};

/// Parts named as a part number, or as maker and part number ("Mean Well LRS-50-24"). Reported: parts that no catalogue
/// has (with the nearest), and materials and reductions, which the problem itself names.
std::vector<ExcludedPart> read_excluded(const std::vector<std::string>& words,
                                        const Problem& problem,
                                        const catalogue::Catalogue& catalogue,
                                        text::Diagnostics& diagnostics);

/// Adds the parts of which the catalogue's stock files say that they cannot be had.
void exclude_unavailable(const catalogue::Catalogue& catalogue, std::vector<ExcludedPart>& without);

/// Words such as "x.motor=17HS4401S", "x.acceleration_time=0.2 s", "machine.supply_voltage=24 V". Reported, at the
/// word: axes, slots and parts that do not exist (with the nearest), values that do not fit, parts that are excluded,
/// what is fixed twice and differently. Whether a part can be in its slot is found out later.
BillOfMaterials read_fixed(const std::vector<std::string>& words,
                           const Problem& problem,
                           const catalogue::Catalogue& catalogue,
                           const std::vector<ExcludedPart>& without,
                           text::Diagnostics& diagnostics);

/// Reports the lines of a bill of materials that name an excluded part.
void refuse_excluded(const BillOfMaterials& bom,
                     const std::vector<ExcludedPart>& without,
                     text::Diagnostics& diagnostics);

}  // namespace millwright::machine
