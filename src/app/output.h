// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/options.h"
#include "evaluation/ledger.h"
#include "report/page_texts.h"
#include "report/text_table.h"
#include "text/diagnostic.h"

namespace millwright::app {

/// Colours for standard output, if it is a terminal that wants them (NO_COLOR, TERM=dumb); its width; the essentials
/// only with --quiet.
report::Style output_style(const Options& options);

/// Prints the diagnostics to standard error.
void print(const text::Diagnostics& diagnostics);

/// As it is. False, with a complaint on standard error, if it could not be written.
bool write_stdout(std::string_view text);

/// Prints the text, or with `--json -` the JSON, to standard output, and writes the JSON file and the page if they are
/// asked for. False, with a complaint on standard error, if something could not be written.
bool deliver(const Options& options, const std::string& text, const std::string& json, const std::string& page = {});

/// Writes the files of `--order`, if it is given. False, with a complaint on standard error, if one could not be
/// written.
bool write_order(const Options& options, const evaluation::Design& design, const std::string& title);

/// The language of the page.
report::Language page_language(const Options& options);

/// Refuses at once, before any work, output files that could not or must not be written later (output_target.h).
bool outputs_are_writable(const Options& options, text::Diagnostics& diagnostics);

/// Refuses outputs that are among files (or the catalogues of folders) of which it turned out that they are read.
void spare_sources(const Options& options, const std::vector<std::string>& places, text::Diagnostics& diagnostics);

}  // namespace millwright::app
