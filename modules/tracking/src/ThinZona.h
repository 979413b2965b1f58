#pragma once
#include <Eigen/Core>

#include "EdgeProfile.h"
#include "FrameSampler.h"

namespace pellucida {

struct NeedleZone;

/// What the mean profile across a resting outline says of a zona too thin for its inner edge to be followed: all round
/// a cell it shows lines that no single normal does. px.
struct ThinZona {
  double thickness_px = 0.0;  ///< from the outer line's centre to the inner one's; 0: no second line shows
  double sigma_px = 0.0;      ///< standard deviation of the thickness
  /// A second line like the first would show from this distance on; 0: the profile is too poor to say.
  double limit_px = 0.0;

  /// Reads one frame. `outline`: 2 x n, closed, positive area, on a membrane at rest; `kind`: of its edge, a line's;
  /// `line_width_px`: its standard deviation; `needle` may be null. All 0 for an edge that is no line.
  static ThinZona read(const FrameSampler& image, const Eigen::Matrix2Xd& outline, EdgeKind kind, double line_width_px,
                       const NeedleZone* needle);
};

/// The same over the first frames of a cell at rest.
class ThinZonaMean {
 public:
  /// Further frames would change little.
  bool is_full() const noexcept { return frames_ >= kFrames; }
  void add(const ThinZona& seen);
  /// With a thickness where most frames show one, else with a limit.
  ThinZona mean() const;

 private:
  static constexpr int kFrames = 8;
  ThinZona sum_;
  int frames_ = 0, shown_ = 0, judged_ = 0;
};

}  // namespace pellucida
