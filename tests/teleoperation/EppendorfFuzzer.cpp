// libFuzzer's entry: any bytes from the line, cut into lines and read as answers (docs/developer/guide.md says how to
// run).
#include <cstdint>
#include <cstdlib>

#include "pellucida/teleoperation/EppendorfProtocol.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pellucida::LineSplitter lines;
  lines.push({reinterpret_cast<const char*>(data), size});
  while (const auto line = lines.next()) {
    if (line->size() > pellucida::LineSplitter::kMaxLength) std::abort();
    const auto answer = pellucida::eppendorf_answer(*line);
    if (!answer) continue;
    if (answer->code < 0 || answer->code > 999) std::abort();
    if (answer->number_count > pellucida::EppendorfAnswer::kMaxNumbers) std::abort();
    for (const long number : answer->numbers) {
      if (std::labs(number) > 1'000'000'000) std::abort();
    }
  }
  return 0;
}
