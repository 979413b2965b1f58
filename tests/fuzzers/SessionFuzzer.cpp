// libFuzzer's entry: any bytes as each text file of a session: its head and its two tables.
#include "SessionIndex.h"
#include "SessionJson.h"
#include "support/FuzzReader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pellucida;
  test::fuzz_reader(data, size, ".json", [](const auto& file) { read_session_json(file); });
  test::fuzz_reader(data, size, ".csv", [](const auto& file) { read_measurements(file); });
  test::fuzz_reader(data, size, ".csv", [](const auto& file) { read_events(file); });
  return 0;
}
