#pragma once
#include <limits>
#include <optional>

#include "pellucida/mechanics/Puncture.h"

namespace pellucida {

/// The one place that decides whether the membrane has given way. It weighs, frame by frame of a contact,
/// - the tip and the membrane under it: punctured when the membrane has come back, against the depth before, by more
///   than 4 sigma, 2 um and three tenths of that depth while the tip, which pushed it, has not and is as far past it;
/// - the tracker's state, which rests on a tip far past the membrane alone: believed only where the membrane has come
///   back by 0.35 of its depth of late, the tip staying, or where no contact was followed. A tip that is lost in the
///   cell's texture runs ahead just so while the membrane still follows the needle: such a frame is doubted, it is a
///   contact;
/// - the contour, where a tracker keeps it on the tip: punctured when from one frame to the next it leaves the model's
///   shape by 1 um and more, outwards in the dimple.
/// A puncture ends when the tip has left the cell, or is on the membrane again for three frames. One thread at a time.
class PunctureVerdict {
 public:
  /// What a frame in contact, or tracked as punctured, shows before its force is known. Depths past the resting
  /// membrane along the needle, with their standard deviations, um.
  struct Sight {
    bool is_tracked_punctured = false;  ///< the tracker's state
    bool has_depths = true;             ///< needle and membrane were seen
    double tip_um = 0.0, tip_sigma_um = 0.0;
    double membrane_um = 0.0, membrane_sigma_um = 0.0;
  };

  /// Whether the tip is past the membrane by more than noise and the tip's roundness explain.
  static bool is_apart(const Sight& now) noexcept;

  /// Whether the membrane is through in this frame, by tip, membrane and tracker. First of a frame's calls.
  bool judge(const Sight& now) noexcept;
  /// After that: the tracker says punctured, the membrane does not.
  bool is_doubted() const noexcept { return is_doubted_; }

  /// What the contour shows once the model is solved: `residual_um` and `dimple_residual_um` of `ShapeAudit` (NaN: not
  /// seen, no evidence), `usual_um` what the residual may be.
  struct Shape {
    double residual_um = 0.0, dimple_residual_um = 0.0, usual_um = 0.0;
  };

  /// The same by the contour's shape. Once a frame in contact, before `add`.
  bool judge(const Shape& now) noexcept;

  /// A frame in contact with its force: work, peak. Not for frames that are through.
  void add(double depth_um, double force_uN) noexcept;

  /// The puncture that has just begun, with its force, depth and work; nothing when it was reported already, or there
  /// was no contact.
  std::optional<Puncture> take_puncture(double time_s) noexcept;

  /// Work of the needle on the cell so far, uN um.
  double work_uN_um() const noexcept { return work_uN_um_; }

  /// The needle has left the cell: a new contact starts from zero.
  void release() noexcept;

 private:
  bool is_through_by(const Sight& now, double before_um) const noexcept;
  bool is_confirmed_by(const Sight& now) const noexcept;
  void follow_deepest(const Sight& now) noexcept;

  bool has_contact_ = false;
  bool through_ = false;
  bool is_doubted_ = false;
  bool reported_ = false;
  int together_frames_ = 0;
  double last_residual_um_ = std::numeric_limits<double>::quiet_NaN();
  double last_dimple_um_ = std::numeric_limits<double>::quiet_NaN();
  double deepest_um_ = 0.0, tip_at_deepest_um_ = 0.0;  // of the membrane, of late
  double membrane_um_ = 0.0;                           // in the last frame
  double last_depth_um_ = 0.0, last_force_uN_ = 0.0;
  double peak_force_uN_ = 0.0, peak_depth_um_ = 0.0, work_uN_um_ = 0.0;
};

}  // namespace pellucida
