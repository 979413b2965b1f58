#include "SnakePicture.h"

#include <algorithm>

#include "pellucida/core/Error.h"
#include "pellucida/pipeline/AnySource.h"
#include "pellucida/session/SessionSource.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pellucida/teaching_vtk/SnakeImage.h"

namespace pellucida {

void SnakePictureStep::read_frame(const SnakePictureOrder& order) {
  PlaybackOptions playback;
  double duration_s = 0.0;
  const bool recorded = is_session(order.source);
  if (recorded) {
    const SessionReader session(order.source);
    if (!session.measurements().empty()) duration_s = session.measurements().back().time_s;
    playback.from_s = std::min(order.time_s, duration_s);
  }
  const auto source = open_any_source(order.source, {}, playback);
  const SourceInfo& info = source->info();
  if (!recorded && info.frame_count) duration_s = static_cast<double>(*info.frame_count - 1) / info.frame_rate_hz;
  // What comes before need not be drawn.
  if (auto* microscope = dynamic_cast<VirtualMicroscope*>(source.get())) {
    const auto last = info.frame_count.value_or(1) - 1;
    const auto before = std::min(last, static_cast<long>(order.time_s * info.frame_rate_hz + 1e-6));
    for (long k = 0; k < before; ++k) microscope->skip();
  }
  image_ = {};
  while (auto frame = source->next()) {
    image_ = frame->image;
    if (recorded || frame->time_s >= order.time_s - 1e-6) break;
  }
  if (!image_) throw InputError(order.source + ": no picture in it; choose another recording");
  pixel_size_um_ = info.pixel_size_um;
  duration_s_ = duration_s;
}

expected<SnakePicturePtr, StepFailure> SnakePictureStep::process(const SnakePictureOrder& order) {
  auto picture = std::make_shared<SnakePicture>();
  picture->order = order;
  try {
    if (!image_ || order.source != read_.source || order.time_s != read_.time_s) read_frame(order);
    read_ = order;
    picture->image = image_;
    picture->pixel_size_um = pixel_size_um_;
    picture->duration_s = duration_s_;
    picture->field =
        std::make_shared<SnakeField>(snake_field(image_.get(), order.blur_px, snake_attraction(order.attraction)));
  } catch (const Error& error) {
    // Another recording can be chosen.
    image_ = {};
    picture->fault = error.what();
  }
  return SnakePicturePtr(std::move(picture));
}

}  // namespace pellucida
