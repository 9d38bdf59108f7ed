// SPDX-License-Identifier: Apache-2.0
// An order list as files for a spreadsheet: CSV, or XLSX with live sums.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/order_list.h"
#include "text/diagnostic.h"

namespace millwright::report {

/// The lines, then shipping and top-up of each supplier that charges them, the total of each (if there are several) and
/// of everything, in lines without a number. Texts that a spreadsheet would take for a formula begin with an
/// apostrophe.
std::string order_csv(const OrderList& list);

/// The pieces to cut of each stock part, each part closed by its sum. Lengths in mm.
std::string cutting_csv(const OrderList& list);

/// Both as sheets of one workbook, the bytes of the file. Nothing, reported, if the temporary file that they take shape
/// in cannot be written.
std::optional<std::string> order_xlsx(const OrderList& list, text::Diagnostics& diagnostics);

/// What an order costs beside its lines: "Shipping, Maker Ltd", "To the minimum order of 50 USD, Maker Ltd".
std::vector<std::pair<std::string, double>> charges(const SupplierTotal& total, const std::string& currency);

/// "Total, Maker Ltd", "Total, supplier not stated".
std::string total_label(const SupplierTotal& total);

}  // namespace millwright::report
