// SPDX-License-Identifier: Apache-2.0
#include "solver/crew.h"

#include <system_error>

namespace millwright::solver {

Crew::Crew(unsigned threads) {
  try {
    for (unsigned thread = 1; thread < threads; ++thread) helpers_.emplace_back([this, thread] { help(thread); });
  } catch (const std::system_error&) {
    // The system has no more threads: fewer do the same.
  }
}

Crew::~Crew() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  start_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void Crew::take_items(unsigned thread) {
  for (std::size_t item = next_.fetch_add(1); item < count_; item = next_.fetch_add(1)) {
    try {
      (*work_)(item, thread);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }
}

void Crew::help(unsigned thread) {
  std::uint64_t seen = 0;
  std::unique_lock lock(mutex_);
  while (true) {
    start_.wait(lock, [&] { return ending_ || batch_ != seen; });
    if (ending_) return;
    seen = batch_;
    lock.unlock();
    take_items(thread);
    lock.lock();
    if (--busy_ == 0) done_.notify_one();
  }
}

void Crew::run(std::size_t count, const std::function<void(std::size_t, unsigned)>& work) {
  if (helpers_.empty() || count < 2) {
    for (std::size_t item = 0; item < count; ++item) work(item, 0);
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    work_ = &work;
    count_ = count;
    next_ = 0;
    busy_ = static_cast<unsigned>(helpers_.size());
    ++batch_;
  }
  start_.notify_all();
  take_items(0);
  std::unique_lock lock(mutex_);
  done_.wait(lock, [&] { return busy_ == 0; });
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

}  // namespace millwright::solver
