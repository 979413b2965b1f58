#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

namespace pellucida {

/// True when `left` comes before `right` as people count: "frame9" before "frame10". Equal numbers: fewer leading zeros
/// first.
bool natural_less(std::string_view left, std::string_view right);

/// True for a name that ends as a video's does, whatever the file holds.
bool has_video_name(const std::filesystem::path& file);

/// What a folder offers as recordings; each list in the natural order of its names. Hidden entries and files of other
/// kinds (tables, texts) are in none.
struct FolderContent {
  std::vector<std::filesystem::path> videos;   ///< by their names: a broken one is found when it is opened
  std::vector<std::filesystem::path> stacks;   ///< TIFFs, where the first of them that can be read has several pages
  std::vector<std::filesystem::path> images;   ///< all other images, as a sequence takes them
  std::vector<std::filesystem::path> folders;  ///< a link to a folder counts as one
};

/// Looks into a folder, at the first bytes of its files. Throws InputError when it can't be read.
FolderContent content_of(const std::filesystem::path& folder);

}  // namespace pellucida
