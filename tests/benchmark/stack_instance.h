// SPDX-License-Identifier: Apache-2.0
//
// Instances of stack_model.h: seeded random ones in the proportions of real catalogues, and those read from a folder
// with axes.csv, screws.csv and motors.csv (SI, but diameters and leads in mm).
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>

#include "benchmark/stack_model.h"
#include "text/csv.h"

namespace stack {

class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}
  double between(double a, double b) { return a + (b - a) * static_cast<double>(generator_() >> 11U) * 0x1p-53; }
  template <std::size_t N>
  double one_of(const double (&values)[N]) {
    return values[static_cast<std::size_t>(between(0.0, static_cast<double>(N)))];
  }
  /// Of about normal distribution: twelve uniform numbers.
  double normal(double deviation) {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += between(0.0, 1.0);
    return deviation * sum;
  }

 private:
  std::mt19937_64 generator_;
};

inline double rounded(double x, double to) { return std::round(x / to) * to; }

/// Ball screws and trapezoidal ones, in three accuracies, some with a hollow shaft: lighter and dearer.
inline void add_screw(Random& random, Columns& screws) {
  const double diameters[] = {8, 10, 12, 14, 16, 18, 20, 22, 25, 28, 32, 36, 40};
  const double leads[] = {1, 2, 2.5, 4, 5, 8, 10, 16, 20, 25};
  double d = 0.0, pitch = 0.0;
  do {
    d = random.one_of(diameters);
    pitch = random.one_of(leads);
  } while (pitch > 1.6 * d || pitch < 0.04 * d);
  d = rounded(d + random.between(-0.4, 0.4), 0.01);
  const bool ball = random.between(0.0, 1.0) < 0.5;
  double share = random.between(0.80, 0.95);
  double depth = random.between(0.07, 0.13) * d + 0.3;
  if (!ball) {
    const double angle = std::atan(pitch / (std::numbers::pi * 0.9 * d));
    const double friction_angle = std::atan(random.between(0.10, 0.17));
    share = std::clamp(std::tan(angle) / std::tan(angle + friction_angle), 0.25, 0.80);
    depth = std::min(0.30 * d, 0.5 * std::min(pitch, 5.0) + 0.25 + random.between(0.0, 0.3));
  }
  const double core = rounded(d - depth, 0.001);
  const double hollow = random.between(0.6, 1.0);
  const double accuracy = std::floor(random.between(0.0, 3.0));
  const double solid = 7850.0 * std::numbers::pi / 4.0 * std::pow(0.5e-3 * (d + core), 2);
  const double per_length = (8.0 + 0.30 * std::pow(d, 1.45)) * (ball ? 2.6 : 1.0) * (1.0 + 0.45 * accuracy) *
                            random.between(0.75, 1.35) * (1.0 + 0.35 * (1.0 - hollow));
  const double ends =
      (6.0 + 0.05 * std::pow(d, 1.7)) * (ball ? 2.2 : 1.0) * (1.0 + 0.15 * accuracy) * random.between(0.75, 1.35);
  screws.numbers.insert(screws.numbers.end(),
                        {d * 1e-3,
                         pitch * 1e-3,
                         core * 1e-3,
                         rounded(share, 1e-4),
                         rounded(solid * hollow * random.between(0.97, 1.03), 1e-4),
                         rounded(ends, 0.01),
                         rounded(per_length, 0.01)});
}

/// Power-dense motors are light and dear.
inline void add_motor(Random& random, Columns& motors) {
  const double torque = std::exp(random.between(std::log(0.1), std::log(12.0)));
  const double density = random.normal(1.0);
  const double corner = random.between(30.0, 170.0) / (1.0 + 0.05 * torque);
  const double inertia = 1.9e-5 * std::pow(torque, 1.15) * std::exp(random.normal(0.20) - 0.10 * density);
  const double mass = 0.55 * std::pow(torque, 0.80) * std::exp(random.normal(0.10) - 0.30 * density);
  const double cost =
      (9.0 + 13.0 * std::pow(torque, 0.80)) * (0.7 + corner / 150.0) * std::exp(0.12 * density + random.normal(0.08));
  motors.numbers.insert(
      motors.numbers.end(),
      {rounded(torque, 1e-4), rounded(corner, 1e-3), rounded(inertia, 1e-9), rounded(mass, 1e-4), rounded(cost, 0.01)});
}

/// k axes, the first one upright.
inline Instance random_instance(int k, int screws, int motors, std::uint64_t seed) {
  Random random(seed);
  Instance instance;
  for (int i = 0; i < k; ++i) {
    Axis axis;
    const bool upright = i == 0;
    axis.stroke = upright ? random.between(0.10, 0.25) : random.between(0.25, 0.60);
    axis.length = axis.stroke + 0.15;
    axis.move_time = axis.stroke / (upright ? random.between(0.25, 0.40) : random.between(0.42, 0.62));
    axis.carriage = random.between(0.3, 1.0) + 0.2 * i;
    axis.force = random.between(5.0, 40.0);
    axis.friction = random.between(0.01, 0.10);
    axis.gravity = upright ? 1.0 : 0.0;
    axis.largest_twist = random.between(0.15, 0.6) * std::numbers::pi / 180.0;
    axis.largest_shear = random.between(25e6, 60e6);
    instance.axes.push_back(axis);
  }
  for (int i = 0; i < screws; ++i) add_screw(random, instance.screws);
  for (int i = 0; i < motors; ++i) add_motor(random, instance.motors);
  return instance;
}

/// The numbers of a file with a header, row by row. Throws std::runtime_error for a file that is no such table.
inline std::vector<double> read_numbers(const std::filesystem::path& file, std::size_t width) {
  using namespace millwright::text;
  Diagnostics diagnostics;
  const auto source = SourceText::load(file.string(), diagnostics);
  if (source == nullptr) throw std::runtime_error(format(diagnostics));
  const CsvTable table = read_csv(source, diagnostics);
  std::vector<std::size_t> columns(width);
  for (std::size_t i = 0; i < width; ++i) columns[i] = i;
  if (table.columns().size() != width) throw std::runtime_error(fmt::format("{}: {} columns", file.string(), width));
  const auto values = table.number_columns(columns, diagnostics);
  if (diagnostics.error_count() > 0) throw std::runtime_error(format(diagnostics));
  std::vector<double> numbers(width * table.row_count());
  for (std::size_t column = 0; column < width; ++column)
    for (std::size_t row = 0; row < table.row_count(); ++row) numbers[row * width + column] = values[column][row];
  return numbers;
}

inline Instance read_instance(const std::filesystem::path& folder) {
  Instance instance;
  constexpr std::size_t axis_width = 9;
  const std::vector<double> axes = read_numbers(folder / "axes.csv", axis_width);
  for (std::size_t i = 0; i < axes.size(); i += axis_width) {
    const double* a = axes.data() + i;
    instance.axes.push_back({a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8]});
  }
  instance.screws.numbers = read_numbers(folder / "screws.csv", screw_width);
  for (std::size_t i = 0; i < instance.screws.numbers.size(); i += screw_width)
    for (const std::size_t column : {diameter, lead, root}) instance.screws.numbers[i + column] *= 1e-3;
  instance.motors.numbers = read_numbers(folder / "motors.csv", motor_width);
  return instance;
}

inline void write_table(const std::filesystem::path& file,
                        const std::string& header,
                        const Columns& table,
                        std::size_t columns_in_mm) {
  std::ofstream out(file);
  out << header << "\n";
  for (std::uint32_t row = 0; row < table.rows(); ++row)
    for (std::size_t i = 0; i < table.width; ++i)
      out << fmt::format("{}{}", table.row(row)[i] * (i < columns_in_mm ? 1e3 : 1.0), i + 1 < table.width ? "," : "\n");
}

inline void write_instance(const Instance& instance, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream axes(folder / "axes.csv");
  axes << "stroke,length,move_time,carriage,force,friction,gravity,largest_twist,largest_shear\n";
  for (const Axis& a : instance.axes)
    axes << fmt::format("{},{},{},{},{},{},{},{},{}\n",
                        a.stroke,
                        a.length,
                        a.move_time,
                        a.carriage,
                        a.force,
                        a.friction,
                        a.gravity,
                        a.largest_twist,
                        a.largest_shear);
  write_table(folder / "screws.csv",
              "diameter_mm,lead_mm,root_mm,efficiency,mass_per_length,price,price_per_length",
              instance.screws,
              3);
  write_table(folder / "motors.csv", "holding_torque,corner_speed,rotor_inertia,mass,price", instance.motors, 0);
}

}  // namespace stack
