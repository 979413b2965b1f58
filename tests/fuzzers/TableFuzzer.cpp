// libFuzzer's entry: any bytes as a table of numbers: reference curves, a measured curve, a relaxation, the devices.
#include "pellucida/core/Table.h"
#include "pellucida/haptics/DeviceCatalog.h"
#include "pellucida/identification/MeasuredCurve.h"
#include "pellucida/identification/RelaxationRecord.h"
#include "support/FuzzReader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pellucida;
  test::fuzz_reader(data, size, ".csv", [](const auto& file) { Table::read(file); });
  test::fuzz_reader(data, size, ".csv", [](const auto& file) { read_measured_curve(file); });
  test::fuzz_reader(data, size, ".csv", [](const auto& file) { read_relaxation_record(file); });
  test::fuzz_reader(data, size, ".json", [](const auto& file) { read_device_catalog(file); });
  return 0;
}
