// libFuzzer's entry: any bytes as a cell profile.
#include "pellucida/membrane/CellProfile.h"
#include "support/FuzzReader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pellucida::test::fuzz_reader(data, size, ".json", [](const auto& file) { pellucida::read_profile(file); });
  return 0;
}
