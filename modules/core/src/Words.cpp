#include "pellucida/core/Words.h"

#include <atomic>

namespace pellucida {
namespace {

std::atomic<Translator> the_translator{nullptr};
std::atomic<MessageTranslator> the_message_translator{nullptr};

}  // namespace

std::string say(const char* english) {
  const Translator translator = the_translator.load(std::memory_order_acquire);
  return translator ? translator(english) : std::string(english);
}

std::string say_message(const std::string& english) {
  const MessageTranslator translator = the_message_translator.load(std::memory_order_acquire);
  return translator ? translator(english) : english;
}

void set_translator(Translator translator, MessageTranslator messages) noexcept {
  the_translator.store(translator, std::memory_order_release);
  the_message_translator.store(messages, std::memory_order_release);
}

}  // namespace pellucida
