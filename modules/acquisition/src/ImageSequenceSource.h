#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "pellucida/acquisition/OpenSource.h"

namespace pellucida {

/// A folder of images as a sequence, in the natural order of their names; other files and hidden ones are passed over.
std::unique_ptr<FrameSource> open_image_folder(const std::filesystem::path& folder, const std::string& name,
                                               const SourceOptions& options);

/// One image file: a still, or of a TIFF with several pages a sequence.
std::unique_ptr<FrameSource> open_image_file(const std::filesystem::path& file, const std::string& name,
                                             const SourceOptions& options);

}  // namespace pellucida
