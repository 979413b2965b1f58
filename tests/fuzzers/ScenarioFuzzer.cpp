// libFuzzer's entry: any bytes as a scenario of the virtual microscope.
#include <cstddef>
#include <cstdint>

#include "pellucida/core/Error.h"
#include "pellucida/simulation/Scenario.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    pellucida::parse_scenario({reinterpret_cast<const char*>(data), size}, "fuzz");
  } catch (const pellucida::Error&) {
  }
  return 0;
}
