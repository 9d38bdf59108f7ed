// SPDX-License-Identifier: Apache-2.0
#include "text/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "text/excerpt.h"
#include "text/utf8.h"

namespace millwright::text {

namespace {

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "error";
    case Severity::warning:
      return "warning";
    case Severity::note:
      return "note";
  }
  return "error";
}

bool same(const Diagnostic& a, const Diagnostic& b) {
  return a.where.text == b.where.text && a.where.line == b.where.line && a.where.column == b.where.column &&
         a.severity == b.severity && a.message == b.message;
}

std::string place(const SourceSpan& span) {
  if (!span.text) return {};
  const std::string path = printable(span.text->path(), 1000);
  return span.line > 0 ? fmt::format("{}:{}:{}: ", path, span.line, span.column) : path + ": ";
}

/// One message with its source line; `hint` after the caret, or on a line of its own when there is no source line.
std::string format_one(const SourceSpan& where,
                       Severity severity,
                       const std::string& message,
                       const std::string& hint) {
  std::string result = fmt::format("{}{}: {}\n", place(where), name_of(severity), printable(message, 1000));
  const std::string advice = hint.empty() ? "" : "hint: " + printable(hint, 1000);
  if (where.text && where.line > 0) {
    const Excerpt shown = excerpt(where);
    result += fmt::format("{:5d} | {}\n", where.line, shown.line);
    result += fmt::format("      | {}{}{}\n", shown.marker, advice.empty() ? "" : " ", advice);
  } else if (!advice.empty()) {
    result += "      " + advice + "\n";
  }
  return result;
}

std::string counted(std::size_t number, std::string_view noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

}  // namespace

void Diagnostics::add(Diagnostic diagnostic) {
  const bool is_error = diagnostic.severity == Severity::error;
  const auto known = [&](const Diagnostic& kept) { return same(kept, diagnostic); };
  if (std::any_of(kept_.begin(), kept_.end(), known)) return;
  (is_error ? error_count_ : diagnostic.severity == Severity::warning ? warning_count_ : note_count_) += 1;
  PerText& entry = texts_.try_emplace(diagnostic.where.text.get(), PerText{texts_.size(), 0, 0, 0}).first->second;
  std::size_t& kept_here = is_error ? entry.kept_errors : entry.kept_others;
  if (kept_here >= limit_ && kept_here > 0) {
    ++entry.dropped;
    return;
  }
  ++kept_here;
  kept_.push_back(std::move(diagnostic));
}

void Diagnostics::error(SourceSpan where, std::string message, std::string hint) {
  add({Severity::error, std::move(where), std::move(message), std::move(hint), std::nullopt, {}});
}

void Diagnostics::warning(SourceSpan where, std::string message, std::string hint) {
  add({Severity::warning, std::move(where), std::move(message), std::move(hint), std::nullopt, {}});
}

void Diagnostics::note(SourceSpan where, std::string message, std::string hint) {
  add({Severity::note, std::move(where), std::move(message), std::move(hint), std::nullopt, {}});
}

void Diagnostics::error(std::string message, std::string hint) {
  error(SourceSpan{}, std::move(message), std::move(hint));
}

bool Diagnostics::only_counted(Severity severity, const SourceText* text) {
  const auto found = texts_.find(text);
  if (found == texts_.end()) return false;
  const bool is_error = severity == Severity::error;
  if ((is_error ? found->second.kept_errors : found->second.kept_others) < limit_) return false;
  (is_error ? error_count_ : severity == Severity::warning ? warning_count_ : note_count_) += 1;
  ++found->second.dropped;
  return true;
}

bool Diagnostics::has_error_at(const SourceSpan& where) const {
  return std::any_of(kept_.begin(), kept_.end(), [&](const Diagnostic& each) {
    return each.severity == Severity::error && each.where.text == where.text && each.where.line == where.line &&
           each.where.column == where.column;
  });
}

bool Diagnostics::is_full(const SourceText* text) const {
  const auto found = texts_.find(text);
  return found != texts_.end() && found->second.kept_errors >= limit_ && found->second.kept_errors > 0;
}

std::vector<Diagnostic> Diagnostics::all() const {
  std::vector<Diagnostic> result = kept_;
  for (const auto& [text, entry] : texts_) {
    if (entry.dropped == 0) continue;
    const auto of_text = [source = text](const Diagnostic& kept) { return kept.where.text.get() == source; };
    const auto example = std::find_if(kept_.begin(), kept_.end(), of_text);
    result.push_back({Severity::note, example->where, fmt::format("... and {} more", entry.dropped), {}, {}, {}});
    result.back().where = whole(example->where.text);
  }
  // The notes of omission were appended last and have line 0: they sort behind everything else of their text.
  const auto first_omission = kept_.size();
  std::vector<std::size_t> order(result.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::size_t i) {
    const Diagnostic& item = result[i];
    return std::make_tuple(
        texts_.at(item.where.text.get()).order, i >= first_omission, item.where.line, item.where.column);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<Diagnostic> sorted;
  sorted.reserve(result.size());
  for (const std::size_t i : order) sorted.push_back(std::move(result[i]));
  return sorted;
}

std::string format(const Diagnostic& diagnostic) {
  std::string result = format_one(diagnostic.where, diagnostic.severity, diagnostic.message, diagnostic.hint);
  if (diagnostic.related) {
    const std::string message = diagnostic.related_message.empty() ? "see also here" : diagnostic.related_message;
    result += format_one(*diagnostic.related, Severity::note, message, {});
  }
  return result;
}

std::string format(const Diagnostics& diagnostics) {
  std::string result;
  for (const Diagnostic& diagnostic : diagnostics.all()) result += format(diagnostic);
  std::string summary;
  if (diagnostics.error_count() > 0) summary = counted(diagnostics.error_count(), "error");
  if (diagnostics.warning_count() > 0) {
    summary += (summary.empty() ? "" : ", ") + counted(diagnostics.warning_count(), "warning");
  }
  if (!summary.empty()) result += summary + "\n";
  return result;
}

namespace {

/// Where a line is broken: the last blank from `from` on that leaves at most `room` characters before it, else the next
/// one; npos if there is none.
std::size_t break_of(std::string_view line, std::size_t from, std::size_t room) {
  std::size_t found = std::string_view::npos;
  for (std::size_t i = line.find(' ', from); i != std::string_view::npos; i = line.find(' ', i + 1)) {
    const bool fits = count_characters(line.substr(0, i)) <= room;
    if (fits || found == std::string_view::npos) found = i;
    if (!fits) break;
  }
  return found;
}

}  // namespace

std::string folded(std::string_view formatted, std::size_t width) {
  constexpr std::size_t margin = 8;       // "   12 | "
  constexpr std::size_t least_room = 30;  // for words beside what they hang under
  std::string out;
  while (!formatted.empty()) {
    const std::size_t end = std::min(formatted.find('\n'), formatted.size());
    std::string_view line = formatted.substr(0, end);
    formatted.remove_prefix(std::min(end + 1, formatted.size()));
    const bool of_source = line.size() >= margin && line.substr(margin - 3, 3) == " | " &&
                           line.substr(0, margin - 3).find_first_not_of(" 0123456789") == std::string_view::npos;
    const bool of_caret = line.find_first_not_of(' ') == margin - 2;  // blanks, and the bar or a hint without a line
    const std::size_t hint = of_caret ? line.find("hint: ") : std::string_view::npos;
    std::size_t hang = 4;
    if (hint != std::string_view::npos) hang = hint + least_room < width ? hint : margin;
    // Nothing is broken before the words begin; of the source nothing at all.
    std::size_t from = hint != std::string_view::npos ? hint + 6 : of_source ? line.size() : 0;
    std::size_t room = width;
    while (count_characters(line) > room) {
      const std::size_t at = break_of(line, from, room);
      if (at == std::string_view::npos) break;
      out += std::string(line.substr(0, at)) + "\n" + std::string(hang, ' ');
      line.remove_prefix(at + 1);
      from = 0;
      room = width > hang + least_room ? width - hang : least_room;
    }
    out += std::string(line) + "\n";
  }
  return out;
}

std::string printable(std::string_view text, std::size_t limit) {
  std::string result;
  std::size_t offset = 0;
  for (std::size_t shown = 0; offset < text.size(); ++shown) {
    if (shown >= limit) return result + "...";
    const Character character = decode(text, offset);
    const bool control = character.value < 0x20 || (character.value >= 0x7F && character.value < 0xA0);
    if (!character.valid || control) {
      result += fmt::format("\\x{:02X}", static_cast<unsigned>(character.value));
    } else {
      result += text.substr(offset, static_cast<std::size_t>(character.bytes));
    }
    offset += static_cast<std::size_t>(character.bytes);
  }
  return result;
}

std::string in_quotes(std::string_view text, std::size_t limit) { return "'" + printable(text, limit) + "'"; }

}  // namespace millwright::text
