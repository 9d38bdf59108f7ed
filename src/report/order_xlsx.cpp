// SPDX-License-Identifier: Apache-2.0
// libxlsxwriter writes to a file by name only, so that the workbook takes shape in a folder of its own.
#include <fmt/format.h>
#include <xlsxwriter.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "report/order_files.h"

namespace millwright::report {

namespace {

namespace fs = std::filesystem;

/// A folder that vanishes with what is in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::error_code failure;
    const fs::path parent = fs::temp_directory_path(failure);
    std::string pattern = ((failure ? fs::path("/tmp") : parent) / "millwright-XXXXXX").string();
    if (mkdtemp(pattern.data()) != nullptr) path_ = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// One sheet, written cell by cell. Texts go in as texts: none becomes a formula.
class Sheet {
 public:
  Sheet(lxw_workbook* book, const char* name) : sheet_(workbook_add_worksheet(book, name)) {
    worksheet_freeze_panes(sheet_, 1, 0);
    worksheet_set_landscape(sheet_);
    worksheet_set_paper(sheet_, 9);  // A4
    worksheet_fit_to_pages(sheet_, 1, 0);
    worksheet_repeat_rows(sheet_, 0, 0);
  }
  void column(int at, double width, const std::string& title, lxw_format* format) {
    worksheet_set_column(sheet_, index(at), index(at), width, nullptr);
    text(0, at, title, format);
  }
  void text(std::size_t row, int at, const std::string& words, lxw_format* format = nullptr) {
    worksheet_write_string(sheet_, static_cast<lxw_row_t>(row), index(at), words.c_str(), format);
  }
  void number(std::size_t row, int at, double value, lxw_format* format = nullptr) {
    worksheet_write_number(sheet_, static_cast<lxw_row_t>(row), index(at), value, format);
  }
  /// `value` is what the formula gives: programs that do not compute show it.
  void formula(std::size_t row, int at, const std::string& words, double value, lxw_format* format) {
    worksheet_write_formula_num(sheet_, static_cast<lxw_row_t>(row), index(at), words.c_str(), format, value);
  }

 private:
  static lxw_col_t index(int at) { return static_cast<lxw_col_t>(at); }
  lxw_worksheet* sheet_;
};

struct Formats {
  explicit Formats(lxw_workbook* book)
      : bold(workbook_add_format(book)),
        money(workbook_add_format(book)),
        money_sum(workbook_add_format(book)),
        length(workbook_add_format(book)),
        length_sum(workbook_add_format(book)) {
    for (lxw_format* each : {bold, money_sum, length_sum}) format_set_bold(each);
    for (lxw_format* each : {money, money_sum}) format_set_num_format(each, "0.00");
    for (lxw_format* each : {length, length_sum}) format_set_num_format(each, "0.0");
  }
  lxw_format *bold, *money, *money_sum, *length, *length_sum;
};

void write_order(const OrderList& list, lxw_workbook* book, const Formats& formats) {
  Sheet sheet(book, "Order");
  constexpr std::pair<const char*, double> columns[] = {{"line", 5},
                                                        {"quantity", 9},
                                                        {"unit", 5},
                                                        {"description", 22},
                                                        {"manufacturer", 24},
                                                        {"part number", 24},
                                                        {"supplier", 18},
                                                        {"unit price", 10},
                                                        {"currency", 9},
                                                        {"price date", 11},
                                                        {"price is", 9},
                                                        {"total", 10},
                                                        {"used for", 40},
                                                        {"verify", 24},
                                                        {"converted at", 28}};
  int at = 0;
  for (const auto& [title, width] : columns) sheet.column(at++, width, title, formats.bold);
  std::size_t row = 0;
  for (const OrderLine& line : list.lines) {
    ++row;
    sheet.number(row, 0, static_cast<double>(row));
    sheet.number(row, 1, line.quantity);
    sheet.text(row, 2, line.unit);
    sheet.text(row, 3, line.description);
    sheet.text(row, 4, line.manufacturer);
    sheet.text(row, 5, line.part_number);
    sheet.text(row, 6, line.supplier);
    sheet.number(row, 7, line.unit_price, formats.money);
    sheet.text(row, 8, list.currency);
    sheet.text(row, 9, line.price_date);
    sheet.text(row, 10, line.price_estimate ? "estimate" : "");
    sheet.formula(row, 11, fmt::format("=B{0}*H{0}", row + 1), line.total, formats.money);
    sheet.text(row, 12, line.used_for);
    if (line.paper_only) sheet.text(row, 13, paper_only_note);
    if (!line.converted_at.empty()) sheet.text(row, 14, line.converted_at);
  }
  const auto sum = [&](std::size_t at_row, const std::string& label, const std::string& formula, double total) {
    sheet.text(at_row, 3, label, formats.bold);
    sheet.text(at_row, 8, list.currency, formats.bold);
    sheet.formula(at_row, 11, formula, total, formats.money_sum);
  };
  const std::size_t count = list.lines.size();
  if (count == 0) return;
  row = count + 2;
  std::string charged;  // cells of what is charged beside the lines
  std::size_t first = 0;
  for (const SupplierTotal& each : list.supplier_totals) {
    std::size_t last = first;
    while (last < count && list.lines[last].supplier == each.supplier) ++last;
    std::string own = fmt::format("=SUM(L{}:L{})", first + 2, last + 1);
    for (const auto& [label, charge] : charges(each, list.currency)) {
      sheet.text(row, 3, label);
      sheet.text(row, 8, list.currency);
      sheet.number(row, 11, charge, formats.money);
      if (!each.converted_at.empty()) sheet.text(row, 14, each.converted_at);
      own += fmt::format("+L{}", row + 1);
      charged += fmt::format("+L{}", row + 1);
      ++row;
    }
    if (list.supplier_totals.size() > 1) sum(row++, total_label(each), own, each.charged());
    first = last;
  }
  sum(row, "Total", fmt::format("=SUM(L2:L{}){}", count + 1, charged), list.total);
}

void write_cuts(const OrderList& list, lxw_workbook* book, const Formats& formats) {
  Sheet sheet(book, "Cutting list");
  constexpr std::pair<const char*, double> columns[] = {{"stock", 20},
                                                        {"manufacturer", 24},
                                                        {"part number", 24},
                                                        {"axis", 9},
                                                        {"slot", 14},
                                                        {"section", 26},
                                                        {"count", 7},
                                                        {"length [mm]", 12},
                                                        {"sum [mm]", 12},
                                                        {"bar", 40}};
  int at = 0;
  for (const auto& [title, width] : columns) sheet.column(at++, width, title, formats.bold);
  std::size_t row = 0;
  std::size_t cut = 0;
  for (const StockTotal& stock : list.stock) {
    const std::size_t first = row + 2;
    for (double pieces = 0.0; pieces < stock.pieces; ++cut) {
      const CutLine& line = list.cuts[cut];
      pieces += line.count;
      ++row;
      sheet.text(row, 0, line.description);
      sheet.text(row, 1, line.manufacturer);
      sheet.text(row, 2, line.part_number);
      sheet.text(row, 3, line.axis);
      sheet.text(row, 4, line.slot);
      sheet.text(row, 5, line.section);
      sheet.number(row, 6, line.count);
      sheet.number(row, 7, 1e3 * line.length, formats.length);
      sheet.formula(row, 8, fmt::format("=G{0}*H{0}", row + 1), 1e3 * line.count * line.length, formats.length);
      if (line.bar > 0) sheet.number(row, 9, static_cast<double>(line.bar));
    }
    const std::size_t last = row + 1;
    ++row;
    sheet.text(row, 5, "sum", formats.bold);
    sheet.formula(row, 6, fmt::format("=SUM(G{}:G{})", first, last), stock.pieces, formats.bold);
    sheet.formula(row, 8, fmt::format("=SUM(I{}:I{})", first, last), 1e3 * stock.length, formats.length_sum);
    if (!stock.bars.empty()) sheet.text(row, 9, stock.bars);
  }
}

}  // namespace

std::optional<std::string> order_xlsx(const OrderList& list, text::Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& reason) {
    diagnostics.error("the workbook cannot be written: " + reason, "is there room in the folder for temporary files?");
    return std::nullopt;
  };
  const TemporaryFolder folder;
  if (folder.path().empty()) return refuse(std::strerror(errno));
  const std::string path = (folder.path() / "order.xlsx").string();
  std::string place = folder.path().string();
  lxw_workbook_options options{};
  options.tmpdir = place.data();
  lxw_workbook* book = workbook_new_opt(path.c_str(), &options);
  if (book == nullptr) return refuse("not enough memory");
  lxw_doc_properties properties{};
  std::string title = list.title;
  properties.title = title.data();
  workbook_set_properties(book, &properties);
  const Formats formats(book);
  write_order(list, book, formats);
  write_cuts(list, book, formats);
  if (const lxw_error error = workbook_close(book); error != LXW_NO_ERROR) return refuse(lxw_strerror(error));
  std::ifstream stream(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream || bytes.empty()) return refuse(std::strerror(errno));
  return bytes;
}

}  // namespace millwright::report
