// SPDX-License-Identifier: Apache-2.0
// CBC on the prepared table: one binary for each pair of each axis, and the moved mass within what the pair can carry.
#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "benchmark/peers/peer.h"

namespace stack::peers {
namespace {

using Pairs = std::vector<std::vector<Pair>>;

/// Ten terms a line: readers of this format have lines of limited length.
class Sum {
 public:
  explicit Sum(std::ofstream& out) : out_(out) {}
  void add(double factor, std::size_t axis, std::size_t pair) {
    out_ << fmt::format("{:+.12g} z{}_{} ", factor, axis, pair) << (++terms_ % 10 == 0 ? "\n" : "");
  }

 private:
  std::ofstream& out_;
  int terms_ = 0;
};

void write_model(const Instance& instance, const Pairs& pairs, const std::filesystem::path& file) {
  std::ofstream out(file);
  out << "Minimize\n cost: ";
  Sum cost(out);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t p = 0; p < pairs[i].size(); ++p) cost.add(pairs[i][p].cost, i, p);
  out << "\nSubject To\n";
  double carriages = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    carriages += instance.axes[i].carriage;
    out << " one" << i << ": ";
    Sum one(out);
    for (std::size_t p = 0; p < pairs[i].size(); ++p) one.add(1.0, i, p);
    out << "= 1\n carry" << i << ": ";
    Sum carry(out);
    for (std::size_t p = 0; p < pairs[i].size(); ++p) carry.add(pairs[i][p].capacity, i, p);
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t p = 0; p < pairs[j].size(); ++p) carry.add(-pairs[j][p].mass, j, p);
    out << fmt::format(">= {:.12g}\n", carriages);
  }
  out << "Binaries\n";
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t p = 0; p < pairs[i].size(); ++p) out << fmt::format(" z{}_{}\n", i, p);
  out << "End\n";
}

/// Binaries at one; whether CBC calls them optimal.
bool read_solution(const std::filesystem::path& file, const Instance& instance, const Pairs& pairs, Design& design) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  const bool optimal = line.rfind("Optimal", 0) == 0;
  while (std::getline(in, line)) {
    const std::size_t name = line.find('z');
    if (name == std::string::npos) continue;
    std::istringstream fields(line.substr(name + 1));
    std::size_t axis = 0, pair = 0;
    char separator = 0;
    double value = 0.0;
    if (!(fields >> axis >> separator >> pair >> value) || value < 0.5) continue;
    const Pair& chosen = pairs[axis][pair];
    if (design.size() <= axis) design.resize(axis + 1);
    design[axis] = {
        chosen.screw,
        chosen.motor,
        best_ramp(instance.axes[axis], instance.screws.row(chosen.screw), instance.motors.row(chosen.motor)).first};
  }
  return optimal;
}

}  // namespace

Peer cbc(bool useful_only) {
  return {useful_only ? "CBC, table, useful pairs" : "CBC, table, all pairs",
          "coinor-cbc",
          on_path("cbc"),
          [useful_only](const Question& question, const Report& report) {
            const Pairs& pairs = useful_only ? question.table.useful : question.table.all;
            const auto model = question.folder / "stack.lp", solution = question.folder / "stack.solution";
            write_model(question.instance, pairs, model);
            each_line(fmt::format("cbc '{}' sec {} ratio 0 solve solution '{}' 2>&1",
                                  model.string(),
                                  question.seconds,
                                  solution.string()),
                      [](const std::string&) {});
            Design design;
            const bool optimal = read_solution(solution, question.instance, pairs, design);
            if (design.size() != question.instance.axes.size()) return;
            report.found(design);
            if (optimal) report.claim();
          }};
}

}  // namespace stack::peers
