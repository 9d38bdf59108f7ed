// SPDX-License-Identifier: Apache-2.0
// Large memory in large pages: when a big file is read, being given memory in small pages, each when it is first
// touched, took a third of the time.
#pragma once

#include <cstddef>
#include <vector>

namespace millwright::text {

/// Asks for large pages in memory that nothing was written to yet. A wish: where the system has none, nothing is lost,
/// and less than a few of them is not worth asking.
void prefer_large_pages(void* begin, std::size_t bytes);

/// Makes room in an empty vector, in large pages if it is large.
template <class T>
void reserve_large(std::vector<T>& empty, std::size_t count) {
  empty.reserve(count);
  prefer_large_pages(empty.data(), empty.capacity() * sizeof(T));
}

}  // namespace millwright::text
