// SPDX-License-Identifier: Apache-2.0
#include "machine/problem_keys.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <set>
#include <utility>

#include "machine/problem_file.h"
#include "text/document.h"

namespace millwright::machine {

using text::Expected;
using text::Node;
using text::Question;

namespace {

const text::SourceSpan& nowhere() {
  static const text::SourceSpan span = text::whole(text::SourceText::from_string("made up", ""));
  return span;
}

Node text_node(const std::string& words) { return Node::make_string(nowhere(), words); }

constexpr const char* placeholder = "?";

bool is_placeholder(const Node& node) { return node.as_string().value_or("") == placeholder; }

std::string without_quotes(const std::string& words) {
  return words.size() > 1 && words.front() == '"' ? words.substr(1, words.size() - 2) : words;
}

/// Values to try: every word of a few, both truths, one of everything else.
std::vector<Node> samples(const Question& question) {
  std::vector<Node> nodes;
  const std::string& example = question.example;
  switch (question.expected) {
    case Expected::word:
    case Expected::words:
      for (const std::string& word : question.words) nodes.push_back(text_node(word));
      break;
    case Expected::boolean:
      nodes.push_back(Node::make_boolean(nowhere(), true));
      nodes.push_back(Node::make_boolean(nowhere(), false));
      break;
    case Expected::table:
    case Expected::table_or_tables:
      nodes.push_back(Node::make_table(nowhere()));
      break;
    case Expected::tables:
      nodes.push_back(Node::make_array(nowhere()));
      nodes.back().append(Node::make_table(nowhere()));
      break;
    case Expected::integer:  // defaults of other keys hang on counts
      if (std::isfinite(question.most)) nodes.push_back(Node::make_number(nowhere(), question.most));
      [[fallthrough]];
    case Expected::number:
      nodes.push_back(Node::make_number(nowhere(), 1.0));
      break;
    case Expected::anything:  // once something is there, readers say more of what they want
      nodes.push_back(text_node(placeholder));
      break;
    case Expected::not_allowed:
      break;
    default:
      nodes.push_back(example.empty() || example == "1" ? text_node("1") : text_node(without_quotes(example)));
  }
  return nodes;
}

/// An axis without moves of its own: the one key that two others together make needless.
Node axis_moved_with_others() {
  text::Diagnostics ignored;
  const auto words =
      text::SourceText::from_string("made up", "axis = [{name = 'x'}]\nmoves = [{axes = {x = '1 mm'}}]\n");
  return text::read_toml(words, ignored)->root();
}

/// A table of the made-up file: `path` names it for the reference, `steps` lead to it in the file.
struct Place {
  std::string path;
  std::vector<std::string> steps;
};

Node& table_at(Node& root, const std::vector<std::string>& steps) {
  Node* node = &root;
  for (const std::string& step : steps) {
    node = node->find(step);
    if (node->is_array()) node = &node->items().front();
  }
  return *node;
}

std::string word_at(const Node& table, std::string_view key) {
  const Node* node = table.find(key);
  return node == nullptr ? "" : node->as_string().value_or("");
}

/// Of one key of one kind of a table, while files are read.
struct Known {
  ProblemKey key;
  bool allowed = false;   ///< in some file it was asked for and not refused
  bool optional = false;  ///< in some file it was not required
};

struct KnownKind {
  std::vector<Known> keys;
  std::vector<std::vector<Question>> heard;  ///< all questions that one file was asked of it
};

/// What was asked of one table in one file.
struct Hearing {
  Place place;
  std::string kind;
  std::vector<Question> questions;
};

/// A question that says more about a value than another one.
int exactness(Expected expected) {
  switch (expected) {
    case Expected::anything:
    case Expected::not_allowed:
      return 0;
    case Expected::texts:
    case Expected::text:
      return 1;
    default:
      return 2;
  }
}

/// A default that hangs on other keys.
constexpr const char* varying = "?";

void merge_form(const Question& question, std::vector<Question>& forms) {
  if (exactness(question.expected) == 0) return;
  for (Question& form : forms) {
    if (form.expected != question.expected || form.unit != question.unit) continue;
    if (form.fallback.empty()) form.fallback = question.fallback;
    if (!question.fallback.empty() && form.fallback != question.fallback) form.fallback = varying;
    if (form.source.empty()) form.source = question.source;
    form.least = std::max(form.least, question.least);
    form.most = std::min(form.most, question.most);
    form.above_least = form.above_least || question.above_least;
    return;
  }
  forms.push_back(question);
  int best = 0;
  for (const Question& form : forms) best = std::max(best, exactness(form.expected));
  forms.erase(
      std::remove_if(forms.begin(), forms.end(), [&](const Question& form) { return exactness(form.expected) < best; }),
      forms.end());
}

/// Listens to the readers of one made-up file.
class Listener : public text::QuestionListener {
 public:
  explicit Listener(const Node& root) { find_places(root, {}, ""); }

  void asked(const Node& table, const Question& question) override {
    const auto place = places_.find(&table);
    if (place == places_.end()) return;
    auto& hearing = hearings_[&table];
    if (hearing.questions.empty()) {
      order_.push_back(&table);
      hearing.place = place->second.first;
      hearing.kind = place->second.second;
    }
    hearing.questions.push_back(question);
  }

  /// In the order in which the tables were first looked at.
  std::vector<Hearing> hearings() const {
    std::vector<Hearing> all;
    for (const Node* table : order_) all.push_back(hearings_.at(table));
    return all;
  }

 private:
  void find_places(const Node& node, const Place& place, const std::string& axis_kind) {
    std::string kind = axis_kind;
    const bool own_kind = place.path == "axis.mechanism" || place.path == "axis.members";
    if (place.path == "axis") {
      const Node* mechanism = node.find("mechanism");
      kind = mechanism != nullptr && word_at(*mechanism, "kind") == "rotary" ? axis_that_turns : axis_that_goes;
    }
    const bool by_axis = place.path == "axis" || place.path == "axis.moves" || place.path == "axis.require";
    places_[&node] = {place, own_kind ? word_at(node, "kind") : by_axis ? kind : ""};
    for (const text::TableEntry& entry : node.entries()) {
      const Node* inner = &entry.value;
      if (inner->is_array() && inner->size() > 0) inner = &inner->at(0);
      if (!inner->is_table()) continue;
      const bool named = place.path == "currency";
      Place below = place;
      below.path += (place.path.empty() ? "" : ".") + (named ? std::string("*") : entry.key);
      below.steps.push_back(entry.key);
      find_places(*inner, below, kind);
    }
  }

  std::map<const Node*, std::pair<Place, std::string>> places_;
  std::map<const Node*, Hearing> hearings_;
  std::vector<const Node*> order_;
};

class Explorer {
 public:
  std::vector<ProblemTable> explore() {
    files_.push_back(Node::make_table(nowhere()));
    files_.push_back(axis_moved_with_others());
    while (!files_.empty()) {
      const Node root = std::move(files_.front());
      files_.pop_front();
      read(root);
    }
    return result();
  }

 private:
  void read(const Node& root) {
    const text::Document document(text::SourceText::from_string("made up", ""), root);
    Listener listener(document.root());
    text::Diagnostics ignored;
    ignored.listen(&listener);
    (void)problem_of(document, ignored);
    for (const Hearing& hearing : listener.hearings()) take(hearing, root);
  }

  void take(const Hearing& hearing, const Node& root) {
    KnownKind& kind = kind_of(hearing);
    // Most files differ in another table, and this one is asked what it was asked before.
    if (std::find(kind.heard.begin(), kind.heard.end(), hearing.questions) != kind.heard.end()) return;
    kind.heard.push_back(hearing.questions);
    std::set<std::string> asked, refused, required;
    for (const Question& question : hearing.questions) {
      asked.insert(question.key);
      if (question.expected == Expected::not_allowed) refused.insert(question.key);
      if (question.required) required.insert(question.key);
    }
    for (const Question& question : hearing.questions) {
      if (refused.count(question.key) > 0) continue;
      Known& known = find_or_add(kind, question.key);
      known.allowed = true;
      if (known.key.meaning.empty()) known.key.meaning = question.meaning;
      merge_form(question, known.key.forms);
      try_out(question, hearing, root);
    }
    for (Known& known : kind.keys)
      if (asked.count(known.key.name) > 0 && required.count(known.key.name) == 0) known.optional = true;
  }

  KnownKind& kind_of(const Hearing& hearing) {
    const auto found = std::find_if(
        tables_.begin(), tables_.end(), [&](const auto& each) { return each.first == hearing.place.path; });
    auto& kinds = found == tables_.end() ? tables_.emplace_back(hearing.place.path, Kinds()).second : found->second;
    const auto same =
        std::find_if(kinds.begin(), kinds.end(), [&](const auto& each) { return each.first == hearing.kind; });
    return same == kinds.end() ? kinds.emplace_back(hearing.kind, KnownKind()).second : same->second;
  }

  static Known& find_or_add(KnownKind& kind, const std::string& key) {
    for (Known& known : kind.keys)
      if (known.key.name == key) return known;
    kind.keys.emplace_back();
    kind.keys.back().key.name = key;
    return kind.keys.back();
  }

  /// The same file with a value for the key, for each value that was not tried there before.
  void try_out(const Question& question, const Hearing& hearing, const Node& root) {
    const std::vector<Node> values = samples(question);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string sample = question.words.empty() ? std::to_string(i) : question.words[i];
      const int form = static_cast<int>(question.expected);
      if (!tried_.insert({hearing.place.path, hearing.kind, question.key, form, sample + question.unit}).second)
        continue;
      Node file = root;
      Node& table = table_at(file, hearing.place.steps);
      const std::string key = question.key != "*" ? question.key : hearing.place.path == "currency" ? "EUR" : "x";
      const Node* there = table.find(key);
      if (there != nullptr && !is_placeholder(*there) && there->kind() == values[i].kind()) continue;
      table.put(key, nowhere(), values[i]);
      files_.push_back(std::move(file));
    }
  }

  std::vector<ProblemTable> result() const {
    std::vector<ProblemTable> all;
    for (const auto& [path, kinds] : tables_) {
      ProblemTable table;
      table.path = path;
      for (const auto& [name, known] : kinds) {
        const bool told = path == "axis.mechanism" || path == "axis.members";
        if (told && (name.empty() || name == placeholder)) continue;  // a table without its kind is not complete
        table.told_by_own_kind = told;
        ProblemTableKind kind{name, {}};
        for (const Known& each : known.keys) {
          if (!each.allowed) continue;
          kind.keys.push_back(each.key);
          kind.keys.back().required = !each.optional;
          for (Question& form : kind.keys.back().forms)
            if (form.fallback == varying) form.fallback.clear();
        }
        table.kinds.push_back(std::move(kind));
      }
      all.push_back(std::move(table));
    }
    return all;
  }

  using Kinds = std::deque<std::pair<std::string, KnownKind>>;
  std::deque<std::pair<std::string, Kinds>> tables_;
  std::deque<Node> files_;
  std::set<std::tuple<std::string, std::string, std::string, int, std::string>> tried_;
};

}  // namespace

bool holds_tables(const Question& form) {
  return form.expected == Expected::table || form.expected == Expected::tables ||
         form.expected == Expected::table_or_tables;
}

std::vector<ProblemTable> problem_tables() { return Explorer().explore(); }

}  // namespace millwright::machine
