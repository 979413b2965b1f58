// libFuzzer's entry (docs/developer/guide.md says how to run it).
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tracking/FuzzSequence.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string wrong = pellucida::test::run_fuzz_sequence(data, size);
  if (wrong.empty()) return 0;
  std::fprintf(stderr, "%s\n", wrong.c_str());
  std::abort();
}
