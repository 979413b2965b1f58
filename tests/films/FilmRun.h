#pragma once
#include <optional>
#include <vector>

#include "films/RandomFilm.h"
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
};

/// A random film through the tracker and the force observer.
struct FilmRun {
  RandomFilm film;
  std::vector<FrameError> errors;  ///< a frame each; outer_px, tip_px and the like -1 where nothing was measured
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
  /// The same as `force_rms_percent` of the profile's own thickness, tip and holder on the cell's radius.
  double profile_force_rms_percent = -1.0;
  FilmSizes seen_sizes, true_sizes;
  int covered_count = 0;  ///< frames in contact with the true force in the 95 % interval
  double median_frame_ms = 0.0;
  FilmPicture worst;
  double badness = 0.0;  ///< ranks films: frames confident and wrong first, then false punctures, then errors

  bool is_confident_and_wrong(const FrameError& error) const;
};

FilmRun run_film(const RandomFilm& film, const TrackerOptions& options = {});

/// The worst frame with the true contours and tip (green) and those found (red), as PNG.
void draw_worst(const FilmRun& run, const std::string& file);

}  // namespace pellucida::test
