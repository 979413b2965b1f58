#pragma once
#include <memory>
#include <string>

#include "pellucida/acquisition/OpenSource.h"
#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/session/SessionSource.h"

namespace pellucida {

/// Opens a source by its name on the command line: `virtual` or `virtual:SCENARIO` (a shipped scenario or a JSON file),
/// the folder of a recorded session, or anything `open_source` accepts. The virtual microscope has its own pixel size
/// and frame rate, a session its own times: options that state others are a UsageError, as is a `playback` of anything
/// but a session that is not plain.
std::unique_ptr<FrameSource> open_any_source(const std::string& source, const SourceOptions& options,
                                             const PlaybackOptions& playback = {});

/// True for `virtual` and `virtual:SCENARIO`.
bool is_virtual_source(const std::string& source) noexcept;

}  // namespace pellucida
