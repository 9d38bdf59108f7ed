// SPDX-License-Identifier: Apache-2.0
// How many whole machines are evaluated a second on one core: every machine of problems/ with the parts of its bill of
// materials, all stages from the tool to the supply, every constraint that the search holds, on double. Each evaluation
// has other ramp times. Processor time, the median of some rounds. Usage: throughput_benchmark [seconds a machine].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "benchmark/measure.h"
#include "evaluation/held_parts.h"
#include "evaluation/machine_model.h"
#include "machine/bill_of_materials.h"
#include "machine/problem_file.h"

namespace {

using namespace millwright;
namespace fs = std::filesystem;

using measure::processor_seconds;

/// One build of a machine; what the bill of materials leaves open is the first candidate.
class Build {
 public:
  Build(const evaluation::MachineModel& model, const machine::BillOfMaterials& bom) : problem_(model.problem()) {
    const evaluation::HeldParts held = evaluation::hold_parts(model, bom, {});
    shared_ = {held.voltage.value_or(0)};
    for (std::size_t i = 0; i < problem_.stages.size(); ++i) {
      const solver::Stage& stage = *problem_.stages[i];
      rows_.emplace_back();
      for (std::size_t slot = 0; slot < stage.slots().size(); ++slot) {
        const auto& allowed = held.stages[i].allowed[slot];
        rows_.back().push_back(allowed.empty() ? 0 : allowed.front());
      }
      variables_.emplace_back(stage.variables().size());
      constraints_ += stage.constraints();
    }
  }

  /// The largest utilisation with all variables at this share of their ranges; the rest is for the optimiser to keep.
  double evaluate(double share) {
    state_ = problem_.first_state;
    double worst = 0.0;
    for (std::size_t i = 0; i < problem_.stages.size(); ++i) {
      const solver::Stage& stage = *problem_.stages[i];
      const auto ranges = stage.variables();
      for (std::size_t v = 0; v < ranges.size(); ++v)
        variables_[i][v] = ranges[v].lower + share * (ranges[v].upper - ranges[v].lower);
      stage.evaluate({shared_, state_, rows_[i], variables_[i]}, answer_);
      for (const double u : answer_.utilisation) worst = std::max(worst, u);
      cost_ += answer_.resources[0];
      std::swap(state_, answer_.handed_on);
    }
    return worst;
  }
  [[nodiscard]] std::size_t constraints() const { return constraints_; }
  [[nodiscard]] std::size_t stages() const { return problem_.stages.size(); }

 private:
  const solver::Problem& problem_;
  std::vector<solver::Row> shared_;
  std::vector<std::vector<solver::Row>> rows_;
  std::vector<std::vector<double>> variables_;
  std::vector<double> state_;
  solver::Answer<double> answer_;
  std::size_t constraints_ = 0;
  double cost_ = 0.0;
};

/// Evaluations a second, the median of seven rounds.
double rate_of(Build& build, double seconds, double& checksum) {
  constexpr int rounds = 7;
  std::vector<double> rates;
  for (int round = 0; round < rounds; ++round) {
    std::size_t count = 0;
    const double start = processor_seconds();
    double now = start;
    while (now - start < seconds / rounds) {
      // Shares that never repeat: multiples of the golden section.
      for (int i = 0; i < 100; ++i)
        checksum +=
            build.evaluate(std::fmod(0.6180339887 * static_cast<double>(count + static_cast<std::size_t>(i)), 1.0));
      count += 100;
      now = processor_seconds();
    }
    rates.push_back(static_cast<double>(count) / (now - start));
  }
  return measure::median(rates);
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::strtod(argv[1], nullptr) : 1.0;
  const fs::path source = MILLWRIGHT_SOURCE_DIR;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(source / "problems"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  fmt::print("{}\n", measure::machine());
  fmt::print("{:14} {:>6} {:>11} {:>14} {:>9}\n", "machine", "stages", "constraints", "evaluations/s", "us each");
  double checksum = 0.0;
  for (const fs::path& file : files) {
    text::Diagnostics diagnostics;
    auto problem = machine::read_problem(file.string(), {}, diagnostics);
    const std::string name = file.stem().string();
    const fs::path parts = file.parent_path() / (name + "-parts");
    std::vector<fs::path> places{source / "catalogues"};
    if (fs::exists(parts)) places.push_back(parts);
    const auto catalogue = catalogue::Catalogue::load(places, diagnostics);
    const auto text = text::SourceText::load((file.parent_path() / (name + "-bom.csv")).string(), diagnostics);
    if (!problem || !text) {
      fmt::print("{}", text::format(diagnostics));
      return 2;
    }
    const auto bom = machine::read_bill_of_materials(text, *problem, diagnostics);
    if (!bom || diagnostics.has_errors()) {
      fmt::print("{}", text::format(diagnostics));
      return 2;
    }
    const evaluation::MachineModel model(*problem, catalogue, evaluation::given_slots(*bom));
    Build build(model, *bom);
    const double rate = rate_of(build, seconds, checksum);
    fmt::print("{:14} {:6} {:11} {:14.0f} {:9.2f}\n", name, build.stages(), build.constraints(), rate, 1e6 / rate);
  }
  fmt::print("checksum {:.6g}\n", checksum);
}
