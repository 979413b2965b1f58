#pragma once
#include <optional>
#include <vector>

#include "films/RandomFilm.h"
#include "films/SpecimenTrial.h"
#include "pellucida/core/Observation.h"
#include "tracking/ScenarioRun.h"

#include "pellucida/tracking/TrackerOptions.h"

namespace pellucida::test {

/// The worst frame of a film, to be shown.
struct FilmPicture {
  long frame_index = 0;
  Observation seen, truth;
};

/// Lengths of cell and tools, um: as seen in the last frame before contact, and true; 0: not seen.
struct FilmSizes {
  double radius_um = 0.0, thickness_um = 0.0, tip_radius_um = 0.0, holder_radius_um = 0.0;
  double thickness_sigma_um = 0.0;  ///< as reported; 0: not
};

/// What a frame gave the verdict on a puncture, with the truth; depths past the resting membrane along the needle, um.
struct FrameSight {
  CellState tracked = CellState::kNoCell, judged = CellState::kNoCell, truth = CellState::kNoCell;
  bool is_doubted = false, has_needle = false;
  double confidence = 0.0, needle_confidence = 0.0;
  double tip_um = 0.0, tip_sigma_um = 0.0, membrane_um = 0.0, membrane_sigma_um = 0.0, depth_um = 0.0;
  double pierced_probability = -1.0;
  double true_tip_um = 0.0, true_membrane_um = 0.0;
  double center_ahead_um = 0.0;                ///< the resting centre along the needle, less the true one
  double outer_sigma_um = 0.0;                 ///< usual standard deviation of the outer contour
  double flank_um = 0.0;                       ///< of the dimple, as `flank_depth_um` has it
  double side_um = 0.0, rest_radius_um = 0.0;  ///< how far the sides bulge, 0: not seen; of the resting outline
  double residual_um = 0.0, dimple_residual_um = 0.0, noise_um = 0.0;  ///< of `ShapeAudit`; NaN: not measured
  double force_uN = 0.0, lower_uN = 0.0, upper_uN = 0.0;          ///< by what was seen, with the picture's interval
  double expected_uN = 0.0, true_uN = 0.0;                        ///< by the true contours and tip; the cell's own
  double stiffening_effect = 0.0, stiffening_effect_sigma = 0.0;  ///< by the contours; NaN: not measured
  double sizes_ratio = 1.0;                                       ///< on the force, by what the contours said
};

/// Pictures of one film side by side.
inline constexpr int kSheetColumns = 3, kSheetRows = 3;

/// A random film through the tracker and the force observer.
struct FilmRun {
  RandomFilm film;
  std::vector<FrameError> errors;  ///< a frame each; outer_px, tip_px and the like -1 where nothing was measured
  std::vector<FrameSight> sights;  ///< a frame each
  bool has_cell = false;
  int found_count = 0;                 ///< frames with a contour reported
  int contact_count = 0;               ///< frames truly in contact
  int false_puncture_count = 0;        ///< of these, those reported as punctured
  std::optional<long> puncture_delay;  ///< frames from the puncture to its report; empty: no puncture, or none reported
  bool punctures = false;
  int confident_and_wrong_count = 0;  ///< confidence above 0.8, and: outer > 2 px, tip > 3 px, or no cell there
  double force_rms_percent = -1.0;    ///< of the largest true force; -1: never in contact
  /// Of the largest force that the true observations give: RMS difference of what was seen from that, so the tracker's
  /// share of the error alone; -1: never in contact.
  double tracking_force_rms_percent = -1.0;
  /// Likewise over the frames alone in which the needle pushes and a force is given.
  double pushed_force_rms_percent = -1.0;
  /// The same as `force_rms_percent` of the profile's own thickness, tip and holder on the cell's radius.
  double profile_force_rms_percent = -1.0;
  FilmSizes seen_sizes, true_sizes;
  std::optional<SpecimenResult> specimen;  ///< of a specimen with tables of its own
  /// RMS difference of the force by the true contours from the true one, over frames in contact, % of peak: what is not
  /// the tracker's; -1: never in contact.
  double true_sight_percent = -1.0;
  int measured_count = 0;  ///< frames in contact with a force
  /// Of these, those with the true force in the picture's 95 % interval (the truth has the profile's modulus). Where no
  /// finite elements fit the picture, the force that the true observations give stands for it.
  int covered_count = 0;
  double median_frame_ms = 0.0;
  FilmPicture worst;
  std::vector<FilmPicture> pictures;  ///< of frames spread over the film, `kSheetColumns` times `kSheetRows` at most
  double badness = 0.0;  ///< ranks films: frames confident and wrong first, then false punctures, then errors

  bool is_confident_and_wrong(const FrameError& error) const;
};

/// `is_commanded`: the tracker receives the reports of a `FilmManipulator`.
FilmRun run_film(const RandomFilm& film, const TrackerOptions& options = {}, bool is_commanded = false);

/// The worst frame with the true contours and tip (green) and those found (red), as PNG.
void draw_worst(const FilmRun& run, const std::string& file);
/// The same of `pictures`, side by side.
void draw_sheet(const FilmRun& run, const std::string& file);

}  // namespace pellucida::test
