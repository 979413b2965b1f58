#include "pellucida/operation/VirtualExposure.h"

#include <vtkNew.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "pellucida/core/CameraExposure.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr double kUsual_ms = 10.0, kLeast_ms = 2.0, kMost_ms = 30.0;

class VirtualExposure final : public CameraExposure {
 public:
  State state() const override { return {time_ms_.load(), kLeast_ms, kMost_ms, false, false}; }
  void set_time_ms(double time_ms) override {
    if (!std::isfinite(time_ms)) throw UsageError("the exposure time must be a number, ms");
    time_ms_ = std::clamp(time_ms, kLeast_ms, kMost_ms);
  }
  void set_automatic() override { throw UsageError("the virtual camera has no automatic exposure; set a time"); }

 private:
  std::atomic<double> time_ms_{kUsual_ms};
};

template <typename Grey>
void scale_greys(vtkImageData& image, double ratio) {
  auto* const begin = static_cast<Grey*>(image.GetScalarPointer());
  static constexpr double kWhite = std::numeric_limits<Grey>::max();
  std::for_each(begin, begin + image.GetNumberOfPoints(),
                [ratio](Grey& grey) { grey = static_cast<Grey>(std::lround(std::min(kWhite, ratio * grey))); });
}

class ExposedSource final : public FrameSource {
 public:
  explicit ExposedSource(std::unique_ptr<FrameSource> source) : source_(std::move(source)) {}

  const SourceInfo& info() const noexcept override { return source_->info(); }
  bool restart() override { return source_->restart(); }
  std::shared_ptr<CameraExposure> exposure() override { return exposure_; }

  std::optional<Frame> next() override {
    auto frame = source_->next();
    const double ratio = exposure_->state().time_ms / kUsual_ms;
    if (!frame || ratio == 1.0) return frame;
    vtkNew<vtkImageData> image;
    image->DeepCopy(frame->image.shallow_copy());
    image->GetScalarSize() == 1 ? scale_greys<unsigned char>(*image, ratio)
                                : scale_greys<unsigned short>(*image, ratio);
    frame->image = Frozen<vtkImageData>(image);
    return frame;
  }

 private:
  std::unique_ptr<FrameSource> source_;
  std::shared_ptr<VirtualExposure> exposure_ = std::make_shared<VirtualExposure>();
};

}  // namespace

std::unique_ptr<FrameSource> with_virtual_exposure(std::unique_ptr<FrameSource> source) {
  return std::make_unique<ExposedSource>(std::move(source));
}

}  // namespace pellucida
