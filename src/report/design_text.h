// SPDX-License-Identifier: Apache-2.0
// The pieces of which the answers about a machine are made; each begins with its heading and is empty where there is
// nothing to say.
#pragma once

#include <string>

#include "report/page_texts.h"
#include "report/quantity_text.h"
#include "report/result.h"
#include "report/text_table.h"

namespace millwright::report {

/// "StepperOnline 17HS19-2004S1"; without a maker the part number alone.
std::string part_name(const std::string& manufacturer, const std::string& part_number);
std::string part_name(const evaluation::PartLine& part);

/// What axes have by the problem's word only (a brake, a counterbalance): nobody chose, bought or weighed it.
std::vector<std::string> stated_only_lines(const evaluation::Design& design, const Texts& t);

/// The parts axis by axis, with lengths, prices and masses; estimates marked and explained.
std::string parts_text(const MachineResult& result, const evaluation::Design& design, const Style& style);

/// "+1.50", "-0.02"; "=" for what rounds to nothing.
std::string signed_text(double difference, int digits);
/// All totals that were counted, `first` before the others.
std::string totals_text(const evaluation::Design& design, machine::Quantity first = machine::Quantity::cost);

/// Dimensions and settings that were chosen or given.
std::string dimensions_text(const evaluation::Design& design, const Style& style);

/// For each axis the hard check that is used most.
std::string governing_text(const MachineResult& result, const evaluation::Design& design, const Style& style);

/// Every check, axis by axis, the most used first.
std::string checks_text(const MachineResult& result, const evaluation::Design& design, const Style& style);

/// For each axis the checks that count next to their limits, ten at most, and (`with_failures`) those that fail; below,
/// what is only reported and over.
std::string closest_checks_text(const MachineResult& result,
                                const evaluation::Design& design,
                                const Style& style,
                                bool with_failures = true);

/// Limits within which formulas are stated and which the design leaves.
std::string outside_validity_text(const evaluation::Design& design, const Style& style);

/// The factors and limits behind the checks and where they come from.
std::string requirements_text(const MachineResult& result, const Style& style);

/// What the totals take for granted.
std::string assumptions_text(const evaluation::Design& design, const Style& style);

/// "97.2 %"; "> 999 %" beyond that; "-" where nothing could be evaluated.
std::string utilisation_text(const evaluation::Check& check);
/// "112.4 %" that no build comes below, rounded down; "no part" where none states what is needed.
std::string least_text(const evaluation::UnmetCheck& check);
/// Wide enough for tables of checks with a column for everything; below it id, title and where a check is worst share
/// one.
inline constexpr std::size_t wide_checks = 120;
/// The element of a check, if its axis has the same check of another one too: "flange"; else empty.
std::string element_named(const evaluation::Design& design, const evaluation::Check& check);
/// "Proof load of the screws", where several elements have that check "Proof load of the screws (flange)".
std::string title_of(const evaluation::Design& design, const evaluation::Check& check);
/// "C-ACC-TOTAL Position error budget", below it "(constant speed)" where a check is worst.
std::string check_cell(const evaluation::Design& design, const evaluation::Check& check, const std::string& id);
/// Phase of the duty cycle and position of the travel where a check is worst.
std::string worst_text(const evaluation::Check& check);

}  // namespace millwright::report
