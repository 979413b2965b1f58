// libFuzzer's entry: any bytes as each file of a session: its head, its tables, its list, its data files.
#include <new>

#include "PvdList.h"
#include "SessionIndex.h"
#include "SessionJson.h"
#include "pellucida/session/FramesUsed.h"
#include "pellucida/session/SessionClocks.h"
#include "pellucida/vtk_files/DataFile.h"
#include "support/FuzzReader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pellucida;
  test::fuzz_reader(data, size, ".json", [](const auto& file) {
    const SessionHead head = read_session_json(file);
    frames_used_of(head.info);
    clock_fit_of(head.info);
  });
  test::fuzz_reader(data, size, ".csv", [](const auto& file) { read_measurements(file); });
  test::fuzz_reader(data, size, ".csv", [](const auto& file) { read_events(file); });
  test::fuzz_reader(data, size, ".csv", [](const auto& file) { read_checksums(file); });
  test::fuzz_reader(data, size, ".pvd", [](const auto& file) { compare_pvd(file, {}, true); });
  const std::string_view content(reinterpret_cast<const char*>(data), size);
  for (const bool image : {true, false}) {
    try {
      if (image) {
        image_from(content);
      } else {
        poly_from(content);
      }
    } catch (const Error&) {
    } catch (const std::bad_alloc&) {
    }
  }
  return 0;
}
