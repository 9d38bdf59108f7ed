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

std::optional<Document> read_document(const std::string& path, Diagnostics& diagnostics) {
  const std::shared_ptr<const SourceText> text = SourceText::load(path, diagnostics, document_size_limit);
  if (!text) return std::nullopt;
  const bool is_json = path.size() >= 5 && path.compare(path.size() - 5, 5, ".json") == 0;
  return is_json ? read_json(text, diagnostics) : read_toml(text, diagnostics);
}

}  // namespace millwright::text
