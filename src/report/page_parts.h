// SPDX-License-Identifier: Apache-2.0
// The pieces of which pages are made. Each returns HTML; what comes from files is escaped in them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "machine/problem.h"
#include "report/json_value.h"
#include "report/mathml.h"
#include "report/page_texts.h"
#include "report/result.h"

namespace millwright::report {

/// A whole document: head, style, `body`, the data for the script and the script.
std::string document(
    const std::string& title, const std::string& body, const Json& charts, const std::string& json, const Texts& t);

/// What a page ends with: the program's version, and of which dates the prices of these designs are.
std::string footer(const std::vector<const evaluation::Design*>& designs, const Texts& t);

/// <section id><h2>heading</h2>...</section>; empty without content.
std::string section(std::string_view id, const std::string& heading, const std::string& content);

/// A table. Cells are HTML; a column is aligned by its mark: '<' left, '>' right (numbers).
class HtmlTable {
 public:
  HtmlTable(std::string_view alignment, const std::vector<std::string>& headings, std::string_view css_class = {});
  void add(const std::vector<std::string>& cells, std::string_view row_class = {}, std::string_view id = {});
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] std::string str() const;

 private:
  std::string alignment_, head_, css_class_, rows_;
  std::vector<std::string> labels_;  ///< the headings without tags
};

/// "good", "near" the limit, "bad", "over" a soft limit, or "open": the class of what shows a check.
const char* state_of(const evaluation::Check& check);
/// "ok", "FAIL", "over", "open".
std::string verdict_word(const evaluation::Check& check, const Texts& t);

/// How close a check is to its limit: a bar with the limit at four fifths of its length.
std::string utilisation_bar(const evaluation::Check& check);
/// That word as a mark with its class.
std::string verdict_mark(const evaluation::Check& check, const Texts& t);
/// Anchor of a check's calculation.
std::string calculation_id(const evaluation::Check& check);

/// To scale: every axis with its rails, screw, motor and carriage, from the base to the tool.
std::string machine_drawing(const machine::Problem& problem, const evaluation::Design& design, const Texts& t);

/// The calculation of every check of an axis, element by element.
std::string calculation_sheets(const evaluation::Design& design, const std::string& axis, const Texts& t);

/// One line of mathematics; `result`: the last one of a calculation.
std::string math_line(const MathLine& line, bool result = false);

/// Bill of materials with prices and where they come from.
std::string parts_table(const MachineResult& result, const evaluation::Design& design, const Texts& t);

/// Motion, torque over speed, utilisation, error budget, stiffness and calculation of every axis.
std::string axis_sections(const MachineResult& result, const evaluation::Design& design, const Texts& t);
/// What the script draws there.
Json axis_charts(const MachineResult& result, const evaluation::Design& design, const Texts& t);

/// The front: the chart, the table with what changes from build to build, and the sheet of each build.
std::string front_section(const MachineResult& result, const Texts& t);
Json front_chart(const MachineResult& result, const Texts& t);

/// Why there is no build, and ways out.
std::string nothing_section(const MachineResult& result, const Texts& t);

/// Outside validity, requirements, assumptions, estimates.
std::string basis_sections(const MachineResult& result, const evaluation::Design& design, const Texts& t);
/// The files that the result rests on, with their SHA-256; empty where they were not looked at.
std::string catalogues_section(const MachineResult& result, const Texts& t);
std::string certificate_section(const MachineResult& result, const Texts& t);

}  // namespace millwright::report
