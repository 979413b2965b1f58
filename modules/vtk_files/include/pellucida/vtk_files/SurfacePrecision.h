#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace pellucida {

/// How finely a session holds a surface. A surface is derived: contours and tools, from which it can be had again, are
/// kept to the bit.
namespace surface_precision {
/// Points and displacements are multiples of this: off by 2 nm at most, where a contour's standard deviation is 20 nm
/// at best.
inline constexpr double kPlaceStep_um = 1.0 / 256.0;
/// Components of `rest_direction` are multiples of this: 3 nm at a radius of 50 um.
inline constexpr double kDirectionStep = 1.0 / 8192.0;
/// Components of the force on a node are multiples of a power of two, at most this share of the force's standard
/// deviation at the node.
inline constexpr double kForceStepShare = 1.0 / 32.0;
/// Tension, area strain and `force_sigma_uN` have so many binary digits: off by 0.1 % at most.
inline constexpr int kRelativeBits = 10;
}  // namespace surface_precision

/// `surface` as a session holds it: the arrays named above as Float32, rounded as above; all else shared with it. A
/// force without a standard deviation is rounded to Float32 alone. Twice narrowed is once narrowed, to the bit. Not
/// finite numbers stay what they are. `surface` isn't changed.
vtkSmartPointer<vtkPolyData> narrowed_surface(vtkPolyData* surface);

/// The same for what the mechanics adds (forces, their standard deviation, tension, area strain) alone, in place:
/// arrays of these names are replaced, none is changed.
void narrow_forces(vtkPolyData* surface);

}  // namespace pellucida
