#pragma once
#include <filesystem>
#include <fstream>
#include <vector>

#include "pellucida/core/Observation.h"
#include "pellucida/simulation/Scenario.h"
#include "pellucida/simulation/StageMotion.h"
#include "pellucida/simulation/VirtualSpecimen.h"

namespace pellucida {

/// The truth of a frame. `observation` holds everything a tracker may measure, with confidence 1:
/// - contours: the centre lines of the dark edges, 400 points each, the same material points in every frame, denser
///   under the tip (positive signed area in (x, y));
/// - `center_um`: rest centre, moved with the stage; `rotation_rad`: the stage's since the first frame; `axis`: towards
///   the needle; `indentation_um`: the outer apex's way from rest;
/// - `needle.outline_um`: tip first, then one side, then the other back to the tip's rear; the holder's outline
/// likewise.
struct Truth {
  Observation observation;
  double contact_force_uN = 0.0;  ///< of the needle on the cell, along its push; 0 when free or punctured
  double lateral_force_uN = 0.0;  ///< across it, in the image plane, positive along the specimen's `across`
  double pressure_Pa = 0.0;       ///< excess pressure inside
  double volume_um3 = 0.0;        ///< inside the outer membrane's section, revolved (see revolved_volume_um3)
  PlainVector3 tip_um;            ///< the needle's tip, frame W; z into the scene
  double tip_depth_um = 0.0;      ///< its distance past the resting membrane along the push; below 0 outside
  bool in_range = true;           ///< the tip is within the finite-element tables
  std::vector<Droplet> droplets;  ///< what the needle left in the cell, places in frame W
  double deposited_pL = 0.0;      ///< all of it
};

/// Transforms a specimen's state and the tools into the image frame. `stage` moves all of it. Where `cell.in_view` is
/// false the observation has tools alone, and no force.
Truth make_truth(const Scenario& scenario, const VirtualSpecimen& specimen, const SpecimenState& state,
                 const StagePose& stage, double time_s, long frame_index);

/// The scenario with the needle as wide as the finite elements have it, where its own `tools.needle_tip_radius_um` is
/// 0; its shaft is then at least a fifth wider. Throws as load_reference_geometry.
Scenario with_tools_drawn(const Scenario& scenario);

/// The needle's half-width `back_um` behind its tip (>= 0): a round tip, then a cone that eases into the shaft.
double needle_half_width_um(const Scenario::Tools& tools, double back_um) noexcept;

/// The holding pipette's rim: a torus of glass about the axis through the cell's centre, touching the resting membrane.
struct HolderRim {
  double ring_radius_um = 0.0;  ///< from the axis to the middle of the wall
  double distance_um = 0.0;     ///< from the cell's centre to the rim's middle, along the axis
  double wall_radius_um = 0.0;  ///< half the wall's thickness; the rim is rounded with it
};
HolderRim holder_rim(const VirtualSpecimen& specimen) noexcept;

/// Writes truth as two CSV files, frame by frame, flushed with each frame. `t.csv`:
/// `frame,time_s,state,cell_x_um,cell_y_um,axis_deg,tip_x_um,tip_y_um,indentation_um,dimple_radius_um,contact_force_uN,
/// pressure_Pa,volume_um3,rotation_deg,lateral_force_uN,deposited_pL`, all numbers: state 0 no_cell, 1 free, 2 contact,
/// 3 punctured, 4 lost; and beside it `t_contours.csv`: `frame,membrane,point,x_um,y_um` with membrane 0 outer, 1
/// inner, 2 oolemma (when the gap is seen), as `pellucida export` writes `contours.csv`.
class TruthWriter {
 public:
  /// Throws OutputError when one of the files can't be written, also later.
  explicit TruthWriter(const std::filesystem::path& file);
  void write(const Truth& truth);
  /// The second file's path for a first one: `t.csv` -> `t_contours.csv`.
  static std::filesystem::path contour_file(const std::filesystem::path& file);

 private:
  void check(const std::ofstream& stream, const std::filesystem::path& file) const;

  std::filesystem::path file_;
  std::ofstream rows_, contours_;
};

}  // namespace pellucida
