#include "pellucida/evaluation/ContactCamera.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "pellucida/core/Error.h"

namespace pellucida {

ContactCamera::ContactCamera(const ContactCameraOptions& options, const SpecimenForce& cell)
    : options_(options),
      cell_(cell),
      outer_radius_um_((cell.tip_at(0.0, 0.0).eigen() - cell.frame().center_um.eigen()).norm()),
      random_(options.seed) {
  const auto require = [](bool good, const char* name, double value, const char* range) {
    if (!good) throw UsageError(std::string(name) + " is " + std::to_string(value) + "; it must be " + range);
  };
  require(options.frame_rate_hz > 0.0, "frame_rate_hz", options.frame_rate_hz, "above 0");
  require(options.delay_s >= 0.0 && options.delay_s * options.frame_rate_hz < static_cast<double>(kUnderWay - 1),
          "delay_s", options.delay_s, "0 or above, and less than 15 frames");
  require(options.depth_sigma_um >= 0.0, "depth_sigma_um", options.depth_sigma_um, "0 or above");
  require(options.force_relative_sigma >= 0.0, "force_relative_sigma", options.force_relative_sigma, "0 or above");
  require(options.tip_sigma_um >= 0.0, "tip_sigma_um", options.tip_sigma_um, "0 or above");
  scale_ = std::max(0.1, 1.0 + options.force_relative_sigma * normal_(random_));
}

bool ContactCamera::look(const SpecimenMoment& moment, double now_s) noexcept {
  if (!started_) {
    started_ = true;
    next_s_ = now_s;
  }
  if (now_s >= next_s_ && count_ < kUnderWay) {
    under_way_[(first_ + count_) % kUnderWay] = {now_s + options_.delay_s, measured(moment, now_s)};
    ++count_;
    next_s_ += 1.0 / options_.frame_rate_hz;
  }
  bool landed = false;
  while (count_ > 0 && under_way_[first_].due_s <= now_s) {
    newest_ = under_way_[first_].model;
    first_ = (first_ + 1) % kUnderWay;
    --count_;
    landed = true;
  }
  return landed;
}

ContactModel ContactCamera::measured(const SpecimenMoment& moment, double now_s) noexcept {
  const Eigen::Vector3d push = -cell_.frame().axis.eigen();
  const Eigen::Vector3d across = cell_.frame().across.eigen();
  ContactModel model;
  model.time_s = now_s;
  model.frame_index = frame_index_++;
  model.valid = true;
  model.state = moment.state;
  model.confidence = 1.0;
  model.push = PlainVector3(push);
  const double along_um = options_.tip_sigma_um * normal_(random_);
  const double across_um = options_.tip_sigma_um * normal_(random_);
  model.tip_um = PlainVector3(moment.tip_um.eigen() + along_um * push + across_um * across);
  model.cell_seen = true;
  model.center_um = cell_.frame().center_um;
  model.outer_radius_um = outer_radius_um_;
  if (moment.state != CellState::kContact) return model;

  // An error of the depth is one of the force along the curve.
  const double depth_error_um = options_.depth_sigma_um * normal_(random_);
  const double stiffness = std::max(0.0, moment.reply.stiffness_uN_per_um);
  const double force_uN = std::max(0.0, scale_ * (moment.reply.axial_force_uN + stiffness * depth_error_um));
  model.depth_um = std::max(0.0, moment.reply.indentation_um + depth_error_um);
  model.force_uN = PlainVector3(-force_uN * push);
  model.stiffness_uN_per_um = scale_ * stiffness;
  model.force_sigma_uN = std::hypot(options_.force_relative_sigma * force_uN, stiffness * options_.depth_sigma_um);
  return model;
}

}  // namespace pellucida
