#include "presenters/Playback.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

// A seek to a step's own time finds that step.
constexpr double kSlack_s = 1e-9;

}  // namespace

Playback::Playback(std::vector<double> times_s) : times_s_(std::move(times_s)) {
  if (!times_s_.empty()) position_s_ = anchor_position_s_ = times_s_.front();
}

void Playback::place(double position_s, double now_s) {
  position_s_ = std::clamp(position_s, times_s_.front(), times_s_.back());
  anchor_position_s_ = position_s_;
  anchor_now_s_ = now_s;
  const auto later = std::upper_bound(times_s_.begin(), times_s_.end(), position_s_ + kSlack_s);
  step_ = static_cast<std::size_t>(std::max<std::ptrdiff_t>(later - times_s_.begin() - 1, 0));
}

void Playback::play(bool on, double now_s) {
  if (times_s_.empty()) return;
  playing_ = on && times_s_.size() > 1;
  const bool at_end = backwards_ ? position_s_ <= times_s_.front() : position_s_ >= times_s_.back();
  place(playing_ && at_end ? (backwards_ ? times_s_.back() : times_s_.front()) : position_s_, now_s);
}

void Playback::set_speed_ratio(double ratio, double now_s) {
  tick(now_s);
  speed_ratio_ = std::clamp(ratio, kLeastSpeed_ratio, kMostSpeed_ratio);
  if (!times_s_.empty()) place(position_s_, now_s);
}

void Playback::set_backwards(bool on, double now_s) {
  tick(now_s);
  backwards_ = on;
  if (!times_s_.empty()) place(position_s_, now_s);
}

void Playback::go_to(std::size_t step, double now_s) {
  if (times_s_.empty()) return;
  step = std::min(step, times_s_.size() - 1);
  place(times_s_[step], now_s);
  // Several steps may share a time.
  step_ = step;
}

void Playback::go_to_time(double time_s, double now_s) {
  if (!times_s_.empty()) place(time_s, now_s);
}

void Playback::step_by(long count) {
  if (times_s_.empty()) return;
  playing_ = false;
  const long last = static_cast<long>(times_s_.size()) - 1;
  go_to(static_cast<std::size_t>(std::clamp(static_cast<long>(step_) + count, 0L, last)), anchor_now_s_);
}

bool Playback::tick(double now_s) {
  if (!playing_) return false;
  const std::size_t before = step_;
  const double begin_s = times_s_.front(), end_s = times_s_.back(), length_s = end_s - begin_s;
  const double way_s = speed_ratio_ * std::max(now_s - anchor_now_s_, 0.0);
  double position_s = anchor_position_s_ + (backwards_ ? -way_s : way_s);
  const bool over = backwards_ ? position_s <= begin_s : position_s >= end_s;
  if (over && loop_ && length_s > 0.0) {
    // The rest of the way counts from the other end.
    const double rest_s = std::fmod(backwards_ ? begin_s - position_s : position_s - end_s, length_s);
    place(backwards_ ? end_s - rest_s : begin_s + rest_s, now_s);
  } else if (over) {
    playing_ = false;
    place(position_s, now_s);
  } else {
    // The anchor remains: rounding doesn't add up.
    const double anchor_now_s = anchor_now_s_, anchor_position_s = anchor_position_s_;
    place(position_s, now_s);
    anchor_now_s_ = anchor_now_s;
    anchor_position_s_ = anchor_position_s;
  }
  return step_ != before;
}

}  // namespace pellucida
