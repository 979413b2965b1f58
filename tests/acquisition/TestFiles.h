#pragma once
#include <gtest/gtest.h>
#include <tiffio.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

#include "pellucida/acquisition/OpenSource.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/core_vtk/SceneData.h"
#include "support/Files.h"

namespace pellucida::test {

namespace fs = std::filesystem;

/// Keeps the first `share` of a file.
inline void cut(const std::string& file, double share) {
  fs::resize_file(file, static_cast<std::uintmax_t>(share * static_cast<double>(fs::file_size(file))));
}

/// A smooth grey picture that brightens with `number`; 8 or 16 bit.
inline cv::Mat picture(int number, int width = 32, int height = 24, bool deep = false) {
  cv::Mat image(height, width, deep ? CV_16UC1 : CV_8UC1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int value = 20 + 3 * x + 2 * y + 5 * number;
      if (deep) {
        image.at<std::uint16_t>(y, x) = static_cast<std::uint16_t>(value * 200 + x);
      } else {
        image.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(value);
      }
    }
  }
  return image;
}

inline void write_video(const std::string& file, int count, double rate_hz, const char* codec = "MJPG") {
  cv::VideoWriter writer(file, cv::VideoWriter::fourcc(codec[0], codec[1], codec[2], codec[3]), rate_hz, {64, 48},
                         true);
  ASSERT_TRUE(writer.isOpened()) << file;
  for (int i = 0; i < count; ++i) {
    cv::Mat colour;
    cv::cvtColor(picture(i % 8, 64, 48), colour, cv::COLOR_GRAY2BGR);
    writer.write(colour);
  }
}

/// What a TIFF made by hand says of itself.
struct TiffTags {
  int count = 1;
  std::uint16_t bits = 8;
  std::uint16_t format = SAMPLEFORMAT_UINT;
  std::uint16_t compression = COMPRESSION_NONE;
  std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
  float per_unit = 0.0F;
  std::uint16_t unit = RESUNIT_NONE;
  std::string description;
  std::uint32_t tile = 0;
};

/// Pages like `picture(page, 32, 24, bits == 16)`; of other depths, zeros.
inline void write_tiff(const std::string& file, const TiffTags& tags) {
  TIFF* tiff = TIFFOpen(file.c_str(), "w");
  ASSERT_TRUE(tiff);
  for (int page = 0; page < tags.count; ++page) {
    const cv::Mat image = picture(page, 32, 24, tags.bits == 16);
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 32U);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 24U);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, tags.bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, tags.format);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, tags.photometric);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, tags.compression);
    if (tags.per_unit > 0.0F) {
      TIFFSetField(tiff, TIFFTAG_XRESOLUTION, tags.per_unit);
      TIFFSetField(tiff, TIFFTAG_YRESOLUTION, tags.per_unit);
      TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, tags.unit);
    }
    if (!tags.description.empty()) TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, tags.description.c_str());
    const std::size_t pixel_bytes = tags.bits / 8U;
    if (tags.tile > 0) {
      TIFFSetField(tiff, TIFFTAG_TILEWIDTH, tags.tile);
      TIFFSetField(tiff, TIFFTAG_TILELENGTH, tags.tile);
      std::vector<std::uint8_t> tile(tags.tile * tags.tile * pixel_bytes);
      for (std::uint32_t y = 0; y < 24; y += tags.tile) {
        for (std::uint32_t x = 0; x < 32; x += tags.tile) {
          for (std::uint32_t j = 0; j < tags.tile && y + j < 24; ++j) {
            for (std::uint32_t i = 0; i < tags.tile && x + i < 32; ++i) {
              std::memcpy(&tile[(j * tags.tile + i) * pixel_bytes],
                          image.ptr(static_cast<int>(y + j)) + (x + i) * pixel_bytes, pixel_bytes);
            }
          }
          TIFFWriteTile(tiff, tile.data(), x, y, 0, 0);
        }
      }
    } else {
      TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 7U);
      std::vector<std::uint8_t> row(32 * std::max<std::size_t>(pixel_bytes, 8));
      for (std::uint32_t y = 0; y < 24; ++y) {
        if (pixel_bytes <= 2) std::memcpy(row.data(), image.ptr(static_cast<int>(y)), 32 * pixel_bytes);
        TIFFWriteScanline(tiff, row.data(), y);
      }
    }
    TIFFWriteDirectory(tiff);
  }
  TIFFClose(tiff);
}

/// All frames of a source, to its end.
inline std::vector<Frame> all_frames(FrameSource& source) {
  std::vector<Frame> frames;
  while (auto frame = source.next()) frames.push_back(*frame);
  return frames;
}

/// A frame's pixels as OpenCV holds them.
inline cv::Mat mat_of(const Frame& frame) {
  const ImageView view = view_of(frame.image.get());
  const int type = view.format == PixelFormat::kGray16 ? CV_16UC1 : CV_8UC1;
  return cv::Mat(view.height_px, view.width_px, type, const_cast<void*>(view.data),
                 static_cast<std::size_t>(view.row_bytes))
      .clone();
}

inline bool same_pixels(const cv::Mat& left, const cv::Mat& right) {
  return left.size() == right.size() && left.type() == right.type() && cv::norm(left, right, cv::NORM_INF) == 0.0;
}

/// Runs `call`, which must throw an Error of this code whose one line holds `part`.
template <class Call>
void expect_error(ExitCode code, const std::string& part, Call call) {
  try {
    call();
    ADD_FAILURE() << "nothing was thrown; expected: " << part;
  } catch (const Error& error) {
    EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(code)) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
  }
}

}  // namespace pellucida::test
