// SPDX-License-Identifier: Apache-2.0
#include "app/commands.h"
#include "app/output.h"
#include "evaluation/audit.h"
#include "machine/claims.h"
#include "report/audit_text.h"
#include "report/json.h"
#include "report/page.h"

namespace millwright::app {

int run_audit(const Options& options) {
  text::Diagnostics diagnostics;
  const bool writable = outputs_are_writable(options, diagnostics);
  const auto claims = machine::read_claims(options.subject, diagnostics);
  print(diagnostics);
  if (!claims || !writable) return exit_bad_input;
  const evaluation::AuditReport report = evaluation::audit(*claims, options.derive || !options.report.empty());
  const std::string text = report::audit_text(report, options.derive, output_style(options));
  const std::string json = report::audit_json(report, options.subject);
  const std::string page = options.report.empty()
                               ? std::string()
                               : report::audit_page(report, options.subject, json, page_language(options));
  return deliver(options, text, json, page) ? exit_done : exit_bad_input;
}

}  // namespace millwright::app
