// SPDX-License-Identifier: Apache-2.0
//
// What the benchmarks share: clock, median, and the machine that a table was measured on.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace measure {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Of this process, over all threads: what a solve on one thread takes alone on a core, also where others are busy.
inline double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// NaN of nothing.
inline double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Processor, cores, compiler, and how busy the machine is besides.
inline std::string machine() {
  std::string processor = "unknown processor", line;
  std::ifstream information("/proc/cpuinfo");
  while (std::getline(information, line)) {
    if (line.rfind("model name", 0) != 0 || line.find(": ") == std::string::npos) continue;
    processor = line.substr(line.find(": ") + 2);
    break;
  }
  double load = std::nan("");
  std::ifstream("/proc/loadavg") >> load;
#ifdef __clang__
  const std::string compiler = "clang " __clang_version__;
#else
  const std::string compiler = "g++ " __VERSION__;
#endif
  return fmt::format(
      "{}, {} cores, {}, load average {:.2f}", processor, std::thread::hardware_concurrency(), compiler, load);
}

}  // namespace measure
