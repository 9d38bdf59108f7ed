// SPDX-License-Identifier: Apache-2.0
#include "text/document.h"

#include "text/json_reader.h"
#include "text/text_check.h"
#include "text/toml_tree.h"

namespace millwright::text {

std::optional<Document> read_toml(const std::shared_ptr<const SourceText>& text, Diagnostics& diagnostics) {
  if (!check_text(text, diagnostics)) return std::nullopt;
  std::optional<Node> root = parse_toml_tree(text->contents(), text, diagnostics);
  if (!root) return std::nullopt;
  return Document(text, std::move(*root));
}

std::optional<Document> read_json(const std::shared_ptr<const SourceText>& text, Diagnostics& diagnostics) {
  if (!check_text(text, diagnostics)) return std::nullopt;
  std::optional<Node> root = JsonReader(text, diagnostics).read();
  if (root && root->is_table()) return Document(text, std::move(*root));
  if (root) diagnostics.error(root->span(), "JSON: an object in braces is expected outermost");
  return std::nullopt;
}

namespace {

void refuse_controls(std::string_view text, const SourceSpan& where, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
    const bool ends_line = byte == '\n' || (byte == '\r' && next == '\n');
    const bool is_wide = byte == 0xC2 && next >= 0x80 && next < 0xA0;  // U+0080 to U+009F
    if (!is_wide && byte != 0x7F && (byte >= 0x20 || byte == '\t' || ends_line)) continue;
    return diagnostics.error(
        where, "a control character (" + printable(text.substr(i, is_wide ? 2 : 1)) + ") in a text", "leave it out");
  }
}

}  // namespace

void refuse_control_characters(const Node& node, Diagnostics& diagnostics) {
  if (node.is_table())
    for (const TableEntry& entry : node.entries()) {
      refuse_controls(entry.key, entry.key_span, diagnostics);
      refuse_control_characters(entry.value, diagnostics);
    }
  else if (node.is_array())
    for (const Node& item : node.items()) refuse_control_characters(item, diagnostics);
  else if (const auto text = node.as_string())
    refuse_controls(*text, node.span(), diagnostics);
}

std::optional<Document> read_document(const std::string& path, Diagnostics& diagnostics) {
  const std::shared_ptr<const SourceText> text = SourceText::load(path, diagnostics, document_size_limit);
  if (!text) return std::nullopt;
  const bool is_json = path.size() >= 5 && path.compare(path.size() - 5, 5, ".json") == 0;
  auto document = is_json ? read_json(text, diagnostics) : read_toml(text, diagnostics);
  const std::size_t errors = diagnostics.error_count();
  if (document) refuse_control_characters(document->root(), diagnostics);
  if (diagnostics.error_count() > errors) return std::nullopt;
  return document;
}

}  // namespace millwright::text
