// libFuzzer's entry: any bytes as an image; the first says of which format.
#include "pellucida/acquisition/OpenSource.h"
#include "support/FuzzReader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr const char* kExtensions[] = {".tif", ".png", ".bmp", ".jpg"};
  if (size == 0) return 0;
  // A few bytes may be stated as a large picture: what takes seconds to fill says nothing of the readers.
  const pellucida::SourceOptions options{.pixel_size_um = 0.5, .frame_rate_hz = 20.0, .most_megapixels = 0.5};
  pellucida::test::fuzz_reader(data + 1, size - 1, kExtensions[data[0] % 4], [&](const auto& file) {
    const auto source = pellucida::open_source(file.string(), options);
    for (int i = 0; i < 4 && source->next(); ++i) {
    }
  });
  return 0;
}
