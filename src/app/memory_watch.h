// SPDX-License-Identifier: Apache-2.0
//
// A search ends itself before the system ends it: a process that takes the last memory is killed, and what it knew is
// lost.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <thread>

namespace millwright::app {

/// Memory of this process and of what it runs in [bytes], as Linux tells it in files below `root`.
struct MemoryState {
  std::uint64_t taken = 0;      ///< by this process
  std::uint64_t all = 0;        ///< of the machine, or less where a control group (a container) gets less
  std::uint64_t available = 0;  ///< to whoever asks for more, on the machine
};

/// Nothing where it is not told.
std::optional<MemoryState> memory_state(const std::filesystem::path& root = "/");

/// Whether a search has to end: it has taken `limit` bytes; or, where that is 0, four fifths of what there is, or half
/// of it while next to nothing is available.
bool is_too_much(const MemoryState& state, std::uint64_t limit);

/// Gives the system back what was freed: it is kept for whoever asks next, otherwise (allocator.cpp). Null where the
/// sanitizers have an allocator of their own.
[[gnu::weak]] void give_memory_back();

/// While it lives, calls `on_too_much` once, from a thread of its own, when that is so.
class MemoryWatch {
 public:
  MemoryWatch(std::uint64_t limit, std::function<void(const MemoryState&)> on_too_much);

 private:
  std::jthread thread_;
};

}  // namespace millwright::app
