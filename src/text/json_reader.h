// SPDX-License-Identifier: Apache-2.0
// A strict JSON reader (RFC 8259) that keeps the place of every value and key.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "text/diagnostic.h"
#include "text/node.h"
#include "text/source_text.h"

namespace millwright::text {

class JsonReader {
 public:
  static constexpr int depth_limit = 256;

  JsonReader(std::shared_ptr<const SourceText> text, Diagnostics& diagnostics);

  /// The whole text as one value. Stops at the first syntax error (reported); duplicate keys and null are reported and
  /// read on.
  std::optional<Node> read();

 private:
  /// Where a token began: the line and column go along with the offset, so that no place is ever counted out anew.
  struct Mark {
    std::size_t offset = 0;
    int line = 1;
    int column = 1;
  };

  bool at_end() const { return now_.offset >= bytes_.size(); }
  char peek() const { return at_end() ? '\0' : bytes_[now_.offset]; }
  void advance();
  void skip_blanks();
  SourceSpan span_from(const Mark& begin) const;
  bool fail(const Mark& place, std::string message, std::string hint = {});
  bool fail_at_value();

  bool read_value(std::optional<Node>& result);
  bool read_object(std::optional<Node>& result);
  bool read_member(Node& object);
  bool read_array(std::optional<Node>& result);
  bool read_string(std::string& value);
  bool read_escape(std::string& value, const Mark& begin);
  bool read_code_unit(char32_t& value, const Mark& begin);
  bool read_number(std::optional<Node>& result);
  bool read_word(std::optional<Node>& result);
  std::size_t skip_digits();

  std::shared_ptr<const SourceText> text_;
  std::string_view bytes_;
  Diagnostics& diagnostics_;
  Mark now_;
  int depth_ = 0;
};

}  // namespace millwright::text
