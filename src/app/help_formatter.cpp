// SPDX-License-Identifier: Apache-2.0
#include "app/help_formatter.h"

#include <sstream>

#include "report/text_table.h"

namespace millwright::app {

namespace {

constexpr std::size_t width = 80;

/// Where a command of a shell may go on in the next line: the last blank outside quotes that leaves room for the
/// backslash; npos if there is none.
std::size_t break_of(const std::string& line) {
  std::size_t found = std::string::npos;
  bool quoted = false;
  for (std::size_t i = 0; i + 1 < width && i < line.size(); ++i) {
    if (line[i] == '\'') quoted = !quoted;
    if (line[i] == ' ' && !quoted && line.find_first_not_of(' ') < i) found = i;
  }
  return found;
}

std::string command_lines(std::string line) {
  std::string out;
  while (line.size() > width) {
    const std::size_t at = break_of(line);
    if (at == std::string::npos) break;
    out += line.substr(0, at) + " \\\n";
    line = "      " + line.substr(at + 1);
  }
  return out + line + "\n";
}

}  // namespace

/// What stands for the value, and "..." where several may be given. Validators and what is required are left out: the
/// one is said in words, the other by the line of usage.
std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  std::string type = option->get_type_name();
  type = type.substr(0, type.find(':'));
  if (type == "TEXT" || option->get_type_size() == 0) type.clear();
  if (!type.empty()) type = " " + type;
  return type + (option->get_expected_max() > 1 ? " ..." : "");
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  return report::wrapped(Formatter::make_option_desc(option), width - get_column_width(), 0);
}

std::string HelpFormatter::make_subcommand(const CLI::App* verb) const {
  std::stringstream out;
  CLI::detail::format_help(out,
                           verb->get_display_name(true),
                           report::wrapped(verb->get_description(), width - get_column_width(), 0),
                           get_column_width());
  return out.str();
}

std::string HelpFormatter::make_description(const CLI::App* verb) const {
  return report::fitted(Formatter::make_description(verb), width);
}

std::string HelpFormatter::make_footer(const CLI::App* verb) const {
  std::istringstream footer(Formatter::make_footer(verb));
  std::string out;
  std::string paragraph;  // sentences go on from line to line
  const auto close = [&] {
    if (!paragraph.empty()) out += report::wrapped(paragraph, width, 0) + "\n";
    paragraph.clear();
  };
  for (std::string line; std::getline(footer, line);) {
    if (!line.empty() && line.front() != ' ' && line.back() != ':') {
      paragraph += (paragraph.empty() ? "" : " ") + line;
      continue;
    }
    close();
    out += line.rfind("  millwright ", 0) == 0 ? command_lines(line) : report::fitted(line, width) + "\n";
  }
  close();
  return out;
}

}  // namespace millwright::app
