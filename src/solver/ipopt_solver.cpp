// SPDX-License-Identifier: Apache-2.0
#include "solver/ipopt_solver.h"

#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <cmath>
#include <mutex>

namespace millwright::solver {
namespace {

using Ipopt::Index;
using Ipopt::Number;

std::size_t size(Index n) { return static_cast<std::size_t>(n); }

class IpoptProblem : public Ipopt::TNLP {
 public:
  IpoptProblem(const LocalProblem& problem, std::span<const double> start)
      : problem_(problem),
        start_(start),
        constraint_(problem.constraints),
        gradient_(problem.lower.size()),
        jacobian_(problem.constraints * problem.lower.size()) {}

  std::optional<LocalSolution> solution;

  bool get_nlp_info(Index& n, Index& m, Index& jacobian, Index& hessian, IndexStyleEnum& style) override {
    n = static_cast<Index>(problem_.lower.size());
    m = static_cast<Index>(problem_.constraints);
    jacobian = n * m;
    hessian = n * (n + 1) / 2;
    style = C_STYLE;
    return true;
  }
  bool get_bounds_info(Index n, Number* x_lower, Number* x_upper, Index m, Number* g_lower, Number* g_upper) override {
    std::copy_n(problem_.lower.begin(), n, x_lower);
    std::copy_n(problem_.upper.begin(), n, x_upper);
    std::fill_n(g_lower, m, -2e19);  // Ipopt's minus infinity
    std::fill_n(g_upper, m, 0.0);
    return true;
  }
  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool, Number*) override {
    std::copy_n(start_.begin(), n, x);
    return true;
  }
  bool eval_f(Index n, const Number* x, bool, Number& value) override {
    value = at(n, x);
    return std::isfinite(value);
  }
  bool eval_grad_f(Index n, const Number* x, bool, Number* gradient) override {
    at(n, x);
    std::copy(gradient_.begin(), gradient_.end(), gradient);
    return std::all_of(gradient_.begin(), gradient_.end(), [](double v) { return std::isfinite(v); });
  }
  bool eval_g(Index n, const Number* x, bool, Index, Number* value) override {
    at(n, x);
    std::copy(constraint_.begin(), constraint_.end(), value);
    return std::all_of(constraint_.begin(), constraint_.end(), [](double v) { return std::isfinite(v); });
  }
  bool eval_jac_g(Index n, const Number* x, bool, Index m, Index, Index* row, Index* column, Number* value) override {
    if (value == nullptr) {
      for (Index i = 0; i < m; ++i) {
        for (Index j = 0; j < n; ++j) {
          *row++ = i;
          *column++ = j;
        }
      }
      return true;
    }
    at(n, x);
    std::copy(jacobian_.begin(), jacobian_.end(), value);
    return std::all_of(jacobian_.begin(), jacobian_.end(), [](double v) { return std::isfinite(v); });
  }
  bool intermediate_callback(Ipopt::AlgorithmMode,
                             Index,
                             Number,
                             Number,
                             Number,
                             Number,
                             Number,
                             Number,
                             Number,
                             Number,
                             Index,
                             const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    return !problem_.stop || !problem_.stop();
  }
  void finalize_solution(Ipopt::SolverReturn,
                         Index n,
                         const Number* x,
                         const Number*,
                         const Number*,
                         Index,
                         const Number*,
                         const Number*,
                         Number value,
                         const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    solution = LocalSolution{{x, x + n}, value};
  }

 private:
  double at(Index n, const Number* x) { return problem_.function({x, size(n)}, constraint_, gradient_, jacobian_); }

  const LocalProblem& problem_;
  std::span<const double> start_;
  std::vector<double> constraint_, gradient_, jacobian_;
};

}  // namespace

std::optional<LocalSolution> solve_with_ipopt(const LocalProblem& problem, std::span<const double> start) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  try {
    const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
    application->Options()->SetStringValue("sb", "yes");
    application->Options()->SetIntegerValue("print_level", 0);
    application->Options()->SetNumericValue("tol", 1e-10);
    application->Options()->SetIntegerValue("max_iter", 200);
    application->Options()->SetStringValue("hessian_approximation", "limited-memory");
    if (application->Initialize("") != Ipopt::Solve_Succeeded) return std::nullopt;
    std::vector<double> inside(start.begin(), start.end());
    for (std::size_t i = 0; i < inside.size(); ++i)
      inside[i] = std::clamp(inside[i], problem.lower[i], problem.upper[i]);
    IpoptProblem* adapter = new IpoptProblem(problem, inside);
    const Ipopt::SmartPtr<Ipopt::TNLP> owner = adapter;
    application->OptimizeTNLP(owner);
    return adapter->solution;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace millwright::solver
