#pragma once
#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "pellucida/mechanics/ExpectedPuncture.h"
#include "pellucida/mechanics/ForceCrossCheck.h"
#include "pellucida/mechanics/ForceInterval.h"
#include "pellucida/mechanics/Puncture.h"
#include "pellucida/mechanics/ShapeAudit.h"

namespace pellucida {

/// Reasons to distrust a force; one or more of these, combined with |.
enum ForceWarning : unsigned {
  kNoForceWarning = 0,
  kShapeMismatch = 1,    ///< the contour is not the model's: wrong configuration, a tool elsewhere, a wrinkled cell
  kNeedleSlip = 2,       ///< the needle has left its line since the contact began, or the membrane does not follow it
  kNotOfRevolution = 4,  ///< left and right of the contour differ by more than the model explains
  kSeldomBorne = 8       ///< few cells of the profile bear such a force: this may be a cell of another kind
};
/// "mismatch", "slip", "asymmetry", "profile", joined by "+"; empty for none.
std::string to_string(ForceWarning warnings);
/// The same for a person, one line; empty for none. `profile_name` is that of the profile in use.
std::string describe(ForceWarning warnings, std::string_view profile_name);

/// What the contours of a contact said of sizes that the picture at rest leaves open, and of how the wall stiffens.
struct SizesByContour {
  int contour_count = 0;  ///< contours, at depths 0.08 outer radii apart
  /// Of zona, needle and holding pipette (outer), with the standard deviations of their logarithms; those that the
  /// picture shows are its own.
  double thickness_um = 0.0, tip_radius_um = 0.0, holder_radius_um = 0.0;
  double thickness_sigma = 0.0, tip_radius_sigma = 0.0, holder_radius_sigma = 0.0;
  bool sizes_changed = false;  ///< the picture left one of them open
  /// `stiffening_effect` of the wall's law, 0 or more, with its standard deviation.
  double stiffening_effect = 0.0, stiffening_effect_sigma = 0.0;
  double force_ratio = 1.0;  ///< in use, on the force by the picture's sizes: follows these over some frames
};

/// The model's result for one frame. Numbers that could not be measured are NaN; the arrays are empty when there is no
/// model shape (no cell seen). No other number is ever NaN.
struct ForceEstimate {
  static constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

  /// Force of the needle on the cell along the push, uN: 0 when free or punctured. This is the force of a
  /// force-indentation curve; a needle beside the holder's axis feels a lateral reaction besides, see `tip_force_uN`.
  double contact_force_uN = kNotMeasured;
  double contact_force_lower_uN = kNotMeasured;  ///< 95 % interval, see `interval_95`; what it is made of: `errors`
  double contact_force_upper_uN = kNotMeasured;
  /// Its two parts: what the picture leaves open (forces of one cell compared with each other), and what the scale does
  /// (forces compared with those of other cells and instruments).
  ForceInterval by_picture{kNotMeasured, kNotMeasured, kNotMeasured};
  ForceInterval by_scale{kNotMeasured, kNotMeasured, kNotMeasured};
  double lateral_force_uN = kNotMeasured;  ///< magnitude of the force of the needle on the cell across the push, solved
                                           ///< for; 0 when free or punctured
  Eigen::Vector3d tip_force_uN = Eigen::Vector3d::Zero();  ///< whole force of the needle on the cell, frame W
  double pressure_Pa = kNotMeasured;                       ///< excess pressure in the cell
  double volume_um3 = kNotMeasured;  ///< enclosed by the zona's outer surface, as the model has it
  /// Tangent stiffness and damping along the push, as felt by a hand that moves the needle. If the profile has
  /// relaxation arms these are their spring and damper at `ForceOptions::hand_frequency_Hz`, see
  /// `Relaxation::storage_ratio`, beside the model's own dampers.
  double stiffness_uN_per_um = kNotMeasured;
  double damping_uN_s_per_um = kNotMeasured;
  /// With relaxation arms: how fast the force falls while the needle rests (negative while it does), and what remains
  /// of it in the end. Without: 0 and the force.
  double force_rate_uN_per_s = kNotMeasured;
  double relaxed_force_uN = kNotMeasured;
  double depth_um = kNotMeasured;        ///< filtered indentation
  double depth_sigma_um = kNotMeasured;  ///< its standard deviation, edge bias included

  double time_s = 0.0;              ///< of the frame this was seen in
  long frame_index = 0;             ///< likewise
  ForceErrors errors;               ///< the parts of the interval
  ShapeAudit shape;                 ///< the contour against the model
  double asymmetry_force_uN = 0.0;  ///< force error that the unexplained asymmetry may cause
  ForceWarning warnings = kNoForceWarning;
  bool punctured = false;            ///< the membrane has left the tip: the force is 0
  bool puncture_doubted = false;     ///< it may have, or the frame is misread: measured as a contact, less certain
  bool flanks_pushed = false;        ///< the dimple beside the tip is as deep as ever: a contact, whatever was tracked
  bool puncture_revoked = false;     ///< in one frame: the puncture reported last was none, the contact goes on
  std::optional<Puncture> puncture;  ///< in the first frame that shows it
  double work_uN_um = 0.0;           ///< of the needle on the cell in this contact
  /// Of this cell under this needle, as they are seen; 0 where no cell is measured.
  ExpectedPuncture expected_puncture;
  std::optional<SizesByContour> sizes_by_contour;  ///< where they say anything
  ForceCrossCheck opinions;                        ///< the force according to other models
  double puncture_probability = kNotMeasured;      ///< of this force; only after a palpation
  double naive_force_uN = kNotMeasured;            ///< the biased read-out, where asked for

  bool converged = false;          ///< the model is in equilibrium at `depth_um`
  int iterations = 0;              ///< Newton iterations spent
  std::string reason;              ///< one line when not converged or not measured; empty otherwise
  bool holder_assumed = false;     ///< no holder seen so far: taken to lie opposite the needle
  bool thickness_assumed = false;  ///< the inner membrane was not seen at rest: thickness as likely for the kind

  /// The state after the verdict on a puncture; `tracked` is the observation's.
  CellState judged_state(CellState tracked) const noexcept {
    if (punctured) return CellState::kPunctured;
    return puncture_doubted || flanks_pushed ? CellState::kContact : tracked;
  }

  /// The cell frame C in W: z towards the needle, y along W's z, origin at the cell's centre.
  Eigen::Matrix3d rotation_WC = Eigen::Matrix3d::Identity();
  Eigen::Vector3d center_um = Eigen::Vector3d::Zero();
  Eigen::Matrix3Xd rest_um;    ///< (3 x n) nodes at rest, frame W: the middle surface of the zona
  Eigen::Matrix3Xd solved_um;  ///< (3 x n) nodes in equilibrium, frame W
  Eigen::Matrix3Xi triangles;  ///< (3 x m), outward

  /// (3 x n) uN, frame W: resultant of the membrane's own elastic forces on each node, i.e. of the springs of eq. (1)
  /// and the hinges. In equilibrium it balances what acts on the node from outside: the pressure everywhere, the needle
  /// under the tip, the holder on its ring. Summed over the nodes under the tip it points at the needle, with the
  /// contact force less the pressure's part; single nodes there differ, since the bonded tip bears on the rim of its
  /// patch and pulls at its middle. All nodes together sum to zero, since the outer forces do.
  Eigen::Matrix3Xd force_uN;
  Eigen::VectorXd force_sigma_uN;  ///< (n) standard deviation of its magnitude
  /// (3 x n) uN, frame W: forces of the needle and of the holding pipette on the membrane, 0 on nodes they don't touch.
  /// What balances their sum with `force_uN` is the liquid's pressure. Of a single node they say little: how a tool's
  /// force is spread over its patch depends on the bond; their sums are `tip_force_uN` and its reaction.
  Eigen::Matrix3Xd needle_force_uN, holder_force_uN;
  /// (n) %, the model's: area of the triangles round a node against that at rest, less 1.
  Eigen::VectorXd area_strain_percent;
  Eigen::VectorXd tension_uN_per_um;  ///< (n) mean membrane tension, see SpringTerm
  Eigen::VectorXd
      tension_sigma_uN_per_um;  ///< (n) its standard deviation: the force's, and the model's, see NodalField
};

}  // namespace pellucida
