#pragma once
#include <memory>
#include <string>

#include "pellucida/acquisition/OpenSource.h"
#include "pellucida/core_vtk/FrameSource.h"

namespace pellucida {

/// Opens a source by its name on the command line: `virtual` or `virtual:SCENARIO` (a shipped scenario or a JSON file),
/// or anything `open_source` accepts. The virtual microscope has its own pixel size and frame rate: options that state
/// others are a UsageError.
std::unique_ptr<FrameSource> open_any_source(const std::string& source, const SourceOptions& options);

/// True for `virtual` and `virtual:SCENARIO`.
bool is_virtual_source(const std::string& source) noexcept;

}  // namespace pellucida
