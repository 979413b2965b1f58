#include "FramePicture.h"

#include <vtkImageData.h>

#include <algorithm>
#include <cmath>

#include "pellucida/acquisition/OpenSource.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

// A camera's first frames are dark.
constexpr int kSettlingFrames = 8;

}  // namespace

QImage grey_picture(vtkImageData& image, QSize size_px) {
  const int* dimensions = image.GetDimensions();
  if (dimensions[0] < 1 || dimensions[1] < 1 || image.GetNumberOfScalarComponents() < 1) return {};
  const QSize size = QSize(dimensions[0], dimensions[1]).scaled(size_px, Qt::KeepAspectRatioByExpanding);
  double range[2];
  image.GetScalarRange(range);
  const double scale = range[1] > range[0] ? 255.0 / (range[1] - range[0]) : 0.0;
  QImage picture(size, QImage::Format_Grayscale8);
  for (int y = 0; y < size.height(); ++y) {
    uchar* line = picture.scanLine(y);
    for (int x = 0; x < size.width(); ++x) {
      const double value =
          image.GetScalarComponentAsDouble(x * dimensions[0] / size.width(), y * dimensions[1] / size.height(), 0, 0);
      line[x] = static_cast<uchar>(std::clamp(std::lround(scale * (value - range[0])), 0L, 255L));
    }
  }
  return picture;
}

QImage first_picture(const std::string& source) {
  // What the file leaves open is what is to be measured.
  const auto frames = open_source(source, {.pixel_size_um = 1.0, .frame_rate_hz = 1.0});
  std::optional<Frame> frame = frames->next();
  for (int k = 0; frame && frames->info().live && k < kSettlingFrames; ++k) frame = frames->next();
  if (!frame) throw InputError(source + ": there is no image in it");
  const auto image = frame->image.shallow_copy();
  const int* dimensions = image->GetDimensions();
  return grey_picture(*image, QSize(dimensions[0], dimensions[1]));
}

}  // namespace pellucida
