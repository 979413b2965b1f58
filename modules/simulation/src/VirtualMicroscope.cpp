#include "pellucida/simulation/VirtualMicroscope.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "OpticalScene.h"
#include "Renderer.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {

class VirtualMicroscope::Impl {
 public:
  Impl(const Scenario& scenario, std::shared_ptr<NeedleDrive> needle, Pace pace,
       const std::optional<Look>& look = std::nullopt)
      : scenario_(with_tools_drawn(scenario)),
        specimen_(scenario),
        needle_(needle ? std::move(needle) : std::make_shared<ScriptedNeedle>(scenario, specimen_)) {
    if (look)
      optical_.emplace(scenario_, *look, specimen_);
    else if (scenario.look != kDrawing)
      optical_.emplace(scenario_, load_look(scenario.look), specimen_);
    else
      drawing_.emplace(scenario_, specimen_);
    const auto& image = scenario_.image;
    const std::optional<double> duration_s = image.duration_s > 0 ? image.duration_s : needle_->duration_s();
    info_.name = "virtual:" + scenario_.name;
    info_.width_px = image.width_px;
    info_.height_px = image.height_px;
    info_.bit_depth = image.bit_depth;
    info_.pixel_size_um = image.pixel_size_um;
    info_.pixel_size_origin = "scenario";
    info_.frame_rate_hz = image.frame_rate_hz;
    info_.frame_rate_origin = "scenario";
    info_.seeds = {{"scenario", scenario_.seed}};
    info_.live = pace == Pace::kWallClock;
    // At least one frame; the epsilon forgives a product such as 5.3 * 30 that falls short of a whole number.
    if (duration_s)
      info_.frame_count = std::max(1L, static_cast<long>(std::ceil(*duration_s * image.frame_rate_hz - 1e-6)));
    restart();
  }

  void restart() {
    // Numbered on, as a run does it.
    first_number_ += next_index_;
    next_index_ = 0;
    specimen_.reset();
    needle_->restart();
    move_to(0);
  }

  bool skip() {
    if (ended()) return false;
    move_to(next_index_++);
    return true;
  }

  std::optional<Frame> next() {
    const long gap_count = info_.live && !ended() ? wait() : 0;
    if (ended()) return std::nullopt;
    const long index = next_index_++;
    move_to(index);
    const ImageView view = optical_ ? optical_->render(truth_, state_, stage_) : draw();
    Frame frame;
    frame.time_s = truth_.observation.time_s;
    frame.frame_index = index;
    frame.gap_count = gap_count;
    frame.image = Frozen<vtkImageData>(make_frame(view, frame.time_s, index));
    return frame;
  }

  Scenario scenario_;
  SourceInfo info_;
  Truth truth_;
  const std::shared_ptr<TruthLog> truths_ = std::make_shared<TruthLog>();

 private:
  bool ended() const noexcept { return info_.frame_count && next_index_ >= *info_.frame_count; }

  // Until the next frame is to be exposed; how many were missed, because they were not requested in time.
  long wait() {
    const double rate_hz = scenario_.image.frame_rate_hz;
    const auto now = std::chrono::steady_clock::now();
    if (!first_exposure_) first_exposure_ = now - seconds(static_cast<double>(next_index_) / rate_hz);
    const double since_s = std::chrono::duration<double>(now - *first_exposure_).count();
    const long due = static_cast<long>(std::floor(since_s * rate_hz)), missed = std::max(0L, due - next_index_);
    next_index_ += missed;
    std::this_thread::sleep_until(*first_exposure_ + seconds(static_cast<double>(next_index_) / rate_hz));
    return missed;
  }

  static std::chrono::steady_clock::duration seconds(double time_s) {
    return std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(time_s));
  }

  ImageView draw() {
    const cv::Mat& pixels = drawing_->render(truth_, state_, stage_);
    ImageView view;
    view.data = pixels.data;
    view.format = info_.bit_depth == 16 ? PixelFormat::kGray16 : PixelFormat::kGray8;
    view.width_px = pixels.cols;
    view.height_px = pixels.rows;
    view.row_bytes = static_cast<std::ptrdiff_t>(pixels.step[0]);
    view.pixel_size_um = info_.pixel_size_um;
    return view;
  }

  // The drive moves the needle, the specimen answers.
  void move_to(long index) {
    const double time_s = static_cast<double>(index) / scenario_.image.frame_rate_hz;
    const NeedleCommand needle = needle_->at(time_s);
    if (needle.moment)
      state_ = specimen_.show(*needle.moment);
    else if (needle.straight_depth_um)
      state_ = specimen_.advance(*needle.straight_depth_um, time_s);
    else
      state_ = specimen_.advance(needle.tip_um, time_s, needle.expelled_pL);
    stage_ = stage_pose(scenario_, time_s);
    truth_ = make_truth(scenario_, specimen_, state_, stage_, time_s, index);
    if (optical_) optical_->shape_tools(truth_);
    truths_->add(first_number_ + index, truth_.contact_force_uN);
  }

  VirtualSpecimen specimen_;
  std::shared_ptr<NeedleDrive> needle_;
  std::optional<std::chrono::steady_clock::time_point> first_exposure_;
  std::optional<Renderer> drawing_;  // one of the two
  std::optional<OpticalScene> optical_;
  SpecimenState state_;
  StagePose stage_;
  long next_index_ = 0;
  long first_number_ = 0;  // of frame 0, over all restarts
};

VirtualMicroscope::VirtualMicroscope(const Scenario& scenario) {
  validate(scenario);
  impl_ = std::make_unique<Impl>(scenario, nullptr, Pace::kAsFastAsPossible);
}
VirtualMicroscope::VirtualMicroscope(const Scenario& scenario, const Look& look) {
  validate(scenario);
  validate(look);
  impl_ = std::make_unique<Impl>(scenario, nullptr, Pace::kAsFastAsPossible, look);
}
VirtualMicroscope::VirtualMicroscope(const Scenario& scenario, std::shared_ptr<NeedleDrive> needle, Pace pace) {
  validate(scenario);
  impl_ = std::make_unique<Impl>(scenario, std::move(needle), pace);
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
  if (impl_->info_.live) return false;
  impl_->restart();
  return true;
}
const Truth& VirtualMicroscope::truth() const noexcept {
  return impl_->truth_;
}
std::shared_ptr<const TruthLog> VirtualMicroscope::truth_log() const noexcept {
  return impl_->truths_;
}
const Scenario& VirtualMicroscope::scenario() const noexcept {
  return impl_->scenario_;
}

std::unique_ptr<VirtualMicroscope> open_virtual(std::string_view scenario) {
  return std::make_unique<VirtualMicroscope>(load_scenario(scenario));
}

}  // namespace pellucida
