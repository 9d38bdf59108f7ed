// SPDX-License-Identifier: Apache-2.0
//
// Words with which a problem chooses among the parts of the catalogues (frame, kinds, profiles, ...): those that choose
// nothing, and parts on a bill of materials that they do not choose.
#pragma once

#include "catalogue/catalogue.h"
#include "machine/bill_of_materials.h"
#include "machine/problem.h"
#include "text/diagnostic.h"
#include "text/document.h"

namespace millwright::machine {

/// Warns at each word that no row of the catalogues has, with the nearest that one has: an answer that is proved for
/// fewer parts than were meant looks like any other. An error it is not: the same problem may be solved with other
/// catalogues. `document`: of the problem.
void note_idle_words(const Problem& problem,
                     const text::Document& document,
                     const catalogue::Catalogue& catalogue,
                     text::Diagnostics& diagnostics);

/// Warns at each line of the bill of materials that names a part, or a value, which the problem would not choose. Lines
/// of parts that the catalogues do not have are left to others; `only_origin`, if not empty: lines of another origin
/// are not held.
void note_unwanted_lines(const BillOfMaterials& bom,
                         const std::string& only_origin,
                         const Problem& problem,
                         const catalogue::Catalogue& catalogue,
                         text::Diagnostics& diagnostics);

}  // namespace millwright::machine
