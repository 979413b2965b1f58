#include "JpegFile.h"

#include <opencv2/imgcodecs.hpp>

#include "MatGrey.h"
#include "VideoFileSource.h"
#include "pellucida/core/Error.h"

namespace pellucida {

GreyImage read_jpeg(const std::filesystem::path& file) {
  silence_video_libraries();
  cv::Mat pixels;
  try {
    pixels = cv::imread(file.string(), cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    // Too large a picture ends here; it is refused like any other that can't be decoded.
    pixels.release();
  }
  if (pixels.empty()) throw InputError(file.string() + ": broken image (its pixels can't be decoded); copy it again");
  return grey_from_mat(pixels);
}

}  // namespace pellucida
