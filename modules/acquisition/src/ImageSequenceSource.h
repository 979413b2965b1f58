#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "pellucida/acquisition/OpenSource.h"

namespace pellucida {

/// True when `left` comes before `right` as people count: "frame9" before "frame10". Equal numbers: fewer leading zeros
/// first.
bool natural_less(std::string_view left, std::string_view right);

/// A folder of images as a sequence, in the natural order of their names; other files and hidden ones are passed over.
std::unique_ptr<FrameSource> open_image_folder(const std::filesystem::path& folder, const std::string& name,
                                               const SourceOptions& options);

/// One image file: a still, or of a TIFF with several pages a sequence.
std::unique_ptr<FrameSource> open_image_file(const std::filesystem::path& file, const std::string& name,
                                             const SourceOptions& options);

}  // namespace pellucida
