// SPDX-License-Identifier: Apache-2.0
// What readers ask of the tables of a text. A reader states each key where it reads it: name, meaning, kind, unit,
// default. Whoever listens (Diagnostics::listen) hears all that, so that the reference of a file and its schema are
// made from the very calls that read it.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace millwright::text {

class Node;

/// A key where it is asked for, with what it means in one sentence: `table.string({"title", "stands over reports"})`.
struct Key {
  // NOLINTNEXTLINE(google-explicit-constructor): a key without meaning is just its name
  constexpr Key(const char* key) : name(key) {}
  constexpr Key(std::string_view key) : name(key) {}
  Key(const std::string& key) : name(key) {}
  constexpr Key(const char* key, std::string_view words) : name(key), meaning(words) {}
  constexpr Key(std::string_view key, std::string_view words) : name(key), meaning(words) {}

  std::string_view name;
  std::string_view meaning;
};

enum class Expected {
  anything,  ///< the reader looks at the value itself, and says more in another question
  text,
  number,
  integer,
  boolean,
  date,
  table,
  tables,           ///< a list of tables
  table_or_tables,  ///< one table, or a list of them
  texts,            ///< one text, or a list
  word,             ///< one of `words`
  words,            ///< one of `words`, or a list of them
  quantity,         ///< with a unit; of unit "1" a plain number
  range,            ///< one quantity, or two in a list
  quantities,       ///< one quantity, or a list to choose from
  three_quantities,
  amount,      ///< of money
  not_allowed  ///< the key does not belong to this sort of table
};

struct Question {
  Expected expected = Expected::anything;
  std::string key;  ///< "*": any other key of the table
  std::string meaning;
  std::string unit;                ///< of quantities
  std::vector<std::string> words;  ///< that are allowed
  std::string example;             ///< of the value, as it is written
  std::string fallback;            ///< what counts if the key is missing, as it is written; empty if there is none
  std::string source;              ///< of the fallback: a key of sources.bib
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool above_least = false;  ///< `least` itself is not allowed
  bool required = false;

  bool operator==(const Question&) const = default;
};

/// Hears every question a reader asks.
class QuestionListener {
 public:
  QuestionListener() = default;
  virtual ~QuestionListener() = default;
  QuestionListener(const QuestionListener&) = delete;
  QuestionListener& operator=(const QuestionListener&) = delete;

  /// `table`: of which the question is asked.
  virtual void asked(const Node& table, const Question& question) = 0;
};

}  // namespace millwright::text
