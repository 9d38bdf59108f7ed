// SPDX-License-Identifier: Apache-2.0
// Bonmin on the physics: a binary for each row of each table and axis; the columns of the chosen rows are variables, in
// which the constraints of stack_model.h are stated as they are.
#include "benchmark/peers/peer.h"

#ifdef MILLWRIGHT_WITH_BONMIN
#include <BonBonminSetup.hpp>
#include <BonCbc.hpp>
#include <BonTMINLP.hpp>
#include <cstring>

namespace stack::peers {
namespace {

using Ipopt::Index;
using Ipopt::Number;

/// Numbers that the constraints of an axis read, besides the prices: variables of the relaxation.
constexpr int screw_reads = cut_width, motor_reads = motor_width;
enum Read { read_ramp = screw_reads + motor_reads, read_above, read_width };

using Slope = millwright::scalar::Dual<double, read_width>;

/// Input of an AxisModel whose rows are numbers of their own.
struct Columned {
  std::span<const Slope> numbers;
  [[nodiscard]] Slope row(std::size_t slot, std::size_t column) const {
    return numbers[slot == screw_slot ? column : cut_width + column];
  }
  [[nodiscard]] const Slope& variable(std::size_t) const { return numbers[read_ramp]; }
  [[nodiscard]] const Slope& state(std::size_t) const { return numbers[read_above]; }
};

/// Variables of an axis: binaries of its screws and motors, then its numbers, each in units of its largest. Constraints
/// of an axis: one screw, one motor, its columns, the mass from the axis above, and the model's own.
class Program : public Bonmin::TMINLP {
 public:
  explicit Program(const Instance& instance) : instance_(instance) {
    for (const Axis& axis : instance.axes) {
      screws_.push_back(cut_screws(instance.screws, axis.length));
      std::vector<double> unit(read_width, 1.0);
      for (std::size_t c = 0; c < cut_width; ++c) unit[c] = largest(screws_.back(), c);
      for (std::size_t c = 0; c < motor_width; ++c) unit[cut_width + c] = largest(instance.motors, c);
      units_.push_back(unit);
    }
    rows_ = static_cast<Index>(instance.screws.rows() + instance.motors.rows());
    for_each_entry([&](Index row, Index column, double) { entries_.push_back({row, column}); });
  }

  Design design;
  bool claimed = false;

  bool get_nlp_info(Index& n, Index& m, Index& jacobian, Index& hessian, Ipopt::TNLP::IndexStyleEnum& style) override {
    n = axes() * width();
    m = axes() * height();
    jacobian = static_cast<Index>(entries_.size());
    hessian = 0;
    style = Ipopt::TNLP::C_STYLE;
    return true;
  }
  bool get_variables_types(Index n, VariableType* types) override {
    for (Index i = 0; i < n; ++i) types[i] = i % width() < rows_ ? BINARY : CONTINUOUS;
    return true;
  }
  bool get_variables_linearity(Index n, Ipopt::TNLP::LinearityType* types) override {
    for (Index i = 0; i < n; ++i) types[i] = i % width() < rows_ ? Ipopt::TNLP::LINEAR : Ipopt::TNLP::NON_LINEAR;
    return true;
  }
  bool get_constraints_linearity(Index m, Ipopt::TNLP::LinearityType* types) override {
    for (Index i = 0; i < m; ++i)
      types[i] = i % height() < linear_height ? Ipopt::TNLP::LINEAR : Ipopt::TNLP::NON_LINEAR;
    return true;
  }
  bool get_bounds_info(Index n, Number* lower, Number* upper, Index m, Number* least, Number* most) override {
    for (Index i = 0; i < n; ++i) {
      lower[i] = 0.0;
      upper[i] = 1.0;
    }
    for (Index a = 0; a < axes(); ++a) {
      const auto at = static_cast<std::size_t>(a);
      Number* low = lower + number(a, 0);
      Number* high = upper + number(a, 0);
      for (std::size_t c = 0; c < cut_width; ++c) low[c] = smallest(screws_[at], c) / units_[at][c];
      for (std::size_t c = 0; c < motor_width; ++c)
        low[cut_width + c] = smallest(instance_.motors, c) / units_[at][cut_width + c];
      low[read_ramp] = instance_.axes[at].shortest_ramp();
      high[read_ramp] = instance_.axes[at].longest_ramp();
      high[read_above] = a == 0 ? 0.0 : 1e3;
    }
    for (Index i = 0; i < m; ++i) {
      const Index row = i % height();
      const auto a = static_cast<std::size_t>(i / height());
      least[i] = most[i] = row < 2 ? 1.0 : 0.0;
      if (row == linear_height - 1 && a > 0) least[i] = most[i] = instance_.axes[a - 1].carriage;
      if (row < linear_height) continue;
      least[i] = -1e20;
      most[i] = 1.0;
    }
    return true;
  }
  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool, Number*) override {
    std::fill(x, x + n, 0.0);
    for (Index a = 0; a < axes(); ++a) {
      const auto at = static_cast<std::size_t>(a);
      const auto screws = static_cast<Index>(instance_.screws.rows());
      const auto motors = static_cast<Index>(instance_.motors.rows());
      for (Index i = 0; i < rows_; ++i) x[a * width() + i] = i < screws ? 1.0 / screws : 1.0 / motors;
      Number* numbers = x + number(a, 0);
      for (std::size_t c = 0; c < cut_width; ++c) numbers[c] = mean(screws_[at], c) / units_[at][c];
      for (std::size_t c = 0; c < motor_width; ++c)
        numbers[cut_width + c] = mean(instance_.motors, c) / units_[at][cut_width + c];
      numbers[read_ramp] = 0.5 * (instance_.axes[at].shortest_ramp() + instance_.axes[at].longest_ramp());
      numbers[read_above] = 2.0 * a;
    }
    return true;
  }
  bool eval_f(Index, const Number* x, bool, Number& value) override {
    value = 0.0;
    for_each_price([&](Index i, double unit) { value += unit * x[i]; });
    return true;
  }
  bool eval_grad_f(Index n, const Number*, bool, Number* gradient) override {
    std::fill(gradient, gradient + n, 0.0);
    for_each_price([&](Index i, double unit) { gradient[i] = unit; });
    return true;
  }
  bool eval_g(Index, const Number* x, bool, Index m, Number* g) override {
    std::fill(g, g + m, 0.0);
    for_each_entry([&](Index row, Index column, double factor) { g[row] += factor * x[column]; });
    for (Index a = 0; a < axes(); ++a) {
      const auto answer = constraints_of(a, x);
      for (std::size_t c = 0; c < constraints; ++c)
        g[a * height() + linear_height + static_cast<Index>(c)] = answer[c].value;
    }
    return true;
  }
  bool eval_jac_g(Index, const Number* x, bool, Index, Index, Index* row, Index* column, Number* values) override {
    if (values == nullptr) {
      for (std::size_t e = 0; e < entries_.size(); ++e) {
        row[e] = entries_[e].first;
        column[e] = entries_[e].second;
      }
      return true;
    }
    std::vector<std::vector<Slope>> answers;
    for (Index a = 0; a < axes(); ++a) answers.push_back(constraints_of(a, x));
    std::size_t e = 0;
    for_each_entry([&](Index at, Index of, double factor) {
      const Index a = at / height();
      const Index within = at % height();
      if (within < linear_height) {
        values[e++] = factor;
        return;
      }
      const auto read = static_cast<std::size_t>(of - number(a, 0));
      values[e++] = answers[static_cast<std::size_t>(a)][static_cast<std::size_t>(within - linear_height)].slope[read] *
                    units_[static_cast<std::size_t>(a)][read];
    });
    return true;
  }
  bool eval_h(Index, const Number*, bool, Number, Index, const Number*, bool, Index, Index*, Index*, Number*) override {
    return false;  // Ipopt estimates it
  }
  void finalize_solution(Bonmin::TMINLP::SolverReturn status, Index, const Number* x, Number) override {
    claimed = status == Bonmin::TMINLP::SUCCESS;
    if (x == nullptr) return;
    design.clear();
    const auto screws = static_cast<Index>(instance_.screws.rows());
    for (Index a = 0; a < axes(); ++a) {
      const Number* own = x + a * width();
      const auto chosen = [&](Index from, Index to) {
        return static_cast<std::uint32_t>(std::max_element(own + from, own + to) - (own + from));
      };
      design.push_back({chosen(0, screws), chosen(screws, rows_), x[number(a, read_ramp)]});
    }
  }
  [[nodiscard]] const BranchingInfo* branchingInfo() const override { return nullptr; }
  [[nodiscard]] const SosInfo* sosConstraints() const override { return nullptr; }

 private:
  static constexpr Index linear_height = 2 + screw_reads + motor_reads + 1;

  [[nodiscard]] Index axes() const { return static_cast<Index>(instance_.axes.size()); }
  [[nodiscard]] Index width() const { return rows_ + read_width; }
  [[nodiscard]] static Index height() { return linear_height + static_cast<Index>(constraints); }
  [[nodiscard]] Index number(Index axis, Index read) const { return axis * width() + rows_ + read; }

  template <class Of>
  static double over(const Columns& table, std::size_t column, double start, Of of) {
    for (std::uint32_t i = 0; i < table.rows(); ++i) start = of(start, table.row(i)[column]);
    return start;
  }
  static double largest(const Columns& table, std::size_t column) {
    return over(table, column, 0.0, [](double a, double b) { return std::max(a, b); });
  }
  static double smallest(const Columns& table, std::size_t column) {
    return over(table, column, 1e300, [](double a, double b) { return std::min(a, b); });
  }
  static double mean(const Columns& table, std::size_t column) {
    return over(table, column, 0.0, [](double a, double b) { return a + b; }) / table.rows();
  }

  template <class Visit>
  void for_each_price(Visit visit) const {
    for (Index a = 0; a < axes(); ++a) {
      const auto at = static_cast<std::size_t>(a);
      visit(number(a, cut_price), units_[at][cut_price]);
      visit(number(a, screw_reads + motor_price), units_[at][screw_reads + motor_price]);
    }
  }

  /// Every place of the Jacobian, with its factor where it is constant and 0 where it is not.
  template <class Visit>
  void for_each_entry(Visit visit) const {
    const auto screws = static_cast<Index>(instance_.screws.rows());
    for (Index a = 0; a < axes(); ++a) {
      const auto at = static_cast<std::size_t>(a);
      const Index top = a * height(), left = a * width();
      for (Index i = 0; i < rows_; ++i) visit(top + (i < screws ? 0 : 1), left + i, 1.0);
      for (Index c = 0; c < screw_reads + motor_reads; ++c) {
        const bool of_screw = c < screw_reads;
        const auto column = static_cast<std::size_t>(of_screw ? c : c - screw_reads);
        for (Index i = of_screw ? 0 : screws; i < (of_screw ? screws : rows_); ++i) {
          const double* row = of_screw ? screws_[at].row(static_cast<std::uint32_t>(i))
                                       : instance_.motors.row(static_cast<std::uint32_t>(i - screws));
          visit(top + 2 + c, left + i, row[column] / units_[at][static_cast<std::size_t>(c)]);
        }
        visit(top + 2 + c, number(a, c), -1.0);
      }
      visit(top + linear_height - 1, number(a, read_above), a == 0 ? 0.0 : 1.0);
      if (a > 0) {
        const auto& unit = units_[at - 1];
        visit(top + linear_height - 1, number(a - 1, read_above), -1.0);
        visit(top + linear_height - 1, number(a - 1, cut_mass), -unit[cut_mass]);
        visit(top + linear_height - 1, number(a - 1, screw_reads + motor_mass), -unit[screw_reads + motor_mass]);
      }
      for (Index c = 0; c < static_cast<Index>(constraints); ++c)
        for (Index read = 0; read < read_width; ++read) visit(top + linear_height + c, number(a, read), 0.0);
    }
  }

  [[nodiscard]] std::vector<Slope> constraints_of(Index axis, const Number* x) const {
    const auto at = static_cast<std::size_t>(axis);
    std::vector<Slope> numbers;
    for (int read = 0; read < read_width; ++read) {
      const auto r = static_cast<std::size_t>(read);
      numbers.push_back(Slope::variable(x[number(axis, read)] * units_[at][r], read));
    }
    millwright::solver::Answer<Slope> answer;
    AxisModel{instance_.axes[at]}(Columned{numbers}, answer);
    return answer.utilisation;
  }

  const Instance& instance_;
  std::vector<Columns> screws_;             ///< [axis]
  std::vector<std::vector<double>> units_;  ///< [axis][read]
  Index rows_ = 0;                          ///< binaries of an axis
  std::vector<std::pair<Index, Index>> entries_;
};

void solve_with_bonmin(const std::string& algorithm, const Question& question, const Report& report) {
  Ipopt::SmartPtr<Program> program = new Program(question.instance);
  Bonmin::BonminSetup setup;
  setup.initializeOptionsAndJournalist();
  setup.options()->SetStringValue("bonmin.algorithm", algorithm);
  setup.options()->SetNumericValue("bonmin.time_limit", question.seconds);
  setup.options()->SetStringValue("hessian_approximation", "limited-memory");
  setup.options()->SetNumericValue("bonmin.allowable_fraction_gap", 0.0);
  setup.options()->SetNumericValue("bonmin.allowable_gap", 0.0);
  setup.initialize(GetRawPtr(program));
  Bonmin::Bab search;
  search(setup);
  if (program->design.empty()) return;
  report.found(program->design);
  if (program->claimed) report.claim();
}

}  // namespace

Peer bonmin(const std::string& algorithm) {
  return {
      "Bonmin " + algorithm + ", physics",
      "coinor-libbonmin-dev",
      true,
      [algorithm](const Question& question, const Report& report) { solve_with_bonmin(algorithm, question, report); }};
}

}  // namespace stack::peers
#else
namespace stack::peers {
Peer bonmin(const std::string& algorithm) {
  return {"Bonmin " + algorithm + ", physics", "coinor-libbonmin-dev", false, {}};
}
}  // namespace stack::peers
#endif
