// SPDX-License-Identifier: Apache-2.0
#include "app/import_options.h"

namespace millwright::app {

void add_import_options(CLI::App& verb, Options& options) {
  ImportOptions& import = options.import;
  verb.add_option("FILE", import.file, "table of a maker or shop (.csv, .xlsx, .ods)")->required();
  verb.add_option("--family", options.subject, "what the parts are, e.g. steppers (a mapping file says it too)")
      ->type_name("FAMILY");
  verb.add_option("--output", import.output, "catalogue file to write (.csv)")->type_name("FILE.csv");
  verb.add_flag("--yes,-y", import.yes, "write without asking; not where a unit is merely assumed");
  verb.add_option("--mapping", import.mapping, "read the columns as this file says, and write without asking")
      ->type_name("FILE.toml");
  verb.add_option(
          "--save-mapping", import.save_mapping, "write the mapping as a file, to edit or for the next price list")
      ->type_name("FILE.toml");
  const auto repeatable = [&](const char* name, std::vector<std::string>& list, const char* type, const char* text) {
    verb.add_option(name, list, text)->type_name(type)->allow_extra_args(false);
  };
  repeatable(
      "--constant",
      import.constants,
      "COLUMN=VALUE",
      "the same for all rows, e.g. manufacturer='ACT', currency=EUR, price_basis='shop 2026-01-15' (repeatable)");
  repeatable("--unit",
             import.units,
             "COLUMN=UNIT",
             "unit of the figures of one of our columns where the table does not say it (repeatable)");
  verb.add_option("--decimal", import.decimal, "decimal mark, where the figures do not tell")
      ->type_name("point|comma")
      ->check(CLI::IsMember({"point", "comma"}));
  verb.add_option("--sheet", import.sheet, "of a workbook (default: the first one)")->type_name("NAME");
  verb.add_option("--encoding", import.encoding, "of a text: utf-8, utf-16 or windows-1252")
      ->type_name("NAME")
      ->check(CLI::IsMember({"utf-8", "utf-16", "windows-1252"}));
  verb.add_option("--separator", import.separator, "between the cells of a text: comma, semicolon or tab")
      ->type_name("NAME")
      ->check(CLI::IsMember({"comma", "semicolon", "tab"}));
  verb.add_option(
          "--json", options.json, "write what was found as JSON to FILE; - : to standard output, nothing else there")
      ->type_name("FILE|-");
  verb.add_flag("--force", options.force, "overwrite the files if they are there");
  verb.add_flag("--quiet,-q", options.quiet, "only what went wrong");
}

}  // namespace millwright::app
