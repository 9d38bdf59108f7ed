// SPDX-License-Identifier: Apache-2.0
// How large a table of parts may be. A hostile file costs memory by its cells, not its bytes: one of nothing but
// separators is a cell a byte, and a cell costs its place and mostly a number, 12 bytes. So cells are limited too, and
// a large file costs at most three times its size.
#pragma once

#include <cstddef>
#include <cstdint>

namespace millwright::text {

inline constexpr std::uintmax_t table_size_limit = std::uintmax_t{1} << 30U;
/// A million parts with a hundred columns, and more.
inline constexpr std::size_t table_cell_limit = std::size_t{1} << 27U;

}  // namespace millwright::text
