#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "Grey.h"
#include "ImageFile.h"

struct tiff;

namespace pellucida {

/// The pages of a TIFF, one after the other: only one is ever in memory. (They come straight from the TIFF library.
/// ITK's reader above it can only read all pages at once, which a recording of some gigabytes forbids; it also drops
/// the unit of the resolution, and lets the library write to stderr.)
class TiffPages {
 public:
  /// Opens at the first page. Throws InputError when the file is broken, larger than `most_megapixels`, or its pixels
  /// are neither 8 nor 16 bit unsigned.
  TiffPages(const std::filesystem::path& file, double most_megapixels);

  /// Of the first page.
  const ImageFileInfo& info() const noexcept { return info_; }

  /// The reader's current page, as grey. Throws InputError when it is damaged.
  /// What the library mended is in the image's `damage`.
  GreyImage read() const;

  /// Goes to page `index` (0-based). Cheap for the next one. Throws InputError when the file breaks off before it.
  void go_to(long index);

 private:
  struct Close {
    void operator()(::tiff* file) const noexcept;
  };
  GreyImage read_page() const;
  int channel_count() const;
  void require_layout() const;
  bool read_samples(std::uint8_t* samples, std::size_t row_bytes) const;

  // What the library complains of; it keeps the address.
  struct Complaints {
    long count = 0;
    std::string newest;
  };

  std::filesystem::path file_;
  std::unique_ptr<Complaints> complaints_ = std::make_unique<Complaints>();
  double most_megapixels_ = 0.0;
  std::unique_ptr<::tiff, Close> tiff_;
  long page_ = 0;
  ImageFileInfo info_;
};

}  // namespace pellucida
