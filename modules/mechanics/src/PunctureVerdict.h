#pragma once
#include <limits>
#include <optional>

namespace pellucida {

/// A membrane that gave way.
struct Puncture {
  double time_s = 0.0;         ///< of the first frame that shows it
  double peak_force_uN = 0.0;  ///< largest force before
  double depth_um = 0.0;       ///< the deepest indentation before, with the force above
  double work_uN_um = 0.0;     ///< of the needle on the cell since the contact: integral of F dd, 1 uN um = 1e-12 J
};

/// Watches a contact for the moment when the membrane leaves the tip behind. A frame is a puncture when the membrane
/// has come back, against the depth before, by more than `4 sigma` and 2 um while the tip, which pushed it, has not: it
/// is in the cell, more than 4 sigma and 2 um past the membrane. A tracker that keeps the contour on the tip shows no
/// such distance; then the rest of the contour reveals it: from one frame to the next it leaves the model's shape by 1
/// um or more, outwards in the dimple. That state ends when the tip has left the cell, or is on the membrane again for
/// three frames. One thread at a time.
class PunctureMonitor {
 public:
  /// One frame's depths, um past the resting membrane along the needle, and their standard deviations.
  struct Depths {
    double tip_um = 0.0;
    double tip_sigma_um = 0.0;
    double membrane_um = 0.0;
    double membrane_sigma_um = 0.0;
  };

  /// Whether the membrane is through in this frame. Ask before the frame's force is known.
  bool is_through(const Depths& now) noexcept;

  /// Whether the contour's shape shows it in this frame: `residual_um` and `dimple_residual_um` of `ShapeAudit` (NaN:
  /// not seen, no evidence), `usual_um` the usual residual. Ask once per frame in contact, after the model is solved
  /// for it and before `add`.
  bool has_sprung_back(double residual_um, double dimple_residual_um, double usual_um) noexcept;

  /// A frame in contact with its force: work, peak. Not for frames that are through.
  void add(double depth_um, double force_uN) noexcept;

  /// The puncture that has just begun, with its force, depth and work; nothing if it was reported already, or there was
  /// no contact.
  std::optional<Puncture> take_puncture(double time_s) noexcept;

  /// Work of the needle on the cell so far, uN um.
  double work_uN_um() const noexcept { return work_uN_um_; }

  /// The needle has left the cell: a new contact starts from zero.
  void release() noexcept;

 private:
  bool has_contact_ = false;
  bool through_ = false;
  bool told_ = false;
  int together_frames_ = 0;
  double last_residual_um_ = std::numeric_limits<double>::quiet_NaN();
  double last_dimple_um_ = std::numeric_limits<double>::quiet_NaN();
  double last_depth_um_ = 0.0, last_force_uN_ = 0.0;
  double peak_force_uN_ = 0.0, peak_depth_um_ = 0.0, work_uN_um_ = 0.0;
};

}  // namespace pellucida
