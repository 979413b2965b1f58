#include "FramePicture.h"

#include <vtkImageData.h>

#include "SmallPicture.h"
#include "pellucida/acquisition/OpenSource.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

// A camera's first frames are dark.
constexpr int kSettlingFrames = 8;

}  // namespace

QImage first_picture(const std::string& source) {
  // What the file leaves open is what is to be measured.
  const auto frames = open_source(source, {.pixel_size_um = 1.0, .frame_rate_hz = 1.0});
  std::optional<Frame> frame = frames->next();
  for (int k = 0; frame && frames->info().live && k < kSettlingFrames; ++k) frame = frames->next();
  if (!frame) throw InputError(source + ": there is no image in it");
  const auto image = frame->image.shallow_copy();
  const int* dimensions = image->GetDimensions();
  return small_picture(*image, QSize(dimensions[0], dimensions[1]));
}

}  // namespace pellucida
