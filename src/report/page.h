// SPDX-License-Identifier: Apache-2.0
// The report as one page that needs nothing else: style, script and data are inside, nothing is loaded.
//
// Everything that is read stands in the page as plain HTML, SVG and MathML, so that it can be printed and searched, and
// works without the script; the script draws the charts and opens and closes what is long.
#pragma once

#include <string>

#include "evaluation/audit.h"
#include "machine/problem.h"
#include "report/page_texts.h"
#include "report/result.h"

namespace millwright::report {

enum class PageKind { solve, pareto, check };

/// `json`: the result for programs, as `--json` has it; it goes into the page. The designs must have their worksheets.
std::string machine_page(const MachineResult& result,
                         const machine::Problem& problem,
                         PageKind kind,
                         const std::string& json,
                         Language language = Language::english);

/// The rows must have their derivations.
std::string audit_page(const evaluation::AuditReport& report,
                       const std::string& file,
                       const std::string& json,
                       Language language = Language::english);

}  // namespace millwright::report
