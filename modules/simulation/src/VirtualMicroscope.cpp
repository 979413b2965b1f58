#include "pellucida/simulation/VirtualMicroscope.h"

#include <cmath>

#include "Renderer.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/NeedleScript.h"

namespace pellucida {

class VirtualMicroscope::Impl {
 public:
  explicit Impl(const Scenario& scenario)
      : scenario_(scenario), specimen_(scenario), script_(scenario.motion), renderer_(scenario, specimen_) {
    const auto& image = scenario_.image;
    const double duration_s = image.duration_s > 0 ? image.duration_s : script_.duration_s();
    info_.name = "virtual:" + scenario_.name;
    info_.width_px = image.width_px;
    info_.height_px = image.height_px;
    info_.bit_depth = image.bit_depth;
    info_.pixel_size_um = image.pixel_size_um;
    info_.pixel_size_origin = "scenario";
    info_.frame_rate_hz = image.frame_rate_hz;
    info_.frame_rate_origin = "scenario";
    // At least one frame; the epsilon forgives a product such as 5.3 * 30 that falls short of a whole number.
    info_.frame_count = std::max(1L, static_cast<long>(std::ceil(duration_s * image.frame_rate_hz - 1e-6)));
    restart();
  }

  void restart() {
    next_index_ = 0;
    specimen_.reset();
    move_to(0);
  }

  bool skip() {
    if (next_index_ >= *info_.frame_count) return false;
    move_to(next_index_++);
    return true;
  }

  std::optional<Frame> next() {
    if (next_index_ >= *info_.frame_count) return std::nullopt;
    const long index = next_index_++;
    move_to(index);
    const cv::Mat& pixels = renderer_.render(truth_, state_, stage_);

    ImageView view;
    view.data = pixels.data;
    view.format = info_.bit_depth == 16 ? PixelFormat::kGray16 : PixelFormat::kGray8;
    view.width_px = pixels.cols;
    view.height_px = pixels.rows;
    view.row_bytes = static_cast<std::ptrdiff_t>(pixels.step[0]);
    view.pixel_size_um = info_.pixel_size_um;
    Frame frame;
    frame.time_s = truth_.observation.time_s;
    frame.frame_index = index;
    frame.image = Frozen<vtkImageData>(make_frame(view, frame.time_s, index));
    return frame;
  }

  Scenario scenario_;
  SourceInfo info_;
  Truth truth_;

 private:
  // The script moves the needle, the specimen answers.
  void move_to(long index) {
    const double time_s = static_cast<double>(index) / scenario_.image.frame_rate_hz;
    state_ = specimen_.advance(script_.depth_um(time_s), time_s);
    stage_ = stage_pose(scenario_, time_s);
    truth_ = make_truth(scenario_, specimen_, state_, stage_, time_s, index);
  }

  VirtualSpecimen specimen_;
  NeedleScript script_;
  Renderer renderer_;
  SpecimenState state_;
  StagePose stage_;
  long next_index_ = 0;
};

VirtualMicroscope::VirtualMicroscope(const Scenario& scenario) {
  validate(scenario);
  impl_ = std::make_unique<Impl>(scenario);
}
VirtualMicroscope::~VirtualMicroscope() = default;

const SourceInfo& VirtualMicroscope::info() const noexcept {
  return impl_->info_;
}
std::optional<Frame> VirtualMicroscope::next() {
  return impl_->next();
}
bool VirtualMicroscope::skip() {
  return impl_->skip();
}
bool VirtualMicroscope::restart() {
  impl_->restart();
  return true;
}
const Truth& VirtualMicroscope::truth() const noexcept {
  return impl_->truth_;
}
const Scenario& VirtualMicroscope::scenario() const noexcept {
  return impl_->scenario_;
}

std::unique_ptr<VirtualMicroscope> open_virtual(std::string_view scenario) {
  return std::make_unique<VirtualMicroscope>(load_scenario(scenario));
}

}  // namespace pellucida
