#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pellucida {

/// Points in the image plane, frame W, one column a point (2 x n), um. A closed contour does not repeat its first
/// point.
using Contour_um = Eigen::Matrix2Xd;

/// State of the cell under the needle in one frame; names are those of `measurements.csv`.
enum class CellState { kNoCell, kFree, kContact, kPunctured, kLost };

/// "no_cell", "free", "contact", "punctured", "lost".
std::string_view to_string(CellState state) noexcept;
/// The inverse of `to_string`; nothing for an unknown name.
std::optional<CellState> cell_state_from_string(std::string_view name) noexcept;

/// Which membrane a contour or a surface node belongs to; the numbers are those of the session's array `membrane`.
enum class Membrane : int { kOuter = 0, kInner = 1, kOolemma = 2 };

/// One membrane's closed contour: the centre line of its dark edge in bright field.
struct MembraneContour {
  Membrane membrane = Membrane::kOuter;
  Contour_um points_um;        ///< (2 x n), ordered round the cell, closed, positive signed area in (x, y)
  Eigen::VectorXd sigma_um;    ///< (n) standard deviation along the normal; empty when not estimated
  Eigen::VectorXd confidence;  ///< (n) in 0..1
};

/// The evidence used to locate the needle's tip; one or more of these, combined with |.
enum NeedleEvidence : unsigned {
  kNoNeedleEvidence = 0,
  kShaftEdges = 1,       ///< both edges of the shaft: the axis
  kTipEnd = 2,           ///< the place where the edges end
  kKnownCone = 4,        ///< the shaft's width, on the cone learnt while the tip was in the clear
  kCommandedMotion = 8,  ///< the motion commanded to the manipulator
  kDimple = 16           ///< the membrane's apex under the tip
};
constexpr NeedleEvidence operator|(NeedleEvidence a, NeedleEvidence b) noexcept {
  return static_cast<NeedleEvidence>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
/// Names in that order, joined by "+": "shaft+tip"; "none".
std::string to_string(NeedleEvidence evidence);

/// The injection needle (micropipette) in the image plane.
struct NeedlePose {
  Eigen::Vector2d tip_um = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction =
      Eigen::Vector2d::UnitX();                 ///< unit vector from the shaft to the tip: the direction of its push
  double tip_radius_um = 0.0;                   ///< half the width at the tip
  double confidence = 0.0;                      ///< 0..1
  double tip_sigma_um = 0.0;                    ///< standard deviation of the tip along `direction`; 0: unknown
  NeedleEvidence evidence = kNoNeedleEvidence;  ///< how the tip was located
  Contour_um outline_um;                        ///< open polyline; its first point is the tip
  double tip_radius_sigma = 0.0;  ///< standard deviation of the tip radius's logarithm; 0: as edges show it
};

/// The holding pipette in the image plane.
struct HolderPose {
  Eigen::Vector2d mouth_um = Eigen::Vector2d::Zero();    ///< centre of the mouth, where the cell rests
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< unit vector from the cell centre to the mouth
  double outer_radius_um = 0.0;                          ///< half its width at the mouth
  double confidence = 0.0;                               ///< 0..1
  Contour_um outline_um;                                 ///< open polyline
  double outer_radius_sigma = 0.0;  ///< standard deviation of its radius's logarithm; 0: as edges show it
};

/// Everything one frame shows of cell and tools: what a tracker measures, and what the virtual microscope knows as
/// truth. Lengths in um in frame W.
struct Observation {
  double time_s = 0.0;  ///< since the session began
  long frame_index = 0;
  CellState state = CellState::kNoCell;
  double confidence = 0.0;  ///< of the whole frame, 0..1
  std::optional<MembraneContour> outer;
  std::optional<MembraneContour> inner;
  std::optional<MembraneContour> oolemma;
  std::optional<NeedlePose> needle;
  std::optional<HolderPose> holder;
  /// Where no cell is shown: the radius of what is one but for its size (`TrackerOptions::expected_radius_um`); 0:
  /// none.
  double refused_radius_um = 0.0;

  // Valid when `outer` is set.
  Eigen::Vector2d center_um = Eigen::Vector2d::Zero();  ///< centre of the outer membrane at rest, moving with the cell
  double rotation_rad = 0.0;          ///< rigid rotation of cell and holder since the cell was found, +x towards +y
  double rest_outer_radius_um = 0.0;  ///< radius of the outer membrane at rest
  double rest_inner_radius_um = 0.0;  ///< of the inner one; 0 when it was not seen at rest
  /// Standard deviation of the distance between the two, where it was not taken from contours that follow lines; else
  /// 0.
  double rest_thickness_sigma_um = 0.0;
  /// Where no inner membrane was seen at rest: from this distance on one would have been; 0: nothing is known.
  double rest_thickness_limit_um = 0.0;

  // Valid when `outer` and `needle` are set.
  Eigen::Vector2d axis = Eigen::Vector2d::UnitX();  ///< unit vector from the cell centre to the needle
  double indentation_um = 0.0;        ///< contact point's displacement along the axis, rigid motion removed; >= 0
  double indentation_sigma_um = 0.0;  ///< its standard deviation; 0 when not estimated
  double dimple_radius_um = 0.0;      ///< radius of the dimple's mouth, across the axis; 0 without contact
  /// How far beyond the circle of `rest_outer_radius_um` the resting outer membrane lies where the needle's line enters
  /// it; 0 where the cell is round.
  double rest_beyond_um = 0.0;
  /// How far the cell bulges beside the push: RMS distance of the outer membrane from its resting place over the sides,
  /// more than 0.85 of its radius off the needle's line through the centre, a shift of the whole taken off; 0 when not
  /// measured.
  double side_bulge_um = 0.0;
  /// 0..1: how likely the needle is through the membrane, by the picture about its tip in this frame alone; below 0
  /// where that was not read.
  double pierced_probability = -1.0;
};

}  // namespace pellucida
