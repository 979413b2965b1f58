// libFuzzer's entry: any bytes as what a person or a batch leaves in JSON and CSV: looks, lessons, records, conditions.
#include "pellucida/batch/Groups.h"
#include "pellucida/batch/RecordingRecord.h"
#include "pellucida/microscopy/Look.h"
#include "pellucida/teaching/Lesson.h"
#include "support/FuzzReader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pellucida;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    parse_look(text, "fuzz");
  } catch (const Error&) {
  }
  test::fuzz_reader(data, size, ".json", [](const auto& file) { read_lesson(file); });
  test::fuzz_reader(data, size, ".json", [](const auto& file) { read_record(file); });
  std::vector<Recording> recordings{{.name = "cell1", .input = "day/cell1.avi"},
                                    {.name = "cell2", .input = "day/cell2.avi"}};
  test::fuzz_reader(data, size, ".csv", [&](const auto& file) { take_conditions(file, recordings); });
  return 0;
}
