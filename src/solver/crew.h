// SPDX-License-Identifier: Apache-2.0
//
// A few threads that work on the items of a batch and wait for each other at its end. Which thread does which item
// does not matter, because items do not see each other's results: the answer is the same for any number of threads.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace millwright::solver {

class Crew {
 public:
  explicit Crew(unsigned threads);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  [[nodiscard]] unsigned size() const { return static_cast<unsigned>(helpers_.size()) + 1; }
  /// work(item, thread) for every item < count; rethrows the first exception.
  void run(std::size_t count, const std::function<void(std::size_t item, unsigned thread)>& work);

 private:
  void help(unsigned thread);
  void take_items(unsigned thread);

  std::mutex mutex_;
  std::condition_variable start_, done_;
  const std::function<void(std::size_t, unsigned)>* work_ = nullptr;
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_{0};
  std::uint64_t batch_ = 0;
  unsigned busy_ = 0;
  bool ending_ = false;
  std::exception_ptr failure_;
  std::vector<std::thread> helpers_;
};

}  // namespace millwright::solver
