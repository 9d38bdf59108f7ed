// SPDX-License-Identifier: Apache-2.0
#include "text/large_pages.h"

#include <sys/mman.h>

#include <cstdint>

namespace millwright::text {

void prefer_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::uintptr_t small_page = 4096;
  constexpr std::size_t large_page = std::size_t{2} << 20U;
  if (bytes < 2 * large_page) return;
  const auto first = (reinterpret_cast<std::uintptr_t>(begin) + small_page - 1) / small_page * small_page;
  const auto end = (reinterpret_cast<std::uintptr_t>(begin) + bytes) / small_page * small_page;
  ::madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

}  // namespace millwright::text
