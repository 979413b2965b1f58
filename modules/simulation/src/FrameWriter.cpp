#include "pellucida/simulation/FrameWriter.h"

#include <tiffio.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/core/Table.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& output, const std::string& why = "check folder, permission and free space") {
  // The libraries keep the system's reason to themselves; a full disk can be seen all the same.
  std::error_code unknown;
  const fs::space_info room = fs::space(output.has_parent_path() ? output.parent_path() : ".", unknown);
  if (!unknown && room.available < (std::uintmax_t{1} << 16U)) throw disk_error(output, ENOSPC);
  throw OutputError("output '" + output.string() + "' can't be written; " + why);
}

// The frame's pixels as OpenCV sees them; nothing is copied.
cv::Mat pixels_of(const Frame& frame) {
  const ImageView view = view_of(frame.image.get());
  return cv::Mat(view.height_px, view.width_px, view.format == PixelFormat::kGray16 ? CV_16U : CV_8U,
                 const_cast<void*>(view.data), static_cast<std::size_t>(view.row_bytes));
}

class VideoWriter : public FrameWriter {
 public:
  VideoWriter(const fs::path& output, const SourceInfo& info, const std::string& extension) : output_(output) {
    // FFmpeg's writer creates the file even where no frame will follow: ask the file system first, it says why.
    if (std::FILE* file = std::fopen(output.c_str(), "wb"))
      std::fclose(file);
    else
      fail(output);

    struct Choice {
      const char* fourcc;
      const char* words;
    };
    std::vector<Choice> choices;
    if (extension == ".avi")
      choices = {{"FFV1", "AVI, FFV1, lossless"}, {"MJPG", "AVI, Motion JPEG, lossy"}};
    else if (extension == ".mkv")
      choices = {{"FFV1", "Matroska, FFV1, lossless"}};
    else
      choices = {{"avc1", "MP4, H.264, lossy"}, {"mp4v", "MP4, MPEG-4, lossy"}};
    for (const auto& [fourcc, words] : choices) {
      const int code = cv::VideoWriter::fourcc(fourcc[0], fourcc[1], fourcc[2], fourcc[3]);
      if (writer_.open(output.string(), cv::CAP_FFMPEG, code, info.frame_rate_hz, {info.width_px, info.height_px},
                       false)) {
        words_ = words;
        return;
      }
    }
    fs::remove(output);
    fail(output, "this OpenCV has no encoder for " + extension + "; use .tif or a folder of PNG");
  }

  void write(const Frame& frame) override {
    writer_.write(pixels_of(frame));
    ++count_;
  }

  void close() override {
    writer_.release();
    // OpenCV keeps write errors (a full disk) to itself: ask the file how long it is. Containers round their duration.
    cv::VideoCapture written(output_.string(), cv::CAP_FFMPEG);
    if (!written.isOpened() || std::abs(written.get(cv::CAP_PROP_FRAME_COUNT) - static_cast<double>(count_)) > 1.5)
      fail(output_);
  }

  std::string format() const override { return words_; }

 private:
  fs::path output_;
  cv::VideoWriter writer_;
  long count_ = 0;
  std::string words_;
};

class TiffWriter : public FrameWriter {
 public:
  TiffWriter(const fs::path& output, const SourceInfo& info) : output_(output), info_(info) {
    // Beyond 4 GB only BigTIFF; the frames are counted uncompressed.
    const double bytes = static_cast<double>(info.width_px) * info.height_px * (info.bit_depth / 8) *
                         static_cast<double>(info.frame_count.value_or(0));
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
    file_.reset(TIFFOpen(output.c_str(), bytes > 3.5e9 ? "w8" : "w"));
    if (!file_) fail(output);
  }

  void write(const Frame& frame) override {
    const cv::Mat pixels = pixels_of(frame);
    TIFF* file = file_.get();
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, pixels.cols);
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, pixels.rows);
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, info_.bit_depth);
    TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(file, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
    TIFFSetField(file, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
    TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(file, 0));
    // ImageJ reads the scale as pixels a unit, and the rest from the description of the first page.
    TIFFSetField(file, TIFFTAG_RESOLUTIONUNIT, RESUNIT_NONE);
    TIFFSetField(file, TIFFTAG_XRESOLUTION, static_cast<float>(1 / info_.pixel_size_um));
    TIFFSetField(file, TIFFTAG_YRESOLUTION, static_cast<float>(1 / info_.pixel_size_um));
    if (frame.frame_index == 0) {
      const std::string count = std::to_string(info_.frame_count.value_or(1));
      const std::string text = "ImageJ=1.53\nimages=" + count + "\nframes=" + count +
                               "\nunit=um\nfinterval=" + csv_number(1 / info_.frame_rate_hz) +
                               "\npixel size: " + csv_number(info_.pixel_size_um) + " um\n";
      TIFFSetField(file, TIFFTAG_IMAGEDESCRIPTION, text.c_str());
    }
    // The predictor works in place: libtiff gets a row of its own.
    cv::Mat row;
    for (int y = 0; y < pixels.rows; ++y) {
      pixels.row(y).copyTo(row);
      if (TIFFWriteScanline(file, row.data, static_cast<std::uint32_t>(y), 0) < 0) fail(output_);
    }
    if (!TIFFWriteDirectory(file)) fail(output_);
  }

  void close() override {
    if (file_ && !TIFFFlush(file_.get())) fail(output_);
    file_.reset();
  }

  std::string format() const override { return "multi-page TIFF, lossless"; }

 private:
  struct Close {
    void operator()(TIFF* file) const { TIFFClose(file); }
  };
  fs::path output_;
  SourceInfo info_;
  std::unique_ptr<TIFF, Close> file_;
};

class FolderWriter : public FrameWriter {
 public:
  explicit FolderWriter(const fs::path& output) : output_(output) {
    std::error_code error;
    fs::create_directories(output, error);
    if (error || !fs::is_directory(output)) fail(output);
    // Among the images of an earlier run, which may be more, these would not be a run of their own.
    for (const auto& entry : fs::directory_iterator(output, error)) {
      const std::string name = entry.path().filename().string();
      if (!name.starts_with("frame_") || !name.ends_with(".png")) continue;
      throw UsageError("--output " + output.string() + ": already holds images (" + name +
                       "), among which these would be lost; choose another folder, or empty it");
    }
  }

  void write(const Frame& frame) override {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%06ld.png", frame.frame_index);
    // Encoded here and written by the stream: libpng would print its own line about a full disk.
    std::vector<unsigned char> bytes;
    if (!cv::imencode(".png", pixels_of(frame), bytes)) fail(output_ / name);
    // On the disk before it has its name: a power cut leaves whole images.
    OutputFile file(output_ / name, OutputFile::Link::kReplace);
    file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    file.finish();
  }

  void close() override {}
  std::string format() const override { return "folder of PNG, lossless"; }

 private:
  fs::path output_;
};

}  // namespace

std::unique_ptr<FrameWriter> FrameWriter::open(const fs::path& output, const SourceInfo& info) {
  std::string extension = output.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  const bool folder_missing = output.has_parent_path() && !fs::is_directory(output.parent_path());
  if (extension.empty()) return std::make_unique<FolderWriter>(output);
  if (folder_missing) fail(output, "its folder does not exist");
  if (extension == ".tif" || extension == ".tiff") return std::make_unique<TiffWriter>(output, info);
  if (extension == ".avi" || extension == ".mkv" || extension == ".mp4") {
    if (info.bit_depth == 16)
      throw UsageError("--output " + output.string() + ": 16-bit frames don't go into " + extension +
                       "; use .tif or a folder (no extension)");
    return std::make_unique<VideoWriter>(output, info, extension);
  }
  throw UsageError("--output " + output.string() + ": '" + extension +
                   "' is not known; use .avi, .mkv, .mp4, .tif, or no extension for a folder of PNG");
}

}  // namespace pellucida
