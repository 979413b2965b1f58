#pragma once
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "pellucida/core/ImageView.h"
#include "pellucida/core/Observation.h"

namespace pellucida {

/// Names of the arrays in the session's files (a contract).
namespace array_name {
inline constexpr const char* kTime = "time_s";                   ///< field data, 1 value
inline constexpr const char* kFrameIndex = "frame_index";        ///< field data, 1 value
inline constexpr const char* kSchemaVersion = "schema_version";  ///< field data, 1 value
inline constexpr const char* kMembrane = "membrane";             ///< 0 outer, 1 inner, 2 oolemma
inline constexpr const char* kConfidence = "confidence";         ///< points of a contour, 0..1
inline constexpr const char* kSigma = "sigma_um";                ///< points of a contour
inline constexpr const char* kTool = "tool";                     ///< cells: 0 needle, 1 holder
inline constexpr const char* kEvidence = "evidence";  ///< cells of the tools: NeedleEvidence's bits; 0 for the holder
inline constexpr const char* kTipSigma = "tip_sigma_um";      ///< cells of the tools; 0 for the holder
inline constexpr const char* kForce = "force_uN";             ///< points of the surface, 3 components
inline constexpr const char* kForceSigma = "force_sigma_uN";  ///< points of the surface
inline constexpr const char* kNeedleForce =
    "needle_force_uN";  ///< points of the surface, 3: the needle's on the membrane
inline constexpr const char* kHolderForce = "holder_force_uN";     ///< points of the surface, 3: the holding pipette's
inline constexpr const char* kAreaStrain = "area_strain_percent";  ///< points of the surface
inline constexpr const char* kDisplacement = "displacement_um";    ///< points of the surface, 3 components
inline constexpr const char* kTension = "tension_uN_per_um";       ///< points of the surface
inline constexpr const char* kTensionSigma = "tension_sigma_uN_per_um";  ///< points of the surface
inline constexpr const char* kPath = "path";                  ///< cells of a recording of the hand: 0 hand, 1 tip
inline constexpr const char* kCenter = "center_um";           ///< field data of membranes and surface, 3 values
inline constexpr const char* kAxis = "axis";                  ///< field data, 3 values: unit, cell centre to needle
inline constexpr const char* kRestRadius = "rest_radius_um";  ///< field data, 2 values: outer, inner; 0 = unknown
inline constexpr const char* kRestDirection =
    "rest_direction";  ///< points of the surface, 3: unit, from the cell centre
}  // namespace array_name

/// Stamps field data time_s, frame_index and schema_version.
void stamp(vtkDataObject* data, double time_s, long frame_index);

/// Reads a stamp back; 0 if there is none.
double stamped_time_s(const vtkDataObject* data);
long stamped_frame_index(const vtkDataObject* data);

/// A stamped grey image with spacing in um that owns a copy of `image`'s pixels.
vtkSmartPointer<vtkImageData> make_frame(const ImageView& image, double time_s, long frame_index);

/// The pixels of a frame, as an ImageView; valid while `frame` lives. `frame` has one component, 8 or 16 bit unsigned.
ImageView view_of(const vtkImageData* frame);

/// Contours as vtkPolyData: one closed polyline (first point repeated by index, not by coordinates) a membrane; cell
/// array `membrane` (int); point arrays `confidence` (1 where unknown) and `sigma_um` (0 where unknown), float; field
/// data the stamp, `center_um`, `axis`, `rest_radius_um` and `observation` (ObservationData.h). z = 0.
vtkSmartPointer<vtkPolyData> make_membranes(const Observation& observation);

/// Needle and holder as open polylines; cell arrays `tool` (0 needle, 1 holder), `confidence`, `tip_sigma_um` and
/// `evidence` (how the tip was located: the bits of NeedleEvidence); the needle's first point is its tip. Field data:
/// the stamp, `needle_pose` and `holder_pose` (ObservationData.h).
vtkSmartPointer<vtkPolyData> make_tools(const Observation& observation);

}  // namespace pellucida
