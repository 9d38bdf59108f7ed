// SPDX-License-Identifier: Apache-2.0
// How fast catalogues of steppers are read, with every check, into the tables that designs are evaluated from: rows
// like the shipped ones (all columns, texts and notes as they are, numbers varied by up to 10 %, part numbers made
// unique), written to two files of a temporary folder; and how fast they are linted. Prints rows and bytes per second
// of processor time, and how much memory the whole takes against the size of the files. Usage: catalogue_benchmark
// [rows], 1,000,000 by default.
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "benchmark/measure.h"
#include "catalogue/catalogue.h"
#include "catalogue/lint.h"
#include "text/csv.h"

namespace {

using namespace millwright;

double peak_megabytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024e-6;
}

std::string cell(std::string_view content) {
  if (content.find_first_of(",\"\n") == std::string_view::npos) return std::string(content);
  std::string quoted = "\"";
  for (const char c : content) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

class Generator {
 public:
  explicit Generator(const std::filesystem::path& shipped) {
    text::Diagnostics diagnostics;
    for (const auto& entry : std::filesystem::directory_iterator(shipped)) paths_.push_back(entry.path());
    std::sort(paths_.begin(), paths_.end());
    for (const auto& path : paths_) files_.push_back(*text::read_csv_file(path.string(), diagnostics));
    for (std::size_t file = 0; file < files_.size(); ++file)
      for (std::size_t row = 0; row < files_[file].row_count(); ++row) rows_.push_back({file, row});
  }

  std::uintmax_t write(const std::filesystem::path& path, std::size_t rows, std::size_t first) {
    std::ofstream out(path);
    out << files_.front().text()->line(files_.front().header_span().line) << '\n';
    for (std::size_t i = 0; i < rows; ++i) out << row(first + i) << '\n';
    out.close();
    return std::filesystem::file_size(path);
  }

 private:
  std::string row(std::size_t number) {
    const auto& [file, row] = rows_[random_() % rows_.size()];
    const text::CsvTable& table = files_[file];
    std::string line;
    for (std::size_t column = 0; column < files_.front().columns().size(); ++column) {
      const text::CsvColumn& of = files_.front().columns()[column];
      const auto there = table.find_column(of.name);
      std::string content(there ? table.cell(row, *there) : std::string_view());
      if (of.name == "part_number") {
        content += fmt::format("-{}", number);
      } else if (!content.empty() && (of.name == "price" || of.unit) && of.name != "step_angle" &&
                 of.name != "frame_size") {
        content = fmt::format("{:.4g}", std::strtod(content.c_str(), nullptr) * vary_(random_));
      }
      line += (column == 0 ? "" : ",") + cell(content);
    }
    return line;
  }

  std::vector<std::filesystem::path> paths_;
  std::vector<text::CsvTable> files_;
  std::vector<std::pair<std::size_t, std::size_t>> rows_;
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> vary_{0.9, 1.1};
};

}  // namespace

int main(int argc, char** argv) {
  const std::size_t rows = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / fmt::format("catalogue_{}", ::getpid());
  std::filesystem::create_directories(folder / "steppers");
  Generator generator(MILLWRIGHT_SOURCE_DIR "/catalogues/steppers");
  std::uintmax_t bytes = generator.write(folder / "steppers" / "a.csv", rows / 2, 0);
  bytes += generator.write(folder / "steppers" / "b.csv", rows - rows / 2, rows / 2);
  const double before = peak_megabytes();
  double best = 1e9;
  int read = 0;
  std::size_t said = 0;
  for (int round = 0; round < 3; ++round) {
    text::Diagnostics diagnostics;
    const double start = measure::processor_seconds();
    read = catalogue::Catalogue::load({folder}, diagnostics).rows();
    best = std::min(best, measure::processor_seconds() - start);
    said = diagnostics.count();
  }
  double linting = 1e9;
  std::size_t doubts = 0;
  for (int round = 0; round < 2; ++round) {
    text::Diagnostics diagnostics;
    const double start = measure::processor_seconds();
    catalogue::lint_files({folder / "steppers"}, std::nullopt, diagnostics);
    linting = std::min(linting, measure::processor_seconds() - start);
    doubts = diagnostics.count();
  }
  std::filesystem::remove_all(folder);
  const double megabytes = static_cast<double>(bytes) * 1e-6;
  fmt::print("{}\n", measure::machine());
  fmt::print("{} rows of steppers, {:.1f} MB, {} diagnostics: {:.3f} s, {:.2f} million rows/s, {:.0f} MB/s\n",
             read,
             megabytes,
             said,
             best,
             read / best * 1e-6,
             megabytes / best);
  fmt::print("memory {:.0f} MB, {:.2f} times the files (least of 3 rounds, processor time of one thread)\n",
             peak_megabytes() - before,
             (peak_megabytes() - before) / megabytes);
  fmt::print("read and linted, {} doubts: {:.3f} s, {:.2f} million rows/s\n", doubts, linting, read / linting * 1e-6);
  return static_cast<std::size_t>(read) == rows ? 0 : 1;
}
