// SPDX-License-Identifier: Apache-2.0
// Workbooks: XLSX files made by libxlsxwriter, ODS files written out here; and files that mean harm.
#include <xlsxwriter.h>

#include <algorithm>

#include "catalogue/import_table.h"
#include "catalogue/import_workbook.h"
#include "catalogue/stored_zip.h"
#include "catch.h"
#include "text/file_bytes.h"

namespace millwright::catalogue::import_workbook_test {
namespace {

/// What stands in a sheet, cells divided by bars; or the complaints.
std::string shown(const std::string& bytes, const std::string& sheet = {}) {
  text::Diagnostics diagnostics;
  const auto read = read_workbook(bytes, "book", sheet, diagnostics);
  std::string text = read ? read->text : text::format(diagnostics);
  std::replace(text.begin(), text.end(), '\t', '|');
  return text;
}

/// A workbook with every kind of cell; texts in a table of their own, or (`in_cells`) where they are used.
std::string xlsx(bool in_cells) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "book.xlsx").string();
  lxw_workbook_options options{};
  options.constant_memory = in_cells ? 1 : 0;
  lxw_workbook* book = workbook_new_opt(path.c_str(), &options);
  lxw_worksheet* sheet = workbook_add_worksheet(book, "Motors");
  workbook_add_worksheet(book, "Other & more");
  lxw_format* date = workbook_add_format(book);
  format_set_num_format(date, "yyyy-mm-dd");
  lxw_format* percent = workbook_add_format(book);
  format_set_num_format(percent, "0%");
  worksheet_write_string(sheet, 0, 0, "List \"2026\"", nullptr);
  worksheet_write_string(sheet, 2, 0, "00123 \xC2\xB5", nullptr);
  worksheet_write_number(sheet, 2, 1, 126.1, nullptr);
  lxw_datetime day{2026, 1, 15, 0, 0, 0};
  worksheet_write_datetime(sheet, 2, 2, &day, date);
  worksheet_write_number(sheet, 2, 3, 0.85, percent);
  worksheet_write_formula_num(sheet, 2, 4, "=B3*2", nullptr, 252.2);
  worksheet_write_boolean(sheet, 3, 0, 1, nullptr);
  worksheet_write_formula_str(sheet, 3, 1, "=A1", nullptr, "a & <b>");
  worksheet_write_array_formula_num(sheet, 3, 2, 3, 2, "{=SUM(1)}", nullptr, 7.5);
  worksheet_write_string(sheet, 3, 4, "two\nlines", nullptr);
  workbook_close(book);
  text::Diagnostics diagnostics;
  return *text::read_bytes(path, 1 << 20, diagnostics);
}

std::string ods(const std::string& sheets) {
  return stored_zip(
      {{"mimetype", "application/vnd.oasis.opendocument.spreadsheet"},
       {"content.xml",
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?><office:document-content xmlns:office=\"o\" xmlns:table=\"t\" "
        "xmlns:text=\"x\"><office:body><office:spreadsheet>" +
            sheets + "</office:spreadsheet></office:body></office:document-content>"}});
}

std::string cell(const std::string& attributes, const std::string& text = {}) {
  return "<table:table-cell " + attributes + "><text:p>" + text + "</text:p></table:table-cell>";
}

TEST_CASE("Cells of an XLSX workbook, wherever their texts stand") {
  for (const bool in_cells : {false, true}) {
    INFO(in_cells);
    CHECK(shown(xlsx(in_cells)) ==
          "\"List \"\"2026\"\"\"\n\n00123 \xC2\xB5|126.1|2026-01-15|85%|252.2\ntrue|a & <b>|7.5||two lines\n");
  }
  CHECK(shown(xlsx(false), "Other & more").empty());
  CHECK(shown(xlsx(false), "Motor").find("has no sheet 'Motor'\n      hint: did you mean 'Motors'?") !=
        std::string::npos);
}

TEST_CASE("Cells of an ODS workbook, repeated rows and columns included") {
  const std::string row =
      "<table:table-row table:number-rows-repeated=\"2\">" + cell("office:value-type=\"string\"", "007") +
      cell("office:value-type=\"float\" office:value=\"1.26\"", "1,3") +
      cell("office:value-type=\"date\" office:date-value=\"2026-01-15\"", "15.1.26") +
      cell("office:value-type=\"percentage\" office:value=\"0.85\"", "85 %") +
      cell("office:value-type=\"currency\" office:currency=\"EUR\" office:value=\"24.5\"", "24,50") +
      cell("office:value-type=\"boolean\" office:boolean-value=\"true\"", "WAHR") +
      cell("table:formula=\"of:=[.A2]\" office:value-type=\"string\"", "a &amp; b") +
      "<table:table-cell table:number-columns-repeated=\"2\" office:value-type=\"float\" office:value=\"3\"/>"
      "<table:table-cell table:number-columns-repeated=\"16370\"/></table:table-row>"
      "<table:table-row table:number-rows-repeated=\"1048570\"><table:table-cell "
      "table:number-columns-repeated=\"16384\"/></table:table-row>";
  const std::string book =
      ods("<table:table table:name=\"A\">" + row + "</table:table><table:table table:name=\"B\"/>");
  const std::string line = "007|1.26|2026-01-15|85%|24.5 EUR|true|a & b|3|3\n";
  CHECK(shown(book) == line + line);
  CHECK(shown(book, "C").find("sheets: A, B") != std::string::npos);
}

TEST_CASE("A workbook is imported as a text is, and its lines are the rows of the sheet") {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "prices.xlsx").string();
  lxw_workbook* book = workbook_new(path.c_str());
  lxw_worksheet* sheet = workbook_add_worksheet(book, "Steppers");
  const char* header[] = {
      "Brand", "Part number", "Step angle (deg)", "Torque (N.cm)", "Current (A)", "Price (EUR)", "Listed"};
  for (std::uint16_t i = 0; i < 7; ++i) worksheet_write_string(sheet, 3, i, header[i], nullptr);
  const auto part = [&](std::uint32_t row, const char* name, double torque, double price) {
    worksheet_write_string(sheet, row, 0, "ACME", nullptr);
    worksheet_write_string(sheet, row, 1, name, nullptr);
    worksheet_write_number(sheet, row, 2, 1.8, nullptr);
    worksheet_write_number(sheet, row, 3, torque, nullptr);
    worksheet_write_number(sheet, row, 4, 2.8, nullptr);
    worksheet_write_number(sheet, row, 5, price, nullptr);
    worksheet_write_string(sheet, row, 6, "x", nullptr);
  };
  part(4, "1E5", 126.125, 1234.125);  // a number of a workbook is never ambiguous
  part(5, "007", 126, 20);
  workbook_close(book);
  const Imported result = import_request(path, asking());
  INFO(result.complaints);
  REQUIRE(result.good);
  const Table table = result.table(Family::steppers);
  REQUIRE(table.rows() == 2);
  CHECK(table.part_number(0) == "1E5");
  CHECK(table.part_number(1) == "007");
  CHECK(table.number("holding_torque", 0) == Approx(1.26125));
  CHECK(table.price(0).piece == 1234.125);
  CHECK(table.text("source", 0) == "imported from prices.xlsx, sheet Steppers");
  CHECK(result.mapping->header.line == 4);
}

TEST_CASE("Where the first sheet is a cover, the others are named") {
  const auto sheet = [](const char* name, const std::vector<std::string>& cells) {
    std::string row;
    for (const std::string& text : cells) row += cell("office:value-type=\"string\"", text);
    return std::string("<table:table table:name=\"") + name + "\"><table:table-row>" + row +
           "</table:table-row></table:table>";
  };
  const TemporaryFolder folder;
  const std::string path =
      folder
          .write("book.ods",
                 ods(sheet("Cover", {"Welcome"}) +
                     sheet("Motors", {"Brand", "Part number", "Step angle (deg)", "Torque (N.m)", "Current (A)"})))
          .string();
  ImportRequest request = asking();
  const Imported cover = import_request(path, request);
  CHECK(cover.says("no row among the first 40 names columns of steppers"));
  CHECK(cover.says("this is sheet 'Cover'; --sheet reads another one: Motors; or is it another family?"));
  request.format.sheet = "Motors";
  CHECK_FALSE(import_request(path, request).says("no row among"));
}

// --- what means harm
// ---------------------------------------------------------------------------------------------------

void put(std::string& bytes, std::size_t at, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i)
    bytes[at + static_cast<std::size_t>(i)] = static_cast<char>((value >> (8 * i)) & 0xFFU);
}

/// A zip file whose content.xml is 300 MB of blanks, packed, with a size of our choice in its directory.
std::string bomb(std::uint32_t claimed) {
  std::string packed;
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 9, Z_DEFAULT_STRATEGY);
  std::string blanks(1 << 20, ' ');
  std::string out(1 << 16, '\0');
  for (int i = 0; i < 300; ++i) {
    stream.next_in = reinterpret_cast<Bytef*>(blanks.data());
    stream.avail_in = static_cast<uInt>(blanks.size());
    do {
      stream.next_out = reinterpret_cast<Bytef*>(out.data());
      stream.avail_out = static_cast<uInt>(out.size());
      deflate(&stream, i == 299 ? Z_FINISH : Z_NO_FLUSH);
      packed.append(out, 0, out.size() - stream.avail_out);
    } while (stream.avail_out == 0);
  }
  deflateEnd(&stream);
  std::string archive = stored_zip({{"content.xml", packed}});
  const std::size_t directory = archive.rfind("PK\x01\x02");
  put(archive, directory + 10, 8, 2);
  put(archive, directory + 24, claimed, 4);
  return archive;
}

TEST_CASE("Zip bombs are refused, those that lie about their size too") {
  CHECK(shown(bomb(300U << 20U)).find("unpacks to 300 MB; at most 128 MB are read") != std::string::npos);
  CHECK(shown(bomb(1000)).find("unpacks to more than the 1000 bytes it claims") != std::string::npos);
}

TEST_CASE("Sheets that would never end are refused") {
  const auto repeated = [](const std::string& rows, const std::string& columns) {
    return ods("<table:table table:name=\"A\"><table:table-row table:number-rows-repeated=\"" + rows +
               "\"><table:table-cell office:value-type=\"float\" office:value=\"3\" table:number-columns-repeated=\"" +
               columns + "\"/></table:table-row></table:table>");
  };
  CHECK(shown(repeated("1", "2000000000")).find("at most 1048576 rows and 1024 columns") != std::string::npos);
  CHECK(shown(repeated("99999999999999", "1")).find("error: has a cell in row") != std::string::npos);
  CHECK(shown(repeated("1000000", "1000")).find("more than 4194304 cells") != std::string::npos);
  CHECK(shown(repeated("-5", "-5")).find("error") == std::string::npos);
}

/// The least workbook: a sheet of one row, its shared texts and the format code of style 1.
std::string small_xlsx(const std::string& cells, const std::string& texts = {}, const std::string& code = "0") {
  const std::string relation = "<Relationship Id=\"";
  return stored_zip(
      {{"xl/workbook.xml", "<workbook xmlns:r=\"r\"><sheets><sheet name=\"A\" r:id=\"a\"/></sheets></workbook>"},
       {"xl/_rels/workbook.xml.rels",
        "<Relationships>" + relation + "a\" Type=\"x/worksheet\" Target=\"sheet.xml\"/>" + relation +
            "b\" Type=\"x/sharedStrings\" Target=\"texts.xml\"/>" + relation +
            "c\" Type=\"x/styles\" Target=\"styles.xml\"/></Relationships>"},
       {"xl/texts.xml", "<sst>" + texts + "</sst>"},
       {"xl/styles.xml",
        "<styleSheet><numFmts><numFmt numFmtId=\"170\" formatCode=\"" + code +
            "\"/></numFmts><cellXfs><xf numFmtId=\"0\"/><xf numFmtId=\"170\"/></cellXfs></styleSheet>"},
       {"xl/sheet.xml", "<worksheet><sheetData><row r=\"1\">" + cells + "</row></sheetData></worksheet>"}});
}

TEST_CASE("Errors in cells are reported where they stand, and are no texts") {
  CHECK(shown(small_xlsx("<c r=\"A1\"><v>3</v></c><c r=\"B1\" t=\"e\"><f>X1</f><v>#REF!</v></c>"))
            .find("the cell in row 1, column 2 holds the error '#REF!'") != std::string::npos);
  CHECK(shown(ods("<table:table table:name=\"A\"><table:table-row>" +
                  cell("office:value-type=\"string\" xmlns:calcext=\"c\" calcext:value-type=\"error\"", "#DIV/0!") +
                  "</table:table-row></table:table>"))
            .find("the cell in row 1, column 1 holds the error '#DIV/0!'") != std::string::npos);
}

TEST_CASE("Whole numbers of a workbook are written in full") {
  const auto number = [](const std::string& value) {
    return shown(small_xlsx("<c r=\"A1\"><v>" + value + "</v></c>"));
  };
  CHECK(number("1234567890123456") == "1234567890123456\n");
  CHECK(number("-1E15") == "-1000000000000000\n");
  CHECK(number("0.1") == "0.1\n");
  CHECK(number("0.30000000000000004") == "0.3\n");
  CHECK(number("1E20") == "1e+20\n");
}

TEST_CASE("What a number format takes as it is makes no date") {
  const auto formatted = [](const char* code) {
    return shown(small_xlsx("<c r=\"A1\" s=\"1\"><v>45000</v></c>", {}, code));
  };
  for (const char* code : {"0_d", "0*d", "0\\d", "0&quot;d&quot;", "0&quot;_&quot;", "0&quot;[&quot;"})
    CHECK(formatted(code) == "45000\n");
  CHECK(formatted("0&quot;_&quot;%") == "4500000%\n");
  CHECK(formatted("_-d") == "2023-03-15\n");  // day 45000 of 1900: 2023-03-15
}

TEST_CASE("XML nested without end, and texts without end, are refused") {
  std::string nested;
  for (int i = 0; i < 300; ++i) nested += "<table:a>";
  CHECK(shown(ods(nested)).find("elements nested deeper than 256 in line 1") != std::string::npos);
  std::string texts;
  texts.reserve((workbook_cell_limit + 1) * 5);
  for (std::size_t i = 0; i <= workbook_cell_limit; ++i) texts += "<si/>";
  CHECK(shown(small_xlsx("", texts)).find("has more than 4194304 shared texts") != std::string::npos);
}

TEST_CASE("Damaged workbooks are refused with a reason") {
  const std::string good = xlsx(false);
  text::Diagnostics unused;
  for (std::size_t i = 0; i < 400; ++i) {  // cut off anywhere, and one byte wrong anywhere
    std::string cut = good.substr(0, good.size() * i / 400);
    (void)read_workbook(cut, "book", {}, unused);
    std::string bent = good;
    bent[(i * 7919) % bent.size()] =
        static_cast<char>(bent[(i * 7919) % bent.size()] ^ static_cast<char>(1U << (i % 8)));
    (void)read_workbook(bent, "book", {}, unused);
  }
  CHECK(shown("PK").find("is no complete zip file") != std::string::npos);
  CHECK(shown(stored_zip({{"a.txt", "hello"}})).find("is a zip file, but no workbook") != std::string::npos);
  CHECK(shown(ods("<table:table table:name=\"A\"><table:table-row>")).find("is damaged") != std::string::npos);
  // What goes on in the XML after it was unpacked.
  const std::string xml = "<table:table table:name=\"A\"><table:table-row>" +
                          cell("office:value-type=\"float\" office:value=\"3\"", "&lt;3") +
                          "</table:table-row></table:table>";
  for (std::size_t i = 0; i < xml.size(); ++i) {
    std::string bent = xml;
    bent[i] = static_cast<char>("<>&\"'\0/ ="[i % 9]);
    (void)read_workbook(ods(bent), "book", {}, unused);
    (void)read_workbook(ods(xml.substr(0, i)), "book", {}, unused);
  }
}

TEST_CASE("Texts that mean harm are refused at their places") {
  const std::string top = "Brand,Part No,Step angle (deg),Torque (N.m),Current (A),Price (EUR)\n";
  const std::string good = "A,1,1.8,1.2,2.8,20\n";
  CHECK(import_csv(top + good + std::string("A,2\0,1.8,1.2,2.8,20\n", 20)).says("table.csv:3:4: error: NUL byte"));
  CHECK(import_csv(top + good + "A,\xFF,1.8,1.2,2.8,20\n").says("table.csv:3:3: error: byte \\xFF is not UTF-8"));
  const Imported number = import_csv(top + good + "A,2,1.8," + std::string(10'000'000, '7') + ",2.8,20\n");
  CHECK(number.says("table.csv:3:9: error: holding_torque: a cell of 10000000 bytes"));
  CHECK(number.complaints.size() < 2000);
  CHECK(import_csv(std::string(1'000'000, ',') + "\n" + good).says("more than 16384 cells in a line"));
  CHECK(import_csv("Brand,Part No,Price" + std::string(5000, ',') + "x\n").says("a header of 5003 columns"));
  CHECK(import_csv("Brand" + std::string(1'000'000, 'x') + ",Part No,Price\n").says("a header cell of 1000005 bytes"));
  CHECK(import_csv("").says("is empty"));
  CHECK(import_csv("\n\n,,\n").says("error"));
  CHECK(import_csv(top).mapping);
  CHECK(import_csv(top + "A,\"1,1.8,1.2,2.8,20\n").says("table.csv:2:3: error: quote is never closed"));
  CHECK(import_csv(top + "A,1,1.8,1.2,2.8,20,surprise\n").says("table.csv:2:20: error: a cell beyond the 6 columns"));
}

}  // namespace
}  // namespace millwright::catalogue::import_workbook_test
