// SPDX-License-Identifier: Apache-2.0
#pragma once

// The columns of families that are cut from what is sold by length: how it is sold, and what cutting it takes.

#include "catalogue/column.h"

namespace millwright::catalogue::columns {

inline constexpr ColumnDeclaration stock_length =
    number("stock_length",
           "mm",
           Need::optional,
           100,
           20000,
           "length that is sold: only whole bars (belts: reels) of it, which pieces are cut from");
inline constexpr ColumnDeclaration cutting_loss =
    number("cutting_loss", "mm", Need::optional, 0, 50, "length that is lost, and paid, with every piece that is cut");
inline constexpr ColumnDeclaration cut_price = money("cut_price", "", "price of cutting one piece to length");
inline constexpr ColumnDeclaration end_machining_price =
    money("end_machining_price", "", "price of machining one end of a screw for its bearing");

}  // namespace millwright::catalogue::columns
