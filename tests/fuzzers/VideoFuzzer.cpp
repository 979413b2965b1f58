// libFuzzer's entry: any bytes as a video: its container's structure, what is decoded of it, and where it ends.
#include "ContainerExtent.h"
#include "pellucida/acquisition/OpenSource.h"
#include "support/FuzzReader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // A small picture may be stated as a large one: what takes seconds to fill says nothing of the readers.
  const pellucida::SourceOptions options{.pixel_size_um = 0.5, .frame_rate_hz = 20.0, .most_megapixels = 0.5};
  pellucida::test::fuzz_reader(data, size, ".avi", [&](const auto& file) {
    pellucida::container_extent(file);
    const auto source = pellucida::open_source(file.string(), options);
    for (int i = 0; i < 8 && source->next(); ++i) {
    }
  });
  return 0;
}
