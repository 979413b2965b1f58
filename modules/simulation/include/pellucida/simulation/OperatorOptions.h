#pragma once

namespace pellucida {

/// The step of a simulated operator's time, s.
inline constexpr double kOperatorStep_s = 1e-3;

/// What the operator sees and feels.
enum class Modality {
  kFlatImage,        ///< the microscope's image: depth only from blur
  kSpace,            ///< a view in three dimensions beside it
  kSpaceAndHaptics,  ///< and the force on the hand
  kSpaceAndFixture   ///< and a rectilinear guide, which the hand feels as any force
};

/// The numbers of a simulated operator; defaults are those of a practised person. The sources given support their order
/// of magnitude: people differ.
struct OperatorOptions {
  Modality modality = Modality::kSpace;
  double visual_delay_s = 0.20;  ///< Keele and Posner, J. Exp. Psychol. 77 (1968): 190 to 260 ms
  double haptic_delay_s = 0.12;  ///< Chernikoff and Taylor, J. Exp. Psychol. 43 (1952): 112 to 129 ms
  double tremor_rms_m = 100e-6;  ///< 50e-6..200e-6, length of the vector; Elble, Handb. Clin. Neurophysiol. 1 (2003)
  double tremor_Hz = 10.0;       ///< 8..12
  /// Standard deviation of a position as seen, um at the specimen: in the image plane, and along its depth with a flat
  /// image and with a view in three dimensions.
  double lateral_noise_um = 1.0, flat_depth_noise_um = 8.0, space_depth_noise_um = 2.5;
  double noise_memory = 0.6;        ///< 0..1: share of a visual error that persists at the next glance
  double motor_noise_ratio = 0.05;  ///< of a submovement's length; Meyer et al., Psychol. Rev. 95 (1988)
  double look_interval_s = 0.25;    ///< between two decisions
  double tolerance_um = 3.0;        ///< seen error at which a point counts as reached; visual noise is added
  double fitts_offset_s = 0.15, fitts_slope_s = 0.12;  ///< time of an aimed move: offset + slope log2(1 + A / 3 um)
  double drop_ratio = 0.5;    ///< a felt force below this share of its peak means that the membrane gave way
  double just_felt_N = 0.05;  ///< smallest peak that is felt
  /// A felt resistance F lowers the planned speed of insertion to v / (1 + F / slowing_N); 0: it does not. People push
  /// more slowly and softly when they feel the resistance, as observed by Ammi and others in cell injection (section IV
  /// of the paper this project follows) and Wagner and others, Presence 16 (2007), in dissection; the amount is
  /// assumed.
  double slowing_N = 0.4;
};

}  // namespace pellucida
