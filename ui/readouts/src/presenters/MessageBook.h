#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace pellucida {

/// Sentences in two languages, with places for values: "%1: can't be read (%2)". Finds the ones that a text was put
/// together from, and says it in the other language. The text itself need not tell which they were, so that errors
/// stay plain exceptions and a session's events plain text.
class MessageBook {
 public:
  /// In `english` the places are %1, %2, ... in this order.
  void add(std::string english, std::string translation);

  /// `text` in the other language: the sentences that cover most of it, in one another and in a row. What no sentence
  /// covers (a name, a number, another program's words) stays as it is. Any thread.
  std::string translate(const std::string& text) const;

 private:
  friend class MessageReader;
  struct Sentence {
    std::vector<std::string> pieces;  // the fixed text before, between and after the placeholders
    std::string translation;
    std::size_t longest = 0;  // of the pieces: where it does not occur, the sentence doesn't
    int letters = 0;
  };
  std::vector<Sentence> sentences_;
};

/// The kind of an event and its detail, as an event of a session has them, in the windows' language; kinds of the
/// windows' own, too. A note is its writer's: only the program's own are translated.
std::string say_event_kind(const std::string& kind);
std::string say_event_detail(const std::string& kind, const std::string& detail);

}  // namespace pellucida
