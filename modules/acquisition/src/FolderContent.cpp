#include "pellucida/acquisition/FolderContent.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "ImageFile.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

// What FFmpeg's containers are called, as microscopes and cameras write them.
constexpr std::array<std::string_view, 17> kVideoEndings{".avi", ".mp4",  ".m4v", ".mkv", ".mov", ".webm",
                                                         ".mpg", ".mpeg", ".wmv", ".ts",  ".mts", ".m2ts",
                                                         ".flv", ".ogv",  ".3gp", ".asf", ".mj2"};
constexpr double kNoLimit_megapixels = 1e9;

// The first TIFF that can be read decides for all of them.
bool are_stacks(const std::vector<fs::path>& tiffs) {
  for (const fs::path& file : tiffs) {
    try {
      return read_image_info(file, kNoLimit_megapixels).page_count > 1;
    } catch (const Error&) {
      continue;
    }
  }
  return false;
}

std::string lower_ending(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

bool may_be_tiff(const fs::path& file) {
  const std::string ending = lower_ending(file);
  return ending == ".tif" || ending == ".tiff" || image_kind(file) == ImageKind::kTiff;
}

void sort_naturally(std::vector<fs::path>& files) {
  std::sort(files.begin(), files.end(), [](const fs::path& left, const fs::path& right) {
    return natural_less(left.filename().string(), right.filename().string());
  });
}

}  // namespace

bool has_video_name(const fs::path& file) {
  return std::find(kVideoEndings.begin(), kVideoEndings.end(), lower_ending(file)) != kVideoEndings.end();
}

FolderContent content_of(const fs::path& folder) {
  FolderContent content;
  std::error_code status;
  for (const auto& entry : fs::directory_iterator(folder, status)) {
    const fs::path& file = entry.path();
    std::error_code ignored;
    if (file.filename().string().starts_with('.')) continue;
    if (entry.is_directory(ignored)) {
      content.folders.push_back(file);
    } else if (has_video_name(file)) {
      // Whatever is called a video is one: a pipe or a broken link is named when it is opened, not passed over.
      content.videos.push_back(file);
    } else if (entry.is_regular_file(ignored) && (has_image_name(file) || image_kind(file) != ImageKind::kNone)) {
      content.images.push_back(file);
    }
  }
  if (status) {
    throw InputError(folder.string() + ": the folder can't be read (" + status.message() + "); check its permission");
  }
  for (auto* files : {&content.videos, &content.images, &content.folders}) sort_naturally(*files);

  // Stacks and single pages have the same names: the files themselves tell.
  const auto others = std::stable_partition(content.images.begin(), content.images.end(), may_be_tiff);
  std::vector<fs::path> tiffs(content.images.begin(), others);
  if (are_stacks(tiffs)) {
    content.images.erase(content.images.begin(), others);
    content.stacks = std::move(tiffs);
  } else {
    sort_naturally(content.images);
  }
  return content;
}

}  // namespace pellucida
