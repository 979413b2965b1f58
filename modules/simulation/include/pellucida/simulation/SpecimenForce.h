#pragma once
#include <array>
#include <string_view>
#include <type_traits>

#include "pellucida/core/PlainVector.h"

namespace pellucida {

/// Response of the intact membrane to a tip at one position. Frame W, um, uN.
struct SpecimenReply {
  PlainVector3 force_uN;             ///< of the cell on the needle
  double axial_force_uN = 0.0;       ///< its part against the push, >= 0
  double lateral_force_uN = 0.0;     ///< the needle's on the cell across the push, in the plane, towards `across`
  double depth_um = 0.0;             ///< the tip's distance past the resting membrane along the push; below 0 outside
  double offset_um = 0.0;            ///< of the tip from the cell's centre, towards `across`
  double out_of_plane_um = 0.0;      ///< of the tip from the image plane, into the scene
  double indentation_um = 0.0;       ///< the membrane's: the part of the depth it follows
  double energy_uN_um = 0.0;         ///< stored in the cell
  double stiffness_uN_per_um = 0.0;  ///< of the axial force along the push
  bool in_range = true;              ///< the position lies within the finite-element tables
};
static_assert(std::is_trivially_copyable_v<SpecimenReply>);

/// The specimen's force as a function of the tip's position, for a 1 kHz thread: a lookup of some hundred nanoseconds,
/// trivially copyable, without memory, allocation or exception. Tables of finite elements by depth and by the needle's
/// offset from the cell's centre (-20 to 20 um) are joined to an energy
///
///     U(s, d),  d = sqrt(R^2 - s^2 - t^2) - z,   force on the needle = -grad U
///
/// with s, t the tip's places across in and out of the plane and z along the needle: cubic Hermite in d as the tables
/// of CellReference, cubic in s between the offsets. Being a gradient it generates no energy on a closed path: the tip
/// glides over the membrane without friction. (The tables' own lateral force is that of a tip that sticks.)
/// Past the deepest table the force continues with its last slope; past an offset of 20 um the energy fades to 0 at 45
/// um, as if the needle slipped off: only there `in_range` is false. The needle comes from its own side: a tip behind
/// the cell has pushed it all the way. A holder opposite the needle makes the field a surface of revolution; in
/// configurations 2 and 3 the tables hold for the image plane, and t only moves the membrane away.
class SpecimenForce {
 public:
  /// No cell: no force anywhere.
  SpecimenForce() = default;

  /// Where the cell lies and how it is turned.
  struct Frame {
    PlainVector3 center_um;  ///< frame W
    PlainVector3 axis;       ///< unit, from the cell's centre to the needle
    PlainVector3 across;     ///< unit, at right angles to it in the image plane
    double size_scale = 1.0;
    double stiffness_ratio = 1.0;  ///< factor on all forces
  };
  /// Reads the tables of a cell in a configuration. Without a table of offsets, as of specimens that were computed on
  /// their axis only, the centre's curve counts beside it too, and a tip 1 um off is out of range. Throws as
  /// CellReference::load.
  static SpecimenForce load(std::string_view cell, int configuration, const Frame& frame);

  /// The intact membrane's response. Any thread, real-time safe.
  SpecimenReply at(const PlainVector3& tip_um) const noexcept;

  /// A position given as (offset, depth) in the image plane, frame W: the tip `depth_um` past the resting membrane.
  PlainVector3 tip_at(double offset_um, double depth_um) const noexcept;
  /// Largest offset within the tables, um.
  double max_offset_um() const noexcept { return frame_.size_scale * max_offset_um_; }
  double max_indentation_um() const noexcept { return frame_.size_scale * max_depth_um_; }
  const Frame& frame() const noexcept { return frame_; }
  /// The same cell elsewhere, without reading its tables again.
  SpecimenForce moved_to(const Frame& frame) const noexcept {
    SpecimenForce moved = *this;
    moved.frame_ = frame;
    return moved;
  }

 private:
  static constexpr double kMaxOffset_um = 20.0, kOnAxis_um = 1.0, kGone_um = 45.0, kOffsetStep_um = 10.0;
  static constexpr int kMaxKnots = 64, kCurves = 5;

  // Force by depth at one offset, as a monotone cubic, and its integral at the knots.
  struct Curve {
    int count = 0;
    std::array<double, kMaxKnots> depth_um{}, force_uN{}, slope{}, energy{};
  };
  struct Value {
    double energy, force, slope;
  };
  static Value value_of(const Curve& curve, double depth_um) noexcept;

  Frame frame_;
  double radius_um_ = 52.5, max_depth_um_ = 0.0, max_offset_um_ = kMaxOffset_um;
  bool symmetric_ = true;                // about the needle's axis
  std::array<Curve, kCurves> curves_{};  // at -20, -10, 0, 10, 20 um
};
static_assert(std::is_trivially_copyable_v<SpecimenForce>);

}  // namespace pellucida
