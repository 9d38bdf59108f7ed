// SPDX-License-Identifier: Apache-2.0
// What is wrong in a text, where, and what to do about it. Readers report here and go on, so that a person sees all
// problems at once; the caller decides when to stop.
//
//   catalogues/steppers/x.csv:14:15: error: holding_torque: not a number: '1O.5'
//      14 | StepperOnline,23HS22,1O.5,1.26
//         |                       ^~~~ hint: letter O where a zero was meant: 10.5
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text/question.h"
#include "text/source_text.h"

namespace millwright::text {

enum class Severity { error, warning, note };

struct Diagnostic {
  Severity severity = Severity::error;
  SourceSpan where;
  std::string message;
  std::string hint;                   ///< what to write instead; may be empty
  std::optional<SourceSpan> related;  ///< the other place that takes part ("first defined here")
  std::string related_message;        ///< what is at `related`
};

/// Collects diagnostics. Keeps at most `limit_per_file` errors and as many warnings and notes of each text, and counts
/// the rest, so that a file that is wrong in every line stays readable and costs no memory. The same complaint about
/// the same place is kept once. Not for use by several threads at a time.
class Diagnostics {
 public:
  explicit Diagnostics(std::size_t limit_per_file = 50) : limit_(limit_per_file) {}

  void add(Diagnostic diagnostic);
  void error(SourceSpan where, std::string message, std::string hint = {});
  void warning(SourceSpan where, std::string message, std::string hint = {});
  void note(SourceSpan where, std::string message, std::string hint = {});

  /// An error that concerns no text (an option, an environment variable).
  void error(std::string message, std::string hint = {});

  bool has_errors() const { return error_count_ > 0; }
  /// Number of errors reported, including those beyond the limit.
  std::size_t error_count() const { return error_count_; }
  std::size_t warning_count() const { return warning_count_; }
  /// Number of everything reported.
  std::size_t count() const { return error_count_ + warning_count_ + note_count_; }

  /// Whether an error begins at this place, among those that are kept: one more about the same words helps nobody.
  bool has_error_at(const SourceSpan& where) const;

  /// Whether no further error of this text will be kept. Readers of long files ask this before they work out a place.
  bool is_full(const SourceText* text) const;

  /// Counts one more of that severity and returns true if it would not be kept anyway, so that the caller can spare
  /// itself the words: judges of long files ask this first.
  bool only_counted(Severity severity, const SourceText* text);

  /// What was kept, texts in the order in which they were first complained about, places ascending; for each text that
  /// went over the limit a last note "... and N more".
  std::vector<Diagnostic> all() const;

  /// Readers that report here tell the listener what they ask (see question.h). It must outlive them; null: nobody.
  void listen(QuestionListener* listener) { listener_ = listener; }
  QuestionListener* listener() const { return listener_; }

 private:
  struct PerText {
    std::size_t order = 0;
    std::size_t kept_errors = 0;
    std::size_t kept_others = 0;
    std::size_t dropped = 0;
  };

  std::size_t limit_;
  std::size_t error_count_ = 0;
  std::size_t warning_count_ = 0;
  std::size_t note_count_ = 0;
  std::map<const SourceText*, PerText> texts_;
  std::vector<Diagnostic> kept_;
  QuestionListener* listener_ = nullptr;
};

/// The compiler form shown above: place, message, source line (clipped around the caret when long, unprintable bytes
/// shown as \x00), caret and hint; each line ends with a newline.
std::string format(const Diagnostic& diagnostic);

/// All of them, and a last line such as "2 errors, 1 warning". Empty if there is nothing to say.
std::string format(const Diagnostics& diagnostics);

/// What format() says in lines of at most `width` columns where there are blanks to break at: messages go on under
/// themselves, a hint under its first word. Lines of the source stay as they are.
std::string folded(std::string_view formatted, std::size_t width);

/// `text` safe to print in one line: control characters and bytes that are not UTF-8 become \x1B, and what is longer
/// than `limit` characters is cut with "...".
std::string printable(std::string_view text, std::size_t limit = 200);

/// printable() in single quotes, for words of the user inside a message.
std::string in_quotes(std::string_view text, std::size_t limit = 40);

}  // namespace millwright::text
