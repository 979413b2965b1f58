#pragma once
#include <cstddef>
#include <vector>

namespace pellucida {

/// Where a session being played is: a position in its time that follows a clock at a chosen speed. Which frame is shown
/// follows from the position alone, so that a slow display leaves frames out and the pace remains. Knows no thread and
/// no clock of its own; `now_s` is any monotonic one.
class Playback {
 public:
  static constexpr double kLeastSpeed_ratio = 0.1;
  static constexpr double kMostSpeed_ratio = 10.0;

  Playback() = default;
  /// `times_s`: of the steps, never falling, at least one.
  explicit Playback(std::vector<double> times_s);

  std::size_t step() const noexcept { return step_; }
  std::size_t step_count() const noexcept { return times_s_.size(); }
  /// Time of the position, between the first step's and the last one's.
  double position_s() const noexcept { return position_s_; }
  bool playing() const noexcept { return playing_; }
  double speed_ratio() const noexcept { return speed_ratio_; }
  bool backwards() const noexcept { return backwards_; }
  bool loop() const noexcept { return loop_; }

  /// Starts or ends playing; at the end of the way it starts again from the other end.
  void play(bool on, double now_s);
  /// 0.1 .. 10 times the session's own speed; what lies outside becomes the nearer end.
  void set_speed_ratio(double ratio, double now_s);
  void set_backwards(bool on, double now_s);
  /// From the end on from the beginning.
  void set_loop(bool on) noexcept { loop_ = on; }

  /// To a step, held within the session. Playing goes on from there.
  void go_to(std::size_t step, double now_s);
  /// To a time, held within the session.
  void go_to_time(double time_s, double now_s);
  /// By so many steps, and playing ends.
  void step_by(long count);

  /// Follows the clock; true when another step is due. At the end of the way playing ends, unless it loops.
  bool tick(double now_s);

 private:
  void place(double position_s, double now_s);

  std::vector<double> times_s_;
  std::size_t step_ = 0;
  double position_s_ = 0.0;
  double anchor_now_s_ = 0.0;       // when the position was last set
  double anchor_position_s_ = 0.0;  // to what
  double speed_ratio_ = 1.0;
  bool playing_ = false;
  bool backwards_ = false;
  bool loop_ = false;
};

}  // namespace pellucida
