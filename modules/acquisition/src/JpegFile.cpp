#include "JpegFile.h"

#include <csetjmp>
#include <cstdio>
#include <memory>
// Needs what <cstdio> declares.
#include <jpeglib.h>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

// The library's way to report: what it can't go on from ends the decoding, the rest is kept, nothing is printed.
struct JpegReport {
  jpeg_error_mgr library;  // first: the library knows of this part alone
  std::jmp_buf back;
  char text[JMSG_LENGTH_MAX];
};

JpegReport& report_of(j_common_ptr state) {
  return *reinterpret_cast<JpegReport*>(state->err);
}

// Each of a progressive picture's passes costs the time of a whole picture, and a few bytes: ten are usual.
constexpr int kMostScans = 100;

void refuse_many_scans(j_common_ptr state) {
  const auto* decoder = reinterpret_cast<j_decompress_ptr>(state);
  if (state->is_decompressor && decoder->input_scan_number > kMostScans) std::longjmp(report_of(state).back, 1);
}

enum class JpegResult { kRead, kBroken, kFourColours };

// No object with a destructor lives between the two ends of a jump.
JpegResult decode(std::FILE* file, GreyImage& image, JpegReport& report) {
  jpeg_decompress_struct state{};
  state.err = jpeg_std_error(&report.library);
  report.library.error_exit = [](j_common_ptr one) {
    one->err->format_message(one, report_of(one).text);
    std::longjmp(report_of(one).back, 1);
  };
  report.library.output_message = [](j_common_ptr) {};
  report.library.emit_message = [](j_common_ptr one, int level) {
    if (level < 0 && one->err->num_warnings++ == 0) one->err->format_message(one, report_of(one).text);
  };
  jpeg_progress_mgr progress{};
  progress.progress_monitor = refuse_many_scans;
  if (setjmp(report.back) != 0) {
    jpeg_destroy_decompress(&state);
    return JpegResult::kBroken;
  }
  jpeg_create_decompress(&state);
  state.progress = &progress;
  jpeg_stdio_src(&state, file);
  jpeg_read_header(&state, TRUE);
  if (state.num_components == 4) {
    jpeg_destroy_decompress(&state);
    return JpegResult::kFourColours;
  }
  state.out_color_space = JCS_GRAYSCALE;
  jpeg_start_decompress(&state);
  image = make_grey(static_cast<int>(state.output_width), static_cast<int>(state.output_height), 8);
  while (state.output_scanline < state.output_height) {
    JSAMPROW row = image.bytes.data() + static_cast<std::size_t>(state.output_scanline) * state.output_width;
    jpeg_read_scanlines(&state, &row, 1);
  }
  jpeg_finish_decompress(&state);
  jpeg_destroy_decompress(&state);
  return JpegResult::kRead;
}

}  // namespace

GreyImage read_jpeg(const std::filesystem::path& file) {
  const auto close = [](std::FILE* stream) { std::fclose(stream); };
  const std::unique_ptr<std::FILE, decltype(close)> stream(std::fopen(file.c_str(), "rb"), close);
  GreyImage image;
  JpegReport report{};
  const JpegResult result = stream ? decode(stream.get(), image, report) : JpegResult::kBroken;
  if (result == JpegResult::kFourColours) {
    throw InputError(file.string() + ": a JPEG of four colours (CMYK); convert it to grey or plain colour");
  }
  if (result == JpegResult::kBroken) {
    throw InputError(file.string() + ": broken image (its pixels can't be decoded); copy it again");
  }
  if (report.library.num_warnings > 0) image.damage = report.text;
  return image;
}

}  // namespace pellucida
