// SPDX-License-Identifier: Apache-2.0
#include "app/memory_watch.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <fstream>
#include <limits>
#include <mutex>
#include <new>
#include <string>
#include <system_error>

namespace millwright::app {
namespace {

/// The number after `name` in a file of lines "name number"; nothing if there is none.
std::optional<std::uint64_t> number_after(const std::filesystem::path& file, const std::string& name) {
  std::ifstream lines(file);
  std::string word;
  std::uint64_t number = 0;
  while (lines >> word)
    if (word == name && lines >> number) return number;
  return std::nullopt;
}

/// A limit in a file of its own; "max" is none.
std::uint64_t limit_in(const std::filesystem::path& file) {
  std::uint64_t limit = 0;
  return std::ifstream(file) >> limit ? limit : std::numeric_limits<std::uint64_t>::max();
}

/// The least limit of a control group and all groups above it.
std::uint64_t limit_of_group(const std::filesystem::path& tree, std::filesystem::path group, const char* file) {
  std::uint64_t least = limit_in(tree / file);
  for (; !group.empty(); group = group.parent_path()) least = std::min(least, limit_in(tree / group / file));
  return least;
}

/// A line is "hierarchy:controllers:/group": of version 2 it has no controllers, of version 1 memory may be one.
std::uint64_t limit_of_groups(const std::filesystem::path& root) {
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const std::filesystem::path group = std::filesystem::path(line.substr(second + 1)).relative_path();
    if (controllers == ",,")
      least = std::min(least, limit_of_group(root / "sys/fs/cgroup", group, "memory.max"));
    else if (controllers.find(",memory,") != std::string::npos)
      least = std::min(least, limit_of_group(root / "sys/fs/cgroup/memory", group, "memory.limit_in_bytes"));
  }
  return least;
}

void watch(std::uint64_t limit,
           const std::function<void(const MemoryState&)>& on_too_much,
           const std::stop_token& ended) {
  constexpr std::chrono::milliseconds interval(100);  // the fastest searches take 100 MB in that time
  std::mutex mutex;
  std::condition_variable_any wakes;
  std::unique_lock lock(mutex);
  while (!wakes.wait_for(lock, ended, interval, [] { return false; }) && !ended.stop_requested()) {
    const auto state = memory_state();
    if (!state) return;
    if (!is_too_much(*state, limit)) continue;
    on_too_much(*state);
    return;
  }
}

}  // namespace

std::optional<MemoryState> memory_state(const std::filesystem::path& root) {
  constexpr std::uint64_t kilobyte = 1024;
  std::uint64_t pages_reserved = 0, pages_taken = 0;
  const auto all = number_after(root / "proc/meminfo", "MemTotal:");
  const auto available = number_after(root / "proc/meminfo", "MemAvailable:");
  if (!all || !available || !(std::ifstream(root / "proc/self/statm") >> pages_reserved >> pages_taken)) return {};
  return MemoryState{pages_taken * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)),
                     std::min(*all * kilobyte, limit_of_groups(root)),
                     *available * kilobyte};
}

bool is_too_much(const MemoryState& state, std::uint64_t limit) {
  if (limit > 0) return state.taken >= limit;
  return state.taken >= state.all / 5 * 4 || (state.taken >= state.all / 2 && state.available < state.all / 20);
}

MemoryWatch::MemoryWatch(std::uint64_t limit, std::function<void(const MemoryState&)> on_too_much) {
  try {
    thread_ = std::jthread([limit, on_too_much = std::move(on_too_much)](const std::stop_token& ended) {
      try {
        watch(limit, on_too_much, ended);
      } catch (const std::bad_alloc&) {  // the search will notice, and say so
      }
    });
  } catch (const std::system_error&) {  // no more threads: better a search without a watch than none
  }
}

}  // namespace millwright::app
