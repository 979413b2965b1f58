#include "ImageSequenceSource.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <utility>
#include <vector>

#include "ImageFile.h"
#include "SourceCalibration.h"
#include "TiffPages.h"
#include "pellucida/acquisition/FolderContent.h"
#include "pellucida/core/Error.h"
#include "pellucida/core_vtk/DamageCounter.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

void require_content(const std::filesystem::path& file) {
  std::error_code code;
  if (std::filesystem::file_size(file, code) != 0) return;
  throw InputError(file.string() + ": empty file (0 bytes); copy it again, or remove it if no frame belongs there");
}

/// Images one after the other, each got by its number.
class ImageSequenceSource final : public FrameSource {
 public:
  using Read = std::function<GreyImage(long)>;

  /// `where` names image `i` in an error's text.
  /// `check_end` throws where there should have been more.
  ImageSequenceSource(SourceInfo info, Read read, std::function<std::string(long)> where,
                      std::function<void()> check_end = {})
      : info_(std::move(info)), read_(std::move(read)), where_(std::move(where)), check_end_(std::move(check_end)) {}

  const SourceInfo& info() const noexcept override { return info_; }

  std::optional<Frame> next() override {
    if (next_ >= *info_.frame_count) {
      if (const auto check_end = std::exchange(check_end_, {})) check_end();
      return std::nullopt;
    }
    const GreyImage image = read_(next_);
    if (image.width_px != info_.width_px || image.height_px != info_.height_px ||
        image.bit_depth() != info_.bit_depth) {
      throw InputError(where_(next_) + ": " + describe(image.width_px, image.height_px, image.bit_depth()) +
                       " where the first image is " + describe(info_.width_px, info_.height_px, info_.bit_depth) +
                       "; all must be alike");
    }
    Frame frame;
    frame.frame_index = next_;
    frame.time_s = static_cast<double>(next_) / info_.frame_rate_hz;
    frame.damage = damage_.add(!image.damage.empty(), image.damage);
    frame.image = Frozen(make_frame(image.view(info_.pixel_size_um), frame.time_s, frame.frame_index));
    ++next_;
    return frame;
  }

  bool restart() override {
    next_ = 0;
    damage_ = {};
    return true;
  }

 private:
  static std::string describe(int width_px, int height_px, int bit_depth) {
    return std::to_string(width_px) + " x " + std::to_string(height_px) + " px, " + std::to_string(bit_depth) + " bit";
  }

  SourceInfo info_;
  Read read_;
  std::function<std::string(long)> where_;
  std::function<void()> check_end_;
  DamageCounter damage_;
  long next_ = 0;
};

SourceInfo info_from(const std::string& name, const ImageFileInfo& file, long frame_count) {
  SourceInfo info;
  info.name = name;
  info.width_px = file.width_px;
  info.height_px = file.height_px;
  info.bit_depth = file.bit_depth;
  info.frame_count = frame_count;
  return info;
}

}  // namespace

bool natural_less(std::string_view left, std::string_view right) {
  std::size_t l = 0;
  std::size_t r = 0;
  while (l < left.size() && r < right.size()) {
    if (is_digit(left[l]) && is_digit(right[r])) {
      // Numbers compare by length without leading zeros, then digit by digit: no limit on their size.
      const auto skip_zeros = [](std::string_view text, std::size_t at) {
        while (at + 1 < text.size() && text[at] == '0' && is_digit(text[at + 1])) ++at;
        return at;
      };
      const auto end_of = [](std::string_view text, std::size_t at) {
        while (at < text.size() && is_digit(text[at])) ++at;
        return at;
      };
      const std::size_t l_start = skip_zeros(left, l);
      const std::size_t r_start = skip_zeros(right, r);
      const auto l_number = left.substr(l_start, end_of(left, l_start) - l_start);
      const auto r_number = right.substr(r_start, end_of(right, r_start) - r_start);
      if (l_number.size() != r_number.size()) return l_number.size() < r_number.size();
      if (l_number != r_number) return l_number < r_number;
      l = l_start + l_number.size();
      r = r_start + r_number.size();
    } else {
      if (left[l] != right[r]) return left[l] < right[r];
      ++l;
      ++r;
    }
  }
  if ((l < left.size()) != (r < right.size())) return r < right.size();
  return left.size() < right.size() || (left.size() == right.size() && left < right);
}

std::unique_ptr<FrameSource> open_image_folder(const std::filesystem::path& folder, const std::string& name,
                                               const SourceOptions& options) {
  std::vector<std::filesystem::path> files;
  std::error_code status;
  for (const auto& entry : std::filesystem::directory_iterator(folder, status)) {
    const bool hidden = entry.path().filename().string().starts_with('.');
    if (hidden || !entry.is_regular_file()) continue;
    // An empty image keeps its place: it is refused in its turn.
    std::error_code code;
    const bool empty_image = has_image_name(entry.path()) && entry.file_size(code) == 0;
    if (empty_image || image_kind(entry.path()) != ImageKind::kNone) files.push_back(entry.path());
  }
  if (status) throw InputError(name + ": the folder can't be read (" + status.message() + "); check its permission");
  if (std::all_of(files.begin(), files.end(), [](const auto& file) { return image_kind(file) == ImageKind::kNone; })) {
    files.clear();
  }
  if (files.empty()) throw InputError(name + ": no PNG, TIFF, JPEG or BMP image in this folder");
  std::sort(files.begin(), files.end(), [](const auto& left, const auto& right) {
    return natural_less(left.filename().string(), right.filename().string());
  });

  require_content(files.front());
  const double most_megapixels = options.most_megapixels;
  const ImageFileInfo first = read_image_info(files.front(), most_megapixels);
  SourceInfo info = info_from(name, first, static_cast<long>(files.size()));
  check_options(options);
  settle_pixel_size(info, options, first.physical);
  settle_frame_rate(info, options, first.physical);

  auto read = [files, most_megapixels](long index) {
    const auto& file = files[static_cast<std::size_t>(index)];
    require_content(file);
    if (image_kind(file) == ImageKind::kTiff && read_image_info(file, most_megapixels).page_count > 1) {
      throw InputError(file.string() + ": has several pages; give the file itself as the input");
    }
    return read_image(file, most_megapixels);
  };
  auto where = [files](long index) { return files[static_cast<std::size_t>(index)].string(); };
  return std::make_unique<ImageSequenceSource>(std::move(info), std::move(read), std::move(where));
}

std::unique_ptr<FrameSource> open_image_file(const std::filesystem::path& file, const std::string& name,
                                             const SourceOptions& options) {
  const double most_megapixels = options.most_megapixels;
  const ImageFileInfo first = read_image_info(file, most_megapixels);
  SourceInfo info = info_from(name, first, first.page_count);
  auto where = [name](long index) { return name + ", page " + std::to_string(index + 1); };
  auto check_end = [name, first] {
    if (!first.cut_off) return;
    throw InputError(name + ": broken off after page " + std::to_string(first.page_count) +
                     " (the next one can't be found); copy or record it again");
  };
  if (first.page_count == 1) {
    // A still is read at once: what can't be decoded is an input error before any option is looked at.
    auto image = std::make_shared<const GreyImage>(read_image(file, most_megapixels));
    check_options(options);
    settle_pixel_size(info, options, first.physical);
    info.frame_rate_hz = 1.0;
    info.frame_rate_origin = "still";
    return std::make_unique<ImageSequenceSource>(
        std::move(info), [image](long) { return *image; }, std::move(where), std::move(check_end));
  }
  check_options(options);
  settle_pixel_size(info, options, first.physical);
  settle_frame_rate(info, options, first.physical);
  auto pages = std::make_shared<TiffPages>(file, most_megapixels);
  auto read = [pages](long index) {
    pages->go_to(index);
    return pages->read();
  };
  return std::make_unique<ImageSequenceSource>(std::move(info), std::move(read), std::move(where),
                                               std::move(check_end));
}

}  // namespace pellucida
