// SPDX-License-Identifier: Apache-2.0
// How fast a catalogue is read: about 100 MB of CSV, generated in memory, into typed columns on one core.
// Prints MB/s for the whole (text check, records, numbers, texts) and for its parts. Usage: csv_benchmark [megabytes]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "benchmark/measure.h"
#include "text/csv.h"
#include "text/text_check.h"

namespace {

using measure::Clock;
using measure::seconds_since;

/// Rows like those of a stepper catalogue: four texts, one of them quoted now and then, and eight numbers.
std::string catalogue(std::size_t bytes, char separator, const std::string& line_end) {
  std::mt19937 generator(1);
  const std::vector<std::string> names = {"manufacturer",
                                          "part_number",
                                          "frame",
                                          "holding_torque [N.cm]",
                                          "rated_current [A]",
                                          "resistance [ohm]",
                                          "inductance [mH]",
                                          "rotor_inertia [g.cm2]",
                                          "mass [kg]",
                                          "price",
                                          "currency",
                                          "length [mm]"};
  std::string text = "# generated\n";
  for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : std::string(1, separator)) + names[i];
  text += line_end;
  const auto number = [&](unsigned limit, int digits) {
    return fmt::format("{:.{}f}", static_cast<double>(generator() % limit) / 997.0, digits);
  };
  while (text.size() < bytes) {
    std::vector<std::string> cells = {generator() % 20 == 0 ? "\"Maker, Sons\"" : "StepperOnline",
                                      fmt::format("23HS{:05d}", generator() % 100000),
                                      "NEMA23",
                                      number(300000, 1),
                                      number(6000, 2),
                                      number(9000, 3),
                                      number(9000, 2),
                                      number(900000, 0),
                                      number(4000, 4),
                                      number(90000, 2),
                                      "USD",
                                      number(100000, 1)};
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (i > 0) text += separator;
      text += cells[i];
    }
    text += line_end;
  }
  return text;
}

void read(const std::string& title, std::string contents) {
  const double megabytes = static_cast<double>(contents.size()) / 1e6;
  const auto text = millwright::text::SourceText::from_string("generated.csv", std::move(contents));
  millwright::text::Diagnostics diagnostics;
  double best_total = 1e9;
  double best_records = 1e9;
  double checksum = 0;
  for (int round = 0; round < 3; ++round) {
    const Clock::time_point start = Clock::now();
    const millwright::text::CsvTable table = millwright::text::read_csv(text, diagnostics);
    const double records = seconds_since(start);
    const std::vector<std::size_t> numeric = {3, 4, 5, 6, 7, 8, 9, 11};
    const auto columns = table.number_columns(numeric, diagnostics);
    std::size_t characters = 0;
    for (const std::size_t column : {0U, 1U, 2U, 10U}) {
      for (const std::string_view cell : table.text_column(column)) characters += cell.size();
    }
    const double total = seconds_since(start);
    for (const auto& column : columns) checksum += column.back();
    checksum += static_cast<double>(characters);
    best_total = std::min(best_total, total);
    best_records = std::min(best_records, records);
    if (round == 0)
      fmt::print("{}: {:.1f} MB, {} rows, {} diagnostics\n", title, megabytes, table.row_count(), diagnostics.count());
  }
  const Clock::time_point start = Clock::now();
  millwright::text::check_text(text, diagnostics);
  fmt::print("  text check {:.0f} MB/s, records {:.0f} MB/s, all into typed columns {:.0f} MB/s (checksum {:.6g})\n",
             megabytes / seconds_since(start),
             megabytes / best_records,
             megabytes / best_total,
             checksum);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t bytes = (argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100) * 1000000;
  fmt::print("{}\n", measure::machine());
  read("comma, LF", catalogue(bytes, ',', "\n"));
  read("semicolon, CR LF", catalogue(bytes, ';', "\r\n"));
}
