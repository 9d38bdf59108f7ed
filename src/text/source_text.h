// SPDX-License-Identifier: Apache-2.0
// A text that somebody wrote, and places in it. Everything that is read from a file keeps a SourceSpan, so that every
// complaint about it can point at the very characters.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace millwright::text {

class Diagnostics;
class SourceText;

/// A place in a text: `length` characters from `line`:`column` on. Lines and columns start at 1 and count characters
/// (Unicode code points; a tab is one). `line` 0 means the text as a whole; a null `text` means no file at all (the
/// command line, say). The span never owns a position outside the text: printing clips it.
struct SourceSpan {
  std::shared_ptr<const SourceText> text;
  int line = 0;
  int column = 0;
  int length = 0;
};

/// Line and column, both from 1.
struct Position {
  int line = 1;
  int column = 1;
};

/// The bytes of one file (or of a text given on the command line) with the name it is known by. A leading UTF-8 byte
/// order mark is dropped, and no position counts it. Lines end at LF or CR LF. Immutable, so safe to share between
/// threads; always held by std::shared_ptr<const SourceText>, which spans keep alive.
class SourceText {
 public:
  /// Files above this are refused: a catalogue is a few megabytes, what is larger is the wrong file.
  static constexpr std::uintmax_t default_size_limit = std::uintmax_t{256} << 20U;

  /// Bytes that nothing is written to before they are read into.
  struct Buffer {
    std::shared_ptr<char> bytes;
    std::size_t size = 0;
  };

  SourceText(std::string path, std::string contents);
  SourceText(std::string path, Buffer contents);
  static std::shared_ptr<const SourceText> from_string(std::string path, std::string contents);

  /// Reads a regular file. Reports one error and returns null when it is not there, unreadable, a directory or device,
  /// larger than `size_limit`, or evidently not text (told from the first 64 KiB, so that a huge binary file costs
  /// nothing). A few bad bytes in a text are left for check_text(), which points at each.
  static std::shared_ptr<const SourceText> load(const std::string& path,
                                                Diagnostics& diagnostics,
                                                std::uintmax_t size_limit = default_size_limit);

  const std::string& path() const { return path_; }
  std::string_view contents() const { return contents_; }
  /// As the file has them, with a byte order mark where there is one.
  std::string_view bytes() const;
  int line_count() const;

  /// Line `number` (from 1) without its line end; empty outside the text.
  std::string_view line(int number) const;

  /// Place of the byte at `offset` of contents(); offsets beyond the end give the end. The line is found in
  /// logarithmic time, the column by counting characters in that line.
  Position position(std::size_t offset) const;

 private:
  void index_lines() const;

  std::string path_;
  std::string bytes_;
  Buffer buffer_;
  std::string_view contents_;  ///< in one of the two, behind a byte order mark
  mutable std::once_flag indexed_;
  mutable std::vector<std::size_t> line_begins_;
};

/// The text as a whole, for complaints that have no line.
SourceSpan whole(std::shared_ptr<const SourceText> text);

/// The `bytes` bytes from `offset` on. A span that runs over the end of its line is cut there.
SourceSpan span_at(const std::shared_ptr<const SourceText>& text, std::size_t offset, std::size_t bytes);

}  // namespace millwright::text
