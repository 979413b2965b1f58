#include "NeedleTracker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace pellucida {
namespace {

constexpr double kBehind = 85.0, kMostBehind = 170.0;  // units, and px at most, of the shaft looked at behind the tip
constexpr int kLearnFrames = 40;
// Errors along the needle that noise does not explain, in units: of the cone's place when the needle was first seen in
// contact.
constexpr double kFirstAnchor = 1.0, kBlurredEnd = 4.0, kClearAnchor = 0.3;
// Apart by so much, px, end and cone leave the tip in doubt, whichever counts.
constexpr double kDisputed_px = 3.0;
// A needle of this confidence is seen well; a fainter one has not faded while it keeps this share of what it had of
// late, which follows by so much a frame. Looked at on a film by path (relief06 of seed 737373).
constexpr double kClear = 0.5, kKept_ratio = 0.7, kUsualPace = 0.1;

// A shaft that is far out of focus where it comes in may be in focus near its tip: looks at it anew from further in.
NeedleGuess sharpened(const FrameSampler& image, NeedleGuess guess, double noise, const ExpectedTip* expected) {
  for (const double part : {0.6, 0.85}) {
    const double blur = guess.model.look.blur(), left = (1.0 - part) * guess.length_px;
    if (blur < 3.0 || left < 12.0) break;
    FoundTool tool;
    tool.origin = guess.axis.at(left, 0.0);
    tool.direction = -guess.axis.direction;
    tool.offset_to = guess.model.cone.half_width(left) + 0.7 * blur;
    tool.offset_from = -tool.offset_to;
    std::optional<NeedleGuess> nearer = guess_needle(image, tool, noise, part * guess.length_px, expected);
    if (!nearer || nearer->model.look.blur() > 0.85 * blur) continue;
    // Two lines that merge towards the tip are no sharper needle.
    if (guess.model.look.is_line() && !nearer->model.look.is_line()) continue;
    // It must not end earlier than it did.
    if ((nearer->axis.tip - guess.axis.tip).dot(guess.axis.direction) < -2.0 * blur) continue;
    nearer->length_px += part * guess.length_px;
    nearer->strength = std::max(nearer->strength, guess.strength);
    guess = std::move(*nearer);
  }
  return guess;
}

}  // namespace

bool NeedleTracker::start(const FrameSampler& image, const FoundTool& tool, double noise, const ExpectedTip* expected) {
  reset();
  std::optional<NeedleGuess> guess = guess_needle(image, tool, noise, 0.0, expected);
  if (!guess || !start(image, sharpened(image, std::move(*guess), noise, expected), noise)) return false;
  valid_ = !expected || (now_.tip - expected->place).norm() < 2.0 * expected->reach_px;
  return valid_;
}

bool NeedleTracker::start_anywhere(const FrameSampler& image, const GrayImage& gray, double noise) {
  reset();
  std::vector<NeedleGuess> guesses;
  for (const FoundTool& tool : find_tools(gray))
    if (std::optional<NeedleGuess> guess = guess_needle(image, tool, noise)) guesses.push_back(std::move(*guess));
  std::stable_sort(guesses.begin(), guesses.end(),
                   [](const NeedleGuess& a, const NeedleGuess& b) { return a.strength > b.strength; });
  for (NeedleGuess& guess : guesses)
    if (start(image, sharpened(image, std::move(guess), noise, nullptr), noise)) return true;
  reset();
  return false;
}

bool NeedleTracker::start(const FrameSampler& image, NeedleGuess guess, double noise) {
  reset();
  axis_ = guess.axis;
  model_ = std::move(guess.model);
  prepare();
  // Fit, look for the end, learn; each round knows better what it looks for.
  const NeedleCue clear{.in_the_clear = true};
  ShaftResult shaft;
  Along end;
  for (int round = 0; round < 4; ++round) {
    shaft = align(image, noise, 3);
    if (!shaft.found || shaft.support < 0.4) return false;
    end = find_end(image, noise, shaft, round == 0 ? 10.0 * model_.unit_px : again_px(), clear);
    const double ahead = end.valid ? end.ahead : 0.0;
    model_.frames = 0;
    learn(ahead);
    set_zero();
    prepare();
  }
  shaft = align(image, noise, 2);
  if (!shaft.found) return false;
  learn_end(image, noise, shaft);
  end = find_end(image, noise, shaft, again_px(), clear);
  if (end.valid) {
    axis_.tip += end.ahead * axis_.direction;
    model_.cone.move(end.ahead, 0.0);
    prepare();
  }
  // Whether a membrane is at the tip isn't known yet; an end not seen clearly is known to a block of the first search.
  anchor_sigma_ = (end.valid ? kFirstAnchor : kBlurredEnd) * model_.unit_px;
  covariance_ << anchor_sigma_ * anchor_sigma_, 0.0, 0.0, 4.0;
  now_.evidence = kShaftEdges | kTipEnd;
  fill(noise, shaft);
  axis_before_ = axis_;
  valid_ = now_.confidence > 0.2;
  return valid_;
}

bool NeedleTracker::track(const FrameSampler& image, double noise, const NeedleCue& cue) {
  if (!valid_) return false;
  learn_confidence();
  is_by_shaft_ = false;
  const NeedleAxis before = axis_;
  axis_before_ = before;
  const double unit = model_.unit_px;

  // Predict: where it was sent, else on as before.
  const Eigen::Vector2d sideways = motion_ - motion_.dot(axis_.direction) * axis_.direction;
  const auto sent = cue.command ? cue.command->due(tip() + cue.scene_jump_px) : std::nullopt;
  if (sent) speed_ = sent->ahead_px;
  const Eigen::Vector2d expected = sideways + speed_ * axis_.direction;
  axis_.tip += expected + cue.scene_jump_px;
  due_ = axis_.tip;
  ahead_ = 0.0;
  Eigen::Matrix2d transition;
  transition << 1.0, 1.0, 0.0, 1.0;
  const double change = sent ? std::max(0.15, sent->sigma_px) : std::max(0.15, unrest_);
  Eigen::Matrix2d process;
  process << 0.25, 0.5, 0.5, 1.0;
  covariance_ = transition * covariance_ * transition.transpose() + change * change * process;

  ShaftResult shaft = align(image, noise, 2);
  if (!shaft.found || shaft.support < 0.6) {
    // Knocked aside? Look further, from where it was too.
    double best = 0.0;
    NeedleAxis found = axis_;
    const std::array<Eigen::Vector2d, 2> starts{before.tip + expected + cue.scene_jump_px, before.tip};
    for (const Eigen::Vector2d& from : starts) {
      const NeedleAxis axis{from, before.direction};
      double alike = 0.0;
      const double beside = shaft_.find_beside(image, axis, 1.2 * cue.reach_px, alike);
      if (alike <= best) continue;
      best = alike;
      found = {from + beside * axis.across(), before.direction};
    }
    const NeedleAxis tried = axis_;
    axis_ = found;
    const ShaftResult wide = align(image, noise, 4);
    if (wide.found && wide.support > shaft.support) {
      shaft = wide;
    } else {
      axis_ = tried;
    }
  }
  Along end, cone;
  if (shaft.found && shaft.support > 0.25) {
    end = find_end(image, noise, shaft, 4.0 * unit, cue);
    const bool far_by_cone = model_.frames > 0 && std::abs(shaft.ahead) > 3.0 * unit + 3.0 * shaft.ahead_sigma;
    if (!end.valid || far_by_cone) {
      // A jump along the axis: look far, then fit again from there.
      end = find_end(image, noise, shaft, cue.reach_px, cue);
      if (end.valid && std::abs(end.ahead) > 2.0 * unit) {
        const double jump = end.ahead;
        axis_.tip += jump * axis_.direction;
        covariance_(0, 0) += jump * jump;
        shaft = align(image, noise, 2);
        end = find_end(image, noise, shaft, 4.0 * unit, cue);
      }
    }
    if (shaft.found && shaft.ahead_sigma < 100.0) {
      const double sigma = std::hypot(shaft.ahead_sigma, anchor_sigma_);
      cone = {true, shaft.ahead, sigma * sigma};
    }
  }
  NeedleEvidence evidence = kNoNeedleEvidence;
  if (!(end.valid || cone.valid) || !fuse(end, cone, cue.in_the_clear, sent.has_value(), evidence)) {
    axis_ = before;
    now_.tip = tip();
    now_.direction = axis_.direction;
    now_.confidence *= 0.5;
    motion_.setZero();
    speed_ = 0.0;
    return false;
  }
  now_.evidence = evidence | (sent ? kCommandedMotion : kNoNeedleEvidence);
  // Learning costs more than following: once the look is known, a frame now and then is enough.
  const bool due = model_.frames < 12 || ++frames_since_learning_ >= 6;
  if (cue.in_the_clear && due && end.valid && shaft.support > 0.7 && std::abs(end.ahead - ahead_) < unit) {
    learn(end.ahead);
    learn_end(image, noise, shaft);
  }
  axis_.tip += ahead_ * axis_.direction;
  ahead_ = 0.0;
  motion_ = axis_.tip - before.tip - cue.scene_jump_px;
  fill(noise, shaft);
  // A black or blinding frame leaves nothing to divide by.
  if (now_.tip.allFinite() && now_.direction.allFinite() && std::isfinite(now_.confidence)) return true;
  reset();
  return false;
}

void NeedleTracker::take_dimple(const Eigen::Vector2d& apex, double sigma_px) {
  if (!valid_ || !(sigma_px > 0.0)) return;
  const double ahead = (apex - axis_.tip).dot(axis_.direction);
  // Further off than both can be wrong: the apex is something else.
  if (ahead * ahead > 9.0 * (covariance_(0, 0) + sigma_px * sigma_px)) return;
  ahead_ = 0.0;
  update(ahead, sigma_px * sigma_px);
  axis_.tip += ahead_ * axis_.direction;
  motion_ += ahead_ * axis_.direction;
  ahead_ = 0.0;
  now_.tip = tip();
  now_.tip_sigma = std::sqrt(covariance_(0, 0));
  now_.evidence = now_.evidence | kDimple;
}

void NeedleTracker::rest_on(const Eigen::Vector2d& apex, double sigma_px) {
  if (!valid_ || !(sigma_px > 0.0)) return;
  const double ahead = (apex - axis_.tip).dot(axis_.direction);
  axis_.tip += ahead * axis_.direction;
  model_.cone.move(ahead, 0.0);
  prepare();
  anchor_sigma_ = std::hypot(sigma_px, kClearAnchor * model_.unit_px);
  covariance_(0, 0) = sigma_px * sigma_px;
  covariance_(0, 1) = covariance_(1, 0) = 0.0;
  now_.tip = tip();
  now_.tip_half_width = model_.cone.tip_radius();
  take_width();
  now_.tip_sigma = sigma_px;
  now_.evidence = now_.evidence | kDimple;
}

void NeedleTracker::hold(const CommandedMotion::Along& due) {
  if (!valid_) return;
  axis_.tip += due.ahead_px * axis_.direction;
  motion_ += due.ahead_px * axis_.direction;
  covariance_(0, 0) = due.sigma_px * due.sigma_px;
  covariance_(0, 1) = covariance_(1, 0) = 0.0;
  now_.tip = tip();
  now_.tip_sigma = due.sigma_px;
  now_.evidence = now_.evidence | kCommandedMotion;
}

Eigen::Vector2d NeedleTracker::tip() const {
  return axis_.tip + beside_ * axis_.across();
}

void NeedleTracker::prepare() {
  shaft_.prepare(model_, std::min(kBehind * model_.unit_px, kMostBehind));
  tip_.prepare(model_);
}

// The outline is where the look has its mark.
void NeedleTracker::set_zero() {
  const double left = model_.look.mark(0), right = model_.look.mark(1), wider = 0.5 * (left + right);
  model_.look.shift(0, left);
  model_.look.shift(1, right);
  model_.cone.move(wider, wider);
  axis_.tip += wider * axis_.direction + 0.5 * (right - left) * axis_.across();
}

// How far the end may be from where it was found before: no further than to another body beside it.
double NeedleTracker::again_px() const {
  return std::min(6.0 * model_.unit_px, std::max(6.0, 3.0 * model_.unit_px));
}

// Brings the axis onto the shaft.
ShaftResult NeedleTracker::align(const FrameSampler& image, double noise, int rounds) {
  ShaftResult shaft;
  for (int round = 0; round < rounds; ++round) {
    shaft = shaft_.measure(image, axis_, noise);
    if (!shaft.found) return shaft;
    const Eigen::Vector2d across = axis_.across();
    axis_.tip += shaft.offset * across;
    axis_.direction = (axis_.direction - shaft.slope * across).normalized();
    const double blur = shaft_.blur_px();
    if (std::abs(shaft.offset) < 0.1 * blur && std::abs(shaft.slope) * shaft_.behind_px() < 0.2 * blur) break;
  }
  return shaft;
}

bool NeedleTracker::fuse(const Along& end, const Along& cone, bool clear, bool is_sent, NeedleEvidence& evidence) {
  bool use_end = end.valid, use_cone = cone.valid;
  now_.is_disputed = false;
  if (use_end && use_cone) {
    // Where the two contradict each other: in the clear the end is right; under a membrane the cone, unless the end is
    // where the needle was due and the cone isn't.
    const double apart = end.ahead - cone.ahead;
    const double not_due_sigmas = is_sent ? 2.0 : 3.0;  // where it was sent is surer than where it went on to
    const bool is_end_due =
        end.ahead * end.ahead < covariance_(0, 0) + end.variance &&
        cone.ahead * cone.ahead > not_due_sigmas * not_due_sigmas * (covariance_(0, 0) + cone.variance);
    const bool contradict = apart * apart > 9.0 * (end.variance + cone.variance);
    now_.is_disputed = !clear && contradict && std::abs(apart) > kDisputed_px;
    if (contradict) (clear || is_end_due ? use_cone : use_end) = false;
  }
  double information = 0.0, sum = 0.0;
  if (use_end) {
    information += 1.0 / end.variance;
    sum += end.ahead / end.variance;
  }
  if (use_cone) {
    information += 1.0 / cone.variance;
    sum += cone.ahead / cone.variance;
  }
  if (!(information > 0.0)) return false;
  const double ahead = sum / information, variance = 1.0 / information;
  // A start or a stop that the prediction did not know must not be smeared: it is believed as soon as it is seen.
  const double surprise = ahead * ahead / (covariance_(0, 0) + variance);
  if (surprise > 6.0) covariance_.array() += ahead * ahead;
  unrest_ = std::sqrt(0.7 * unrest_ * unrest_ + 0.3 * std::max(0.0, ahead * ahead - variance));
  update(ahead, variance);
  evidence = kShaftEdges | (use_end ? kTipEnd : kNoNeedleEvidence) | (use_cone ? kKnownCone : kNoNeedleEvidence);
  return true;
}

void NeedleTracker::update(double ahead, double variance) {
  const Eigen::Vector2d gain = covariance_.col(0) / (covariance_(0, 0) + variance);
  const double innovation = ahead - ahead_;
  ahead_ += gain[0] * innovation;
  speed_ += gain[1] * innovation;
  covariance_ -= gain * covariance_.row(0).eval();
  covariance_ = 0.5 * (covariance_ + covariance_.transpose().eval());
}

// The caller prepares shaft and end anew.
void NeedleTracker::learn(double end_ahead) {
  frames_since_learning_ = 0;
  const bool first_clear = model_.frames > 0 && !clear_seen_;
  model_.frames = first_clear ? 2 : std::min(model_.frames + 1, kLearnFrames);
  clear_seen_ = clear_seen_ || first_clear;
  shaft_.learn(model_, end_ahead, 1.0 / model_.frames);
  if (model_.frames == 1) {
    axis_.tip += end_ahead * axis_.direction;
  } else {
    anchor_sigma_ = model_.unit_px * std::hypot(kEndFloor, kClearAnchor / std::sqrt(double(model_.frames)));
  }
}

void NeedleTracker::fill(double noise, const ShaftResult& shaft) {
  now_.tip = tip();
  now_.direction = axis_.direction;
  now_.tip_half_width = model_.cone.tip_radius();
  take_width();
  const double far = std::min(60.0 * model_.unit_px, shaft_.behind_px());
  now_.widening = std::max(0.0, (model_.cone.half_width(far) - now_.tip_half_width) / far);
  now_.edge_blur = shaft_.blur_px();
  now_.tip_sigma = std::sqrt(covariance_(0, 0));
  // The cone alone: its own place on the needle may be wrong by the same in every frame.
  if (!(now_.evidence & kTipEnd)) now_.tip_sigma = std::max(now_.tip_sigma, anchor_sigma_);
  const double contrast = shaft.gain * shaft.medium * std::abs(model_.look.depth());
  const double clear = std::clamp(contrast / (5.0 * std::max(noise, 1e-6)), 0.0, 1.0);
  clarity_ = clear * std::clamp(shaft.support / 0.7, 0.0, 1.0);
  now_.confidence = confidence();
}

bool NeedleTracker::is_clear() const noexcept {
  return now_.confidence >= std::min(kClear, kKept_ratio * usual_confidence_);
}

// With the last frame's.
void NeedleTracker::learn_confidence() {
  if (usual_confidence_ == 0.0) usual_confidence_ = now_.confidence;
  usual_confidence_ += kUsualPace * (now_.confidence - usual_confidence_);
}

double NeedleTracker::confidence() const {
  return clarity_ / (1.0 + std::pow(now_.tip_sigma / (3.0 * model_.unit_px), 2));
}

}  // namespace pellucida
