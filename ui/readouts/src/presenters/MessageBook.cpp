#include "presenters/MessageBook.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "pellucida/core/Event.h"
#include "pellucida/core/NewCellNote.h"
#include "pellucida/core/PersonHint.h"
#include "pellucida/core/Words.h"

namespace pellucida {
namespace {

constexpr std::size_t kLongestText = 4000;  // longer is no message
constexpr int kFewLetters = 9;              // a sentence of fewer joins what is known, or numbers

bool is_letter(char sign) noexcept {
  return std::isalpha(static_cast<unsigned char>(sign)) != 0;
}

// Words in a row, as of a sentence; not a number with its unit, nor a path.
bool is_prose(std::string_view text) noexcept {
  for (std::size_t i = 2; i + 2 < text.size(); ++i) {
    if (text[i] == ' ' && is_letter(text[i - 1]) && is_letter(text[i - 2]) && is_letter(text[i + 1])) return true;
  }
  return false;
}

// Where a text can be two: before a sign that joins.
bool joins_at(std::string_view text, std::size_t at) noexcept {
  const char sign = text[at];
  return sign == ',' || sign == ';' || sign == ':' || sign == '+' || sign == ')' ||
         (sign == ' ' && at + 1 < text.size() && text[at + 1] == '(');
}

std::string_view joint_of(std::string_view text) noexcept {
  for (const std::string_view joint : {"; ", ": ", ", ", " (", "+", ")"}) {
    if (text.starts_with(joint)) return joint;
  }
  return {};
}

}  // namespace

void MessageBook::add(std::string english, std::string translation) {
  Sentence sentence;
  std::string piece;
  for (std::size_t i = 0; i < english.size(); ++i) {
    if (english[i] == '%' && i + 1 < english.size() && std::isdigit(static_cast<unsigned char>(english[i + 1])) != 0) {
      sentence.pieces.push_back(std::exchange(piece, {}));
      ++i;
    } else {
      piece += english[i];
    }
  }
  sentence.pieces.push_back(piece);
  for (std::size_t k = 0; k < sentence.pieces.size(); ++k) {
    if (sentence.pieces[k].size() > sentence.pieces[sentence.longest].size()) sentence.longest = k;
    sentence.letters +=
        static_cast<int>(std::count_if(sentence.pieces[k].begin(), sentence.pieces[k].end(), &is_letter));
  }
  sentence.translation = std::move(translation);
  sentences_.push_back(std::move(sentence));
}

// Reads one text. What is found for a part of it is kept: parts of parts are alike.
class MessageReader {
 public:
  MessageReader(const MessageBook& book, std::string_view text) {
    for (const auto& sentence : book.sentences_) {
      if (text.find(sentence.pieces[sentence.longest]) != std::string_view::npos) candidates_.push_back(&sentence);
    }
  }

  std::string said(std::string_view text) {
    const Reading& reading = best(text);
    return reading.has_unknown_prose && reading.letters < kFewLetters ? std::string(text) : reading.text;
  }

 private:
  struct Reading {
    int letters = 0;  // covered by sentences
    bool has_unknown_prose = false;
    std::string text;
  };
  using Values = std::vector<std::string_view>;

  const Reading& best(std::string_view text) {
    const auto key = std::pair(text.data(), text.size());
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    Reading reading{0, is_prose(text), std::string(text)};
    const bool may_hold_one = std::any_of(candidates_.begin(), candidates_.end(), [&](const auto* sentence) {
      return text.find(sentence->pieces[sentence->longest]) != std::string_view::npos;
    });
    if (!may_hold_one) return known_.emplace(key, std::move(reading)).first->second;
    for (const auto* sentence : candidates_) {
      for_each_match(*sentence, text, [&](const Values& values) { take_better(reading, *sentence, values); });
    }
    for (std::size_t i = 1; i < text.size(); ++i) {
      if (joins_at(text, i)) take_better(reading, best(text.substr(0, i)), best(text.substr(i)));
    }
    if (const std::string_view joint = joint_of(text); !joint.empty() && joint.size() < text.size()) {
      take_better(reading, {0, false, std::string(joint)}, best(text.substr(joint.size())));
    }
    return known_.emplace(key, std::move(reading)).first->second;
  }

  static void take_better(Reading& reading, const Reading& left, const Reading& right) {
    if (left.letters + right.letters <= reading.letters) return;
    reading = {left.letters + right.letters, left.has_unknown_prose || right.has_unknown_prose, left.text + right.text};
  }

  void take_better(Reading& reading, const MessageBook::Sentence& sentence, const Values& values) {
    Reading found{sentence.letters, false, {}};
    std::vector<std::string> said;
    for (const std::string_view value : values) {
      const Reading& inner = best(value);
      found.letters += inner.letters;
      found.has_unknown_prose |= inner.has_unknown_prose;
      said.push_back(inner.text);
    }
    if (found.letters <= reading.letters || (sentence.letters < kFewLetters && found.has_unknown_prose)) return;
    const std::string& pattern = sentence.translation;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
      const std::size_t place = pattern[i] == '%' && i + 1 < pattern.size() ? pattern[i + 1] - '1' : said.size();
      if (place < said.size()) {
        found.text += said[place];
        ++i;
      } else {
        found.text += pattern[i];
      }
    }
    reading = std::move(found);
  }

  // A value ends where the next piece first begins, the last one at the end; between values in a row, anywhere.
  static void for_each_match(const MessageBook::Sentence& sentence, std::string_view text,
                             const std::function<void(const Values&)>& found) {
    const auto& pieces = sentence.pieces;
    if (pieces.size() == 1) {
      if (text == pieces.front()) found({});
      return;
    }
    if (!text.starts_with(pieces.front()) || !text.ends_with(pieces.back())) return;
    if (text.size() < pieces.front().size() + pieces.back().size()) return;
    text.remove_prefix(pieces.front().size());
    text.remove_suffix(pieces.back().size());
    Values values;
    match_from(pieces, 1, text, values, found);
  }

  static void match_from(const std::vector<std::string>& pieces, std::size_t next, std::string_view text,
                         Values& values, const std::function<void(const Values&)>& found) {
    if (next + 1 == pieces.size()) {
      values.push_back(text);
      found(values);
      values.pop_back();
      return;
    }
    const std::string& piece = pieces[next];
    const std::size_t first = text.find(piece);
    const std::size_t last = piece.empty() ? text.size() : first;
    for (std::size_t at = first; at != std::string_view::npos && at <= last; ++at) {
      values.push_back(text.substr(0, at));
      match_from(pieces, next + 1, text.substr(at + piece.size()), values, found);
      values.pop_back();
    }
  }

  std::vector<const MessageBook::Sentence*> candidates_;
  std::map<std::pair<const char*, std::size_t>, Reading> known_;
};

std::string MessageBook::translate(const std::string& text) const {
  if (text.empty() || text.size() > kLongestText) return text;
  return MessageReader(*this, text).said(text);
}

std::string say_event_kind(const std::string& kind) {
  const std::string said = say_message(kind);
  return said == kind ? say(kind.c_str()) : said;
}

std::string say_event_detail(const std::string& kind, const std::string& detail) {
  if (kind == event_kind::kHint) return say_message(without_corners(detail));
  if (kind != event_kind::kNote || detail == kNewCellNote || detail.starts_with(kNoForceNote))
    return say_message(detail);
  return detail;
}

}  // namespace pellucida
