// libFuzzer's entry: any bytes as an injection plan.
#include <cstddef>
#include <cstdint>

#include "pellucida/core/Error.h"
#include "pellucida/planning/InjectionPlan.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    pellucida::plan_from_json({reinterpret_cast<const char*>(data), size}, "fuzz");
  } catch (const pellucida::Error&) {
  }
  return 0;
}
