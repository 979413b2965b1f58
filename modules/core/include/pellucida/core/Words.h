#pragma once
#include <string>

/// Marks a text of a table for translation; whoever shows it says it with `say`.
#define PELLUCIDA_WORDS(english) english

namespace pellucida {

/// Gives a text of the program in the user's language; any thread.
using Translator = std::string (*)(const char* english);

/// `english` in the language of the windows, as `resources/translations` has it: English until a translator is set. A
/// text that lacks a translation stays English. lupdate finds the texts by this function's name.
std::string say(const char* english);

/// A sentence that was put together below the windows, of an error, an event or a reason, in their language: as
/// `resources/translations/messages_de.ts` has it, with its values. Sessions and the command line keep the English one.
std::string say_message(const std::string& english);

/// Gives such a sentence in the user's language; any thread.
using MessageTranslator = std::string (*)(const std::string& english);

/// nullptr: English again.
void set_translator(Translator translator, MessageTranslator messages) noexcept;

}  // namespace pellucida
