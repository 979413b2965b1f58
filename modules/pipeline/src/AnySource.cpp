#include "pellucida/pipeline/AnySource.h"

#include "pellucida/core/Error.h"
#include "pellucida/simulation/VirtualMicroscope.h"

namespace pellucida {
namespace {

constexpr std::string_view kVirtual = "virtual";

}  // namespace

bool is_virtual_source(const std::string& source) noexcept {
  return source == kVirtual || source.starts_with("virtual:");
}

std::unique_ptr<FrameSource> open_any_source(const std::string& source, const SourceOptions& options,
                                             const PlaybackOptions& playback) {
  if (is_session(source)) {
    if (options.frame_rate_hz) {
      throw UsageError(source + ": a session has the times of its frames; leave out --fps");
    }
    PlaybackOptions chosen = playback;
    if (options.pixel_size_um) chosen.pixel_size_um = options.pixel_size_um;
    return std::make_unique<SessionSource>(source, chosen);
  }
  if (!playback.plain()) {
    throw UsageError(source + ": not a session; --from, --to, --every, --loop and --backwards are for sessions");
  }
  if (!is_virtual_source(source)) return open_source(source, options);
  if (options.pixel_size_um || options.frame_rate_hz) {
    throw UsageError(source + ": the scenario fixes pixel size and frame rate; leave out --pixel-size-um and --fps");
  }
  return open_virtual(source == kVirtual ? "default" : source.substr(kVirtual.size() + 1));
}

}  // namespace pellucida
