#include "haptics/HandRun.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pellucida::test {

void DirectMap::engage(const HandSample& hand, const PlainVector3& tip_um) noexcept {
  hand_m_ = world_from_hand(hand.position_m).eigen();
  tip_um_ = last_um_ = tip_um.eigen();
}

TipTarget DirectMap::update(const HandSample& hand, double dt_s) noexcept {
  TipTarget target;
  target.clutched = (hand.buttons & kClutch) != 0;
  if (!target.clutched) {
    const Eigen::Vector3d tip_um = tip_um_ + scale_ * (world_from_hand(hand.position_m).eigen() - hand_m_);
    if (dt_s > 0.0) target.velocity_um_per_s = Eigen::Vector3d((tip_um - last_um_) / dt_s);
    last_um_ = tip_um;
  }
  target.tip_um = last_um_;
  return target;
}

double CubicCell::force_at(double depth) const {
  return punctured ? 0.0 : force_uN * std::pow(depth / at_depth_um, 3);
}

double CubicCell::stiffness_at(double depth) const {
  return punctured || depth <= 0.0 ? 0.0 : 3.0 * force_at(depth) / depth;
}

HandRun::HandRun(const DeviceSpecification& device, const HapticSettings& settings, double scale_um_per_m,
                 const ArmOptions& arm_options, const CameraOptions& camera)
    : HandRun(device, settings, std::make_unique<DirectMap>(scale_um_per_m), arm_options, camera) {}

HandRun::HandRun(const DeviceSpecification& device, const HapticSettings& settings, std::unique_ptr<MotionMap> map,
                 const ArmOptions& arm_options, const CameraOptions& camera)
    : arm(device, arm_options),
      camera_(camera),
      map_(std::move(map)),
      settings_(settings),
      servo_(std::make_unique<HapticServo>(arm, *map_, ports(), settings)) {}

void HandRun::change_hand() {
  servo_ = std::make_unique<HapticServo>(arm, *map_, ports(), settings_, servo_->contact());
}

ContactModel HandRun::look() const {
  ContactModel model;
  const double depth = cell.depth_um(pipette_um_.x());
  model.frame_index = frame_index_;
  model.confidence = 1.0;
  model.tip_um = pipette_um_;
  model.push = Eigen::Vector3d(1.0, 0.0, 0.0);
  model.state = cell.punctured ? CellState::kPunctured : depth > 0.0 ? CellState::kContact : CellState::kFree;
  model.valid = model.state == CellState::kContact || model.state == CellState::kFree;
  model.depth_um = depth;
  model.force_uN = Eigen::Vector3d(-cell.force_at(depth), 0.0, 0.0);
  model.stiffness_uN_per_um = stiffness_error_ratio * cell.stiffness_at(depth);
  if (camera_says_nan) model.force_uN.x = std::numeric_limits<double>::quiet_NaN();
  return model;
}

void HandRun::film() {
  if (cell.depth_um(pipette_um_.x()) >= cell.puncture_depth_um) cell.punctured = true;
  if (now_s_ >= next_frame_s_) {
    next_frame_s_ += 1.0 / camera_.frames_per_s;
    if (!camera_stalled) under_way_.push_back({now_s_ + camera_.latency_s, look()});
    ++frame_index_;
  }
  while (!under_way_.empty() && under_way_.front().due_s <= now_s_) {
    ContactModel model = under_way_.front().model;
    model.time_s = now_s_;
    contact_.publish(model);
    under_way_.pop_front();
  }
}

HapticRecord HandRun::tick(double dt_s) {
  now_s_ += dt_s;
  arm.advance(dt_s);
  // The pipette follows its command with a lag, and reports.
  if (command_.refresh()) last_command_ = command_.value();
  if (last_command_.max_speed_um_per_s > 0.0) {
    pipette_um_ += (1.0 - std::exp(-dt_s / camera_.pipette_lag_s)) * (last_command_.tip_um.eigen() - pipette_um_);
  }
  PipetteState state;
  state.time_s = now_s_;
  state.known = !pipette_lost;
  state.tip_um = pipette_um_;
  pipette_.publish(state);
  film();
  servo_->turn(now_s_);
  HapticRecord record;
  while (const auto drained = servo_->records().pop()) record = *drained;
  return record;
}

std::vector<HapticRecord> HandRun::run(double seconds) {
  std::vector<HapticRecord> records;
  const auto count = static_cast<std::size_t>(std::lround(1e3 * seconds));
  records.reserve(count);
  for (std::size_t k = 0; k < count; ++k) records.push_back(tick());
  return records;
}

std::vector<LimitEvent> HandRun::events() {
  std::vector<LimitEvent> drained;
  while (const auto event = servo_->events().pop()) drained.push_back(*event);
  return drained;
}

double largest_force_step_N(const std::vector<HapticRecord>& records) {
  double largest = 0.0;
  for (std::size_t k = 1; k < records.size(); ++k) {
    largest = std::max(largest, (records[k].hand_force_N.eigen() - records[k - 1].hand_force_N.eigen()).norm());
  }
  return largest;
}

double largest_tip_step_um(const std::vector<HapticRecord>& records) {
  double largest = 0.0;
  for (std::size_t k = 1; k < records.size(); ++k) {
    largest = std::max(largest, (records[k].tip_um.eigen() - records[k - 1].tip_um.eigen()).norm());
  }
  return largest;
}

}  // namespace pellucida::test
