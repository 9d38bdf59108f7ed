// SPDX-License-Identifier: Apache-2.0
// A search ends itself before it has taken all memory.
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <nlohmann/json.hpp>

#include "app/memory_watch.h"
#include "catch.h"
#include "program.h"
#include "sanitized.h"

namespace memory_test {

using namespace millwright::app;

namespace {

constexpr std::uint64_t mb = 1U << 20U;

/// Files as Linux writes them, below a folder of the test.
struct Told {
  explicit Told(std::uint64_t pages) {
    shop.write("proc/meminfo", "MemTotal:       1048576 kB\nMemFree:          10000 kB\nMemAvailable:     524288 kB\n");
    shop.write("proc/self/statm", fmt::format("900000 {} 700 300 0 800000 0\n", pages));
  }
  [[nodiscard]] MemoryState state() const {
    const auto state = memory_state(shop.path(""));
    REQUIRE(state);
    return *state;
  }
  Workshop shop;
};

}  // namespace

TEST_CASE("Memory is what is told of process, machine and control groups") {
  const Told told(1000);
  CHECK(told.state().taken == 1000U * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)));
  CHECK(told.state().all == 1024 * mb);
  CHECK(told.state().available == 512 * mb);
  SECTION("version 2: the least limit of all groups above counts") {
    told.shop.write("proc/self/cgroup", "0::/user.slice/job\n");
    told.shop.write("sys/fs/cgroup/user.slice/job/memory.max", "max\n");
    CHECK(told.state().all == 1024 * mb);
    told.shop.write("sys/fs/cgroup/user.slice/memory.max", fmt::format("{}\n", 256 * mb));
    CHECK(told.state().all == 256 * mb);
    told.shop.write("sys/fs/cgroup/memory.max", fmt::format("{}\n", 128 * mb));
    CHECK(told.state().all == 128 * mb);
  }
  SECTION("version 1: memory is a controller among others") {
    told.shop.write("proc/self/cgroup", "8:pids:/a\n4:cpu,memory:/a\n0::/\n");
    told.shop.write("sys/fs/cgroup/memory/a/memory.limit_in_bytes", fmt::format("{}\n", 64 * mb));
    CHECK(told.state().all == 64 * mb);
  }
  SECTION("more than the machine has is no limit") {
    told.shop.write("proc/self/cgroup", "0::/\n");
    told.shop.write("sys/fs/cgroup/memory.max", "9223372036854771712\n");
    CHECK(told.state().all == 1024 * mb);
  }
  SECTION("what is not told is not guessed") {
    told.shop.write("proc/meminfo", "MemTotal: 1048576 kB\n");
    CHECK_FALSE(memory_state(told.shop.path("")));
    CHECK_FALSE(memory_state(told.shop.path("nowhere")));
  }
}

TEST_CASE("Too much is what is asked, or most of what there is") {
  CHECK_FALSE(is_too_much({99, 100, 0}, 100));
  CHECK(is_too_much({100, 1000, 900}, 100));
  CHECK_FALSE(is_too_much({799, 1000, 200}, 0));
  CHECK(is_too_much({800, 1000, 200}, 0));
  CHECK_FALSE(is_too_much({500, 1000, 50}, 0));
  CHECK(is_too_much({500, 1000, 49}, 0));
  CHECK_FALSE(is_too_much({499, 1000, 0}, 0));  // others take it
}

TEST_CASE("A watch calls once, and ends when it is told to") {
  std::atomic<int> calls{0};
  {
    const MemoryWatch watch(1, [&](const MemoryState& state) {
      CHECK(state.taken >= 1);
      ++calls;
    });
    const auto start = std::chrono::steady_clock::now();
    while (calls == 0 && std::chrono::steady_clock::now() - start < std::chrono::minutes(1)) usleep(1000);
    usleep(350'000);  // it looks every tenth of a second
  }
  CHECK(calls == 1);
  {
    const MemoryWatch watch(std::uint64_t{1} << 60U, [&](const MemoryState&) { ++calls; });
    usleep(350'000);
  }
  CHECK(calls == 1);
}

namespace {

/// A front that takes half an hour and 20 GB, if it may.
Outcome front_within(const Workshop& shop, const char* gigabytes) {
  return shop.run({"pareto",
                   MILLWRIGHT_SOURCE_DIR "/problems/router.toml",
                   "--minimise",
                   "cost,energy",
                   "--memory-limit",
                   gigabytes,
                   "--json",
                   "-"});
}

}  // namespace

TEST_CASE("A search that takes too much says what it knows, and why it ended") {
  const Workshop shop;
  const Outcome front = front_within(shop, "0.001");
  CAPTURE(front.err);
  CHECK(front.exit_code == 3);
  CHECK(nlohmann::json::parse(front.out).at("status") == "limit");
  CHECK(front.says("GB of memory and was told to end"));
  CHECK(front.says("--memory-limit"));
}

TEST_CASE("A front that has used up the memory goes on for a while with what it gave back") {
  if (millwright::sanitized) return;  // their allocator gives nothing back
  const Workshop shop;
  const Outcome front = front_within(shop, "0.18");
  CAPTURE(front.err);
  CHECK(front.exit_code == 3);
  const auto result = nlohmann::json::parse(front.out);
  CHECK(result.at("status") == "limit");
  CHECK(result.at("front").size() >= 1);
  const std::string method = result.at("certificate").at("method");
  CHECK(method.find("when memory was used up, the best by each objective") != std::string::npos);
  CHECK(front.says("what is said was known by then, or found in a shorter search from there"));
}

}  // namespace memory_test
