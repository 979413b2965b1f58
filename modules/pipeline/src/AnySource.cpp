#include "pellucida/pipeline/AnySource.h"

#include "pellucida/core/Error.h"
#include "pellucida/simulation/VirtualMicroscope.h"

namespace pellucida {

std::unique_ptr<FrameSource> open_any_source(const std::string& source, const SourceOptions& options) {
  constexpr std::string_view kVirtual = "virtual";
  const bool is_virtual = source == kVirtual || source.starts_with("virtual:");
  if (!is_virtual) return open_source(source, options);
  if (options.pixel_size_um || options.frame_rate_hz) {
    throw UsageError(source + ": the scenario fixes pixel size and frame rate; leave out --pixel-size-um and --fps");
  }
  return open_virtual(source == kVirtual ? "default" : source.substr(kVirtual.size() + 1));
}

}  // namespace pellucida
