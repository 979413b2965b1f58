#pragma once
#include <cstdint>
#include <filesystem>

namespace pellucida {

/// What the structure of a video file says about its being whole.
struct ContainerExtent {
  enum class Kind { kUnknown, kRiff, kIso, kMatroska };
  Kind kind = Kind::kUnknown;
  std::uint64_t declared_bytes = 0;  ///< how long the file should at least be; 0 where it doesn't say
  std::uint64_t file_bytes = 0;      ///< how long it is
  bool has_index = true;  ///< ISO (MP4, MOV): false when the part without which nothing can be read is missing

  bool cut_off() const noexcept { return declared_bytes > file_bytes || !has_index; }
};

/// Reads the outermost structure of an AVI (RIFF), MP4 or MOV (ISO base media), or Matroska or WebM file; of any other
/// file only its length. Never throws for a file it can't make sense of.
ContainerExtent container_extent(const std::filesystem::path& file);

}  // namespace pellucida
