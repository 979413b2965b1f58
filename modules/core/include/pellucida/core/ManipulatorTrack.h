#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <mutex>
#include <optional>

namespace pellucida {

/// Where a manipulator reported the needle's tip in the last seconds: what is asked for the time of a frame. Any
/// thread; takes a lock for some ten instructions, so it is not for the 1 kHz thread. Allocates nothing.
class ManipulatorTrack {
 public:
  /// A report: its time on the clock that `at` is asked on, s; the tip in frame W, um, and its velocity, um/s. One that
  /// is not finite or not newer than the last is left out.
  void add(double time_s, const Eigen::Vector2d& tip_um, const Eigen::Vector2d& velocity_um_per_s) noexcept;

  /// The tip at `time_s`, on the line between two reports, or up to 50 ms after the newest, by its velocity; rounded to
  /// the nanometre, as a session's row keeps it. Nothing where the nearest reports are more than 0.25 s apart, or
  /// before the first or too long after the newest.
  std::optional<Eigen::Vector2d> at(double time_s) const noexcept;

 private:
  struct Report {
    double time_s;
    Eigen::Vector2d tip_um, velocity_um_per_s;
  };
  static constexpr std::size_t kReports = 256;  // 2.5 s of the fastest manipulator
  const Report& newest(std::size_t back) const noexcept { return reports_[(count_ - 1 - back) % kReports]; }

  mutable std::mutex mutex_;
  std::array<Report, kReports> reports_;
  std::size_t count_ = 0;  // ever added
};

}  // namespace pellucida
