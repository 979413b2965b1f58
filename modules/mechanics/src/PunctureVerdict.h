#pragma once
#include <limits>
#include <optional>

#include "PunctureOdds.h"
#include "PushedShape.h"
#include "pellucida/mechanics/Puncture.h"

namespace pellucida {

/// The one place that decides whether the membrane has given way: by a sequential test (`PunctureOdds`) of tip and
/// membrane over the frames of a contact, each as strong as that frame was seen.
/// - Evidence of a puncture: against its depth of late the membrane has come back while the tip, which pushed it, has
///   not and lies beyond it by more than noise explains; or the contour, where a tracker keeps it on the tip, leaves
///   the model's shape from one frame to the next by 1 um and more, outwards in the dimple.
/// - Against it, or for it, wherever the contour under the tip is: the shape of the rest of the cell (`PushedShape`).
///   The sides of a cell that is pushed bulge; once it isn't, they are back.
/// - The tracker's own state rests on a tip far past the membrane alone. A tip that is lost in the cell's texture runs
///   ahead just so while the membrane still follows the needle: that state is believed only where no contact was
///   followed. Until the test is sure such a frame, or one that may be misread, is a contact in doubt.
/// A puncture ends when the tip has left the cell. Should tip and membrane be together again for three frames, deep in
/// the cell, it is revoked: there was none. One thread at a time.
class PunctureVerdict {
 public:
  PunctureVerdict() noexcept;

  /// What a frame in contact, or tracked as punctured, shows before its force is known. Depths past the resting
  /// membrane along the needle, with their standard deviations, um.
  struct Sight {
    bool is_tracked_punctured = false;  ///< the tracker's state
    bool has_depths = true;             ///< needle and membrane were seen
    double tip_um = 0.0, tip_sigma_um = 0.0;
    double membrane_um = 0.0, membrane_sigma_um = 0.0;
    double confidence = 1.0;  ///< of membrane and tip, the lower one, 0..1
    /// How deep the dimple's flanks lie within the resting outline (`flank_depth_um`); NaN: not seen.
    double flank_um = std::numeric_limits<double>::quiet_NaN();
    /// How far the cell's sides bulge (`Observation::side_bulge_um`); NaN: not seen.
    double side_um = std::numeric_limits<double>::quiet_NaN();
    /// By the picture about the tip (`Observation::pierced_probability`); NaN: not read.
    double pierced_probability = std::numeric_limits<double>::quiet_NaN();
    double shape_sigma_um =
        0.0;  ///< standard deviation of both, by what the contour says of itself; 0: it says nothing
    double rest_radius_um = 0.0;  ///< of the outline that all depths are taken from
  };

  /// Whether the tip is past the membrane by more than noise and the tip's roundness explain.
  static bool is_apart(const Sight& now) noexcept;
  /// Whether the membrane seems to lie beyond the tip by more than noise explains: one of them is elsewhere.
  static bool lies_beyond_tip(const Sight& now) noexcept;

  /// A frame in which nothing touches the cell: how much its flanks and sides seem to move by themselves.
  void watch(const Sight& untouched) noexcept;

  /// Whether the membrane is through in this frame, by tip, membrane and tracker. First of a frame's calls.
  bool judge(const Sight& now) noexcept;
  /// After that: the tracker says punctured, or the frame may be misread, and the test isn't sure.
  bool is_doubted() const noexcept { return is_doubted_; }
  /// After that: what was taken for a puncture was none; the contact goes on.
  bool is_revoked() const noexcept { return is_revoked_; }
  /// After that: the cell's shape beside the tip is seen and as pushed as ever, so that the membrane lies on the tip.
  bool is_pushed() const noexcept { return is_pushed_; }

  /// Where the dimple's flanks say that the membrane is in this frame, um past rest; infinity where they say nothing.
  double depth_by_flanks_um() const noexcept { return depth_by_flanks_um_; }
  /// That was last added to this contact; 0 before.
  double last_depth_um() const noexcept { return last_depth_um_; }

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
  bool may_end(const Sight& now) noexcept;
  bool is_pushed_again(const Sight& now) noexcept;
  PunctureOdds::Evidence evidence_of(const Sight& now, const PushedShape::Share& flank,
                                     const PushedShape::Share& side) const noexcept;
  void forget_deepest() noexcept;
  void follow_deepest(const Sight& now) noexcept;

  PunctureOdds odds_;
  bool has_contact_ = false;
  bool through_ = false;
  bool is_doubted_ = false, is_revoked_ = false, is_pushed_ = false;
  bool reported_ = false;
  double confidence_ = 1.0;        // of this frame
  bool is_apart_ = false;          // likewise
  bool are_sides_leaving_ = true;  // likewise, or not seen
  bool turns_back_ = false;        // likewise, of the sides' bulge, while the flanks go deeper
  int together_frames_ = 0;
  double last_residual_um_ = std::numeric_limits<double>::quiet_NaN();
  double last_dimple_um_ = std::numeric_limits<double>::quiet_NaN();
  double rest_radius_um_ = 0.0;
  double depth_by_flanks_um_ = std::numeric_limits<double>::infinity();
  PushedShape flanks_, sides_;
  double deepest_um_ = 0.0, tip_at_deepest_um_ = 0.0;  // of the membrane, of late
  // Since the membrane is through.
  double least_membrane_um_ = std::numeric_limits<double>::infinity();
  double least_flank_um_ = std::numeric_limits<double>::infinity();
  double flank_before_um_ = std::numeric_limits<double>::quiet_NaN();  // in the frame before, whatever it was
  double last_depth_um_ = 0.0, last_force_uN_ = 0.0;
  double peak_force_uN_ = 0.0, peak_depth_um_ = 0.0, work_uN_um_ = 0.0;
};

}  // namespace pellucida
