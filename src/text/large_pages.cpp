// SPDX-License-Identifier: Apache-2.0
#include "text/large_pages.h"

#include <sys/mman.h>

#include <cstdint>

namespace millwright::text {

void prefer_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::size_t small_page = 4096;
  constexpr std::size_t large_page = std::size_t{2} << 20U;
  if (bytes < 2 * large_page) return;
  const std::size_t before_page = (small_page - reinterpret_cast<std::uintptr_t>(begin) % small_page) % small_page;
  const std::size_t whole_pages = (bytes - before_page) / small_page * small_page;
  ::madvise(static_cast<char*>(begin) + before_page, whole_pages, MADV_HUGEPAGE);
#endif
}

}  // namespace millwright::text
