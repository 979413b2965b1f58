#include "pellucida/core/Words.h"

#include <atomic>

namespace pellucida {
namespace {

std::atomic<Translator> the_translator{nullptr};

}  // namespace

std::string say(const char* english) {
  const Translator translator = the_translator.load(std::memory_order_acquire);
  return translator ? translator(english) : std::string(english);
}

void set_translator(Translator translator) noexcept {
  the_translator.store(translator, std::memory_order_release);
}

}  // namespace pellucida
