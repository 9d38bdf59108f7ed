// SPDX-License-Identifier: Apache-2.0
// MiniZinc with Gecode, on the prepared table and on the physics. Costs are whole ten-thousandths, masses whole
// milligrams (what is carried rounded up, what can be carried down).
#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "benchmark/peers/peer.h"

namespace stack::peers {
namespace {

constexpr double cost_scale = 1e4, mass_scale = 1e6;

template <class Of>
void write_array(std::ofstream& out, const std::string& head, std::size_t size, Of of) {
  out << fmt::format("array[1..{}] of {} = [", size, head);
  for (std::size_t i = 0; i < size; ++i) out << (i > 0 ? "," : "") << of(i) << (i % 20 == 19 ? "\n" : "");
  out << "];\n";
}

std::string whole(double x) { return fmt::format("{:.0f}", x); }
/// MiniZinc takes a number without a point for an integer.
std::string real(double x) {
  const std::string text = fmt::format("{:.17g}", x);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

void run(const Question& question,
         const Report& report,
         const std::filesystem::path& model,
         const std::function<Choice(std::size_t axis, std::istringstream& fields)>& choice) {
  bool found = false;
  each_line(
      fmt::format("minizinc --solver gecode -a --time-limit {:.0f} '{}' 2>&1", 1e3 * question.seconds, model.string()),
      [&](const std::string& line) {
        if (line.rfind("==========", 0) == 0 && found) report.claim();
        if (line.rfind("chosen", 0) != 0) return;
        std::istringstream fields(line.substr(6));
        Design design;
        for (std::size_t i = 0; i < question.instance.axes.size(); ++i) design.push_back(choice(i, fields));
        report.found(design);
        found = true;
      });
}

Choice with_best_ramp(const Instance& instance, std::size_t axis, std::uint32_t screw, std::uint32_t motor) {
  return {screw, motor, best_ramp(instance.axes[axis], instance.screws.row(screw), instance.motors.row(motor)).first};
}

void write_table_model(const Question& question,
                       const std::vector<std::vector<Pair>>& pairs,
                       const std::filesystem::path& file) {
  std::ofstream out(file);
  std::string costs, chosen, shown, carried;
  double carriages = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& of = pairs[i];
    write_array(
        out, fmt::format("int: cost{}", i), of.size(), [&](std::size_t p) { return whole(cost_scale * of[p].cost); });
    write_array(out, fmt::format("int: mass{}", i), of.size(), [&](std::size_t p) {
      return whole(std::ceil(mass_scale * of[p].mass));
    });
    write_array(out, fmt::format("int: most{}", i), of.size(), [&](std::size_t p) {
      return whole(std::floor(mass_scale * std::min(of[p].capacity, 1e3)));
    });
    carriages += question.instance.axes[i].carriage;
    const std::string name = std::to_string(i);
    out << "var 1.." << of.size() << ": p" << name << ";\n";
    out << "constraint " << whole(std::ceil(mass_scale * carriages)) << carried << " <= most" << name << "[p" << name
        << "];\n";
    carried += " + mass" + name + "[p" + name + "]";
    costs += (i > 0 ? " + cost" : "cost") + name + "[p" + name + "]";
    chosen += (i > 0 ? ", p" : "p") + name;
    shown += ", \" \", show(p" + name + ")";
  }
  out << "solve :: int_search([" << chosen << "], input_order, indomain_min) minimize " << costs << ";\n";
  out << "output [\"chosen\"" << shown << ", \"\\n\"];\n";
}

/// The equations of stack_model.h, with the columns of the chosen rows as variables.
void write_physics_model(const Question& question, const std::filesystem::path& file) {
  const Instance& instance = question.instance;
  std::ofstream out(file);
  std::string costs, chosen, ramps, shown, above = "0.0";
  for (std::size_t j = 0; j < motor_width - 1; ++j)
    write_array(out, fmt::format("float: motor{}", j), instance.motors.rows(), [&](std::size_t row) {
      return real(instance.motors.row(static_cast<std::uint32_t>(row))[j]);
    });
  write_array(out, "int: motor_cost", instance.motors.rows(), [&](std::size_t row) {
    return whole(cost_scale * instance.motors.row(static_cast<std::uint32_t>(row))[motor_price]);
  });
  for (std::size_t i = 0; i < instance.axes.size(); ++i) {
    const Axis& a = instance.axes[i];
    const Columns cut = cut_screws(instance.screws, a.length);
    const char* names[] = {"l", "d", "e", "ms", "js"};
    for (std::size_t j = 0; j < cut_price; ++j)
      write_array(out, fmt::format("float: {}_of{}", names[j], i), cut.rows(), [&](std::size_t row) {
        return real(cut.row(static_cast<std::uint32_t>(row))[j]);
      });
    write_array(out, fmt::format("int: screw_cost{}", i), cut.rows(), [&](std::size_t row) {
      return whole(cost_scale * cut.row(static_cast<std::uint32_t>(row))[cut_price]);
    });
    out << fmt::format("var 1..{}: s{};\nvar 1..{}: q{};\n", cut.rows(), i, instance.motors.rows(), i);
    const auto channel = [&](const std::string& name, const Columns& table, std::size_t column, const std::string& of) {
      double least = table.row(0)[column], most = least;
      for (std::uint32_t n = 0; n < table.rows(); ++n) {
        least = std::min(least, table.row(n)[column]);
        most = std::max(most, table.row(n)[column]);
      }
      out << fmt::format("var {}..{}: {} = {};\n", real(least), real(most), name, of);
    };
    for (std::size_t j = 0; j < cut_price; ++j)
      channel(fmt::format("{}{}", names[j], i), cut, j, fmt::format("{}_of{}[s{}]", names[j], i, i));
    for (std::size_t j = 0; j < motor_width - 1; ++j)
      channel(fmt::format("m{}_{}", j, i), instance.motors, j, fmt::format("motor{}[q{}]", j, i));
    constexpr double pi = std::numbers::pi, young = 206e9, shear = 79e9, density = 7850.0;
    const double longest = a.longest_ramp();
    out << fmt::format("var {}..{}: t{};\nvar 0.0..1000.0: m{} = {} + {};\n",
                       real(a.shortest_ramp()),
                       real(longest),
                       i,
                       i,
                       above,
                       real(a.carriage));
    out << fmt::format("var {}..{}: v{} = {} / ({} - t{});\n",
                       real(a.stroke / a.move_time),
                       real(a.stroke / (a.move_time - longest)),
                       i,
                       real(a.stroke),
                       real(a.move_time),
                       i);
    out << fmt::format("var 0.0..10000.0: a{} = v{} / t{};\n", i, i, i);
    out << fmt::format("var 1.0..100000.0: r{} = {} / l{};\n", i, real(2.0 * pi), i);
    out << fmt::format("var 0.0..1.0: jl{} = js{} + m{} / (r{} * r{});\n", i, i, i, i, i);
    out << fmt::format(
        "var 0.0..100000.0: f{} = {} + m{} * {};\n", i, real(a.force), i, real(9.81 * (a.friction + a.gravity)));
    out << fmt::format("var 0.0..1000.0: ts{} = f{} / (r{} * e{}) + jl{} * a{} * r{};\n", i, i, i, i, i, i, i);
    out << fmt::format("var 0.0..1.0: d2_{} = d{} * d{};\n", i, i, i);
    out << fmt::format("var 0.0..10000.0: x{} = v{} * r{} / m1_{};\n", i, i, i, i);
    out << fmt::format(
        "constraint (ts{} + m2_{} * a{} * r{}) * (1.0 + x{} * x{}) <= 0.7 * m0_{};\n", i, i, i, i, i, i, i);
    out << fmt::format("constraint jl{} <= 10.0 * m2_{};\n", i, i);
    const double whirl = 3.927 * 3.927 / (2.0 * pi * a.length * a.length) * std::sqrt(young / density) / 4.0;
    out << fmt::format("constraint v{} <= {} * d{} * l{};\n", i, real(0.8 * whirl), i, i);
    out << fmt::format("constraint f{} + m{} * a{} <= {} * d2_{} * d2_{};\n",
                       i,
                       i,
                       i,
                       real(pi * pi * young * pi / 64.0 / (a.length * a.length)),
                       i,
                       i);
    out << fmt::format(
        "constraint ts{} * {} <= d2_{} * d2_{};\n", i, real(a.length / (shear * pi / 32.0 * a.largest_twist)), i, i);
    out << fmt::format("constraint ts{} * {} <= d2_{} * d{};\n", i, real(16.0 / (pi * a.largest_shear)), i, i);
    above = fmt::format("m{} + ms{} + m3_{}", i, i, i);
    costs += fmt::format("{}screw_cost{}[s{}] + motor_cost[q{}]", i > 0 ? " + " : "", i, i, i);
    chosen += fmt::format("{}s{}, q{}", i > 0 ? ", " : "", i, i);
    ramps += fmt::format("{}t{}", i > 0 ? ", " : "", i);
    shown += fmt::format(", \" \", show(s{}), \" \", show(q{})", i, i);
  }
  out << "var int: cost = " << costs << ";\n";
  out << "solve :: seq_search([int_search([" << chosen << "], first_fail, indomain_min), float_search([" << ramps
      << "], 0.0001, input_order, indomain_split)]) minimize cost;\n";
  out << "output [\"chosen\"" << shown << ", \"\\n\"];\n";
}

}  // namespace

Peer minizinc_table(bool useful_only) {
  return {useful_only ? "Gecode, table, useful pairs" : "Gecode, table, all pairs",
          "minizinc",
          on_path("minizinc"),
          [useful_only](const Question& question, const Report& report) {
            const auto& pairs = useful_only ? question.table.useful : question.table.all;
            const auto model = question.folder / "table.mzn";
            write_table_model(question, pairs, model);
            run(question, report, model, [&](std::size_t axis, std::istringstream& fields) {
              std::size_t p = 1;
              fields >> p;
              const Pair& pair = pairs[axis].at(p - 1);
              return with_best_ramp(question.instance, axis, pair.screw, pair.motor);
            });
          }};
}

/// Its ramps are intervals: checked are the rows that it chose, with the ramp that suits them best.
Peer minizinc_physics() {
  return {"Gecode, physics", "minizinc", on_path("minizinc"), [](const Question& question, const Report& report) {
            const auto model = question.folder / "physics.mzn";
            write_physics_model(question, model);
            run(question, report, model, [&](std::size_t axis, std::istringstream& fields) {
              std::uint32_t screw = 1, motor = 1;
              fields >> screw >> motor;
              return with_best_ramp(question.instance, axis, screw - 1, motor - 1);
            });
          }};
}

}  // namespace stack::peers
