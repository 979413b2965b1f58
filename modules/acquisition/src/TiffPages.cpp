#include "TiffPages.h"

#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

// A tag of the present page, or `fallback` (the standard's default where it names one).
template <class T>
T tag(TIFF* file, std::uint32_t number, T fallback) {
  T value = fallback;
  return TIFFGetFieldDefaulted(file, number, &value) == 1 ? value : fallback;
}

PhysicalSize physical_of(TIFF* file) {
  char* description = nullptr;
  TIFFGetField(file, TIFFTAG_IMAGEDESCRIPTION, &description);
  const auto unit = tag<std::uint16_t>(file, TIFFTAG_RESOLUTIONUNIT, RESUNIT_NONE);
  return physical_size(description ? description : "", tag(file, TIFFTAG_XRESOLUTION, 0.0F),
                       tag(file, TIFFTAG_YRESOLUTION, 0.0F),
                       unit == RESUNIT_CENTIMETER ? ResolutionUnit::kCentimetre
                       : unit == RESUNIT_INCH     ? ResolutionUnit::kInch
                                                  : ResolutionUnit::kNone);
}

}  // namespace

void TiffPages::Close::operator()(::tiff* file) const noexcept {
  TIFFClose(file);
}

TiffPages::TiffPages(const std::filesystem::path& file, double most_megapixels)
    : file_(file), most_megapixels_(most_megapixels) {
  // What is wrong is said once, by us. Handlers of this file alone: other libraries put their own in the common place.
  const auto free = [](TIFFOpenOptions* options) { TIFFOpenOptionsFree(options); };
  const std::unique_ptr<TIFFOpenOptions, decltype(free)> options(TIFFOpenOptionsAlloc(), free);
  const TIFFErrorHandlerExtR keep = [](TIFF*, void* user, const char*, const char* pattern, va_list arguments) {
    char text[256];
    std::vsnprintf(text, sizeof text, pattern, arguments);
    auto& complaints = *static_cast<Complaints*>(user);
    ++complaints.count;
    complaints.newest = text;
    return 1;
  };
  const TIFFErrorHandlerExtR pass_over = [](TIFF*, void*, const char*, const char*, va_list) { return 1; };
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep, complaints_.get());
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), pass_over, nullptr);
  tiff_.reset(TIFFOpenExt(file.c_str(), "rm", options.get()));
  if (!tiff_) throw InputError(file.string() + ": broken TIFF (its first page can't be found)");

  TIFF* page = tiff_.get();
  info_.width_px = static_cast<int>(tag<std::uint32_t>(page, TIFFTAG_IMAGEWIDTH, 0));
  info_.height_px = static_cast<int>(tag<std::uint32_t>(page, TIFFTAG_IMAGELENGTH, 0));
  const auto bits = tag<std::uint16_t>(page, TIFFTAG_BITSPERSAMPLE, 1);
  const auto format = tag<std::uint16_t>(page, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  if (info_.width_px <= 0 || info_.height_px <= 0) throw InputError(file.string() + ": broken TIFF (it has no size)");
  require_size(file.string(), static_cast<std::uint64_t>(info_.width_px), static_cast<std::uint64_t>(info_.height_px),
               most_megapixels);
  if (bits > 16 || (format != SAMPLEFORMAT_UINT && format != SAMPLEFORMAT_VOID)) {
    const char* kind = format == SAMPLEFORMAT_IEEEFP ? " bit float"
                       : format == SAMPLEFORMAT_INT  ? " bit signed"
                                                     : " bit";
    throw InputError(file.string() + ": holds " + std::to_string(bits) + kind +
                     " pixels; convert it to 8 or 16 bit grey");
  }
  info_.bit_depth = bits == 16 ? 16 : 8;
  info_.physical = physical_of(page);
  const long before = complaints_->count;
  info_.page_count = TIFFNumberOfDirectories(page);
  info_.cut_off = complaints_->count > before;
  go_to(0);
}

void TiffPages::go_to(long index) {
  const bool next = index == page_ + 1;
  const int done = next ? TIFFReadDirectory(tiff_.get()) : TIFFSetDirectory(tiff_.get(), static_cast<tdir_t>(index));
  if (done != 1)
    throw InputError(file_.string() + ": broken TIFF (page " + std::to_string(index + 1) + " can't be found)");
  page_ = index;
}

int TiffPages::channel_count() const {
  return tag<std::uint16_t>(tiff_.get(), TIFFTAG_SAMPLESPERPIXEL, 1);
}

// What a page asks for besides its size: the library would take it at its word.
void TiffPages::require_layout() const {
  TIFF* page = tiff_.get();
  constexpr int kMostChannels = 4;
  const std::string where = file_.string() + ", page " + std::to_string(page_ + 1);
  if (channel_count() < 1 || channel_count() > kMostChannels) {
    throw InputError(where + ": " + std::to_string(channel_count()) +
                     " samples a pixel; convert it to grey or plain colour");
  }
  if (TIFFIsTiled(page)) {
    require_size(where + ", its tiles", tag<std::uint32_t>(page, TIFFTAG_TILEWIDTH, 0),
                 tag<std::uint32_t>(page, TIFFTAG_TILELENGTH, 0), most_megapixels_);
    if (tag<std::uint32_t>(page, TIFFTAG_TILEWIDTH, 0) == 0 || tag<std::uint32_t>(page, TIFFTAG_TILELENGTH, 0) == 0) {
      throw InputError(where + ": broken TIFF (its tiles have no size)");
    }
  }
}

// Strips or tiles as they are stored, put together to rows. False when one can't be read.
bool TiffPages::read_samples(std::uint8_t* samples, std::size_t row_bytes) const {
  TIFF* page = tiff_.get();
  const auto height = static_cast<std::uint32_t>(info_.height_px);
  if (!TIFFIsTiled(page)) {
    for (std::uint32_t row = 0; row < height; ++row) {
      if (TIFFReadScanline(page, samples + row * row_bytes, row) != 1) return false;
    }
    return true;
  }
  const auto tile_height = tag<std::uint32_t>(page, TIFFTAG_TILELENGTH, 1);
  const auto tile_width = tag<std::uint32_t>(page, TIFFTAG_TILEWIDTH, 1);
  const auto tile_row_bytes = static_cast<std::size_t>(TIFFTileRowSize(page));
  std::vector<std::uint8_t> tile(static_cast<std::size_t>(TIFFTileSize(page)));
  for (std::uint32_t y = 0; y < height; y += tile_height) {
    for (std::uint32_t x = 0, at = 0; at < row_bytes;
         x += tile_width, at += static_cast<std::uint32_t>(tile_row_bytes)) {
      if (TIFFReadTile(page, tile.data(), x, y, 0, 0) < 0) return false;
      // Tiles at the right and lower edge reach beyond the image.
      const std::size_t width_bytes = std::min(tile_row_bytes, row_bytes - at);
      for (std::uint32_t row = 0; row < tile_height && y + row < height; ++row) {
        std::memcpy(samples + (y + row) * row_bytes + at, tile.data() + row * tile_row_bytes, width_bytes);
      }
    }
  }
  return true;
}

GreyImage TiffPages::read() const {
  const long before = complaints_->count;
  GreyImage image = read_page();
  if (complaints_->count > before) image.damage = complaints_->newest;
  return image;
}

GreyImage TiffPages::read_page() const {
  TIFF* page = tiff_.get();
  const auto broken = [&] {
    return InputError(file_.string() + ": broken TIFF (page " + std::to_string(page_ + 1) + " can't be read)");
  };
  const auto bits = tag<std::uint16_t>(page, TIFFTAG_BITSPERSAMPLE, 1);
  const auto format = tag<std::uint16_t>(page, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  if (static_cast<int>(tag<std::uint32_t>(page, TIFFTAG_IMAGEWIDTH, 0)) != info_.width_px ||
      static_cast<int>(tag<std::uint32_t>(page, TIFFTAG_IMAGELENGTH, 0)) != info_.height_px ||
      (bits == 16 ? 16 : 8) != info_.bit_depth || (format != SAMPLEFORMAT_UINT && format != SAMPLEFORMAT_VOID)) {
    throw InputError(file_.string() + ": page " + std::to_string(page_ + 1) +
                     " has another size or depth than the first; all pages must be alike");
  }

  require_layout();
  GreyImage image = make_grey(info_.width_px, info_.height_px, info_.bit_depth);
  const auto photometric = tag<std::uint16_t>(page, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  const int channels = channel_count();
  const bool interleaved =
      channels == 1 || tag<std::uint16_t>(page, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) == PLANARCONFIG_CONTIG;
  const bool plain = photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_RGB;
  if ((bits == 8 || bits == 16) && plain && interleaved) {
    const std::size_t sample_bytes = bits / 8;
    const std::size_t row_bytes =
        static_cast<std::size_t>(info_.width_px) * static_cast<std::size_t>(channels) * sample_bytes;
    std::vector<std::uint8_t> samples(row_bytes * static_cast<std::size_t>(info_.height_px));
    if (!read_samples(samples.data(), row_bytes)) throw broken();
    to_grey(samples.data(), channels, static_cast<int>(sample_bytes), image.pixel_count(), image.bytes.data());
    return image;
  }

  // Palettes, bilevel, white-is-zero, planar colour: the library turns all of them into 8 bit colour.
  if (bits == 16)
    throw InputError(file_.string() + ": 16 bit pixels of a rare layout; convert it to plain 16 bit grey");
  std::vector<std::uint32_t> colours(image.pixel_count());
  if (TIFFReadRGBAImageOriented(page, static_cast<std::uint32_t>(info_.width_px),
                                static_cast<std::uint32_t>(info_.height_px), colours.data(), ORIENTATION_TOPLEFT,
                                1) != 1) {
    throw broken();
  }
  to_grey(colours.data(), 4, 1, image.pixel_count(), image.bytes.data());
  return image;
}

}  // namespace pellucida
