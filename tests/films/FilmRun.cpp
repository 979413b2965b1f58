#include "films/FilmRun.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "films/FilmManipulator.h"
#include "films/RelaxingTruth.h"
#include "pellucida/core/NearestOnContour.h"
#include "pellucida/core/NeedleContact.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/mechanics/ForceObserver.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/membrane/Indenter.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pellucida/tracking/MembraneTracker.h"

namespace pellucida::test {
namespace {

// A film whose true contours give no more has no force to speak of.
constexpr double kLeastPeak_uN = 1e-3;

// Errors beside a truth that may lack the cell.
FrameError error_of(const Observation& seen, const Observation& truth, double pixel_size_um) {
  if (truth.outer) return compare(seen, truth, pixel_size_um);
  FrameError error;
  error.state = seen.state;
  error.true_state = truth.state;
  error.confidence = seen.confidence;
  if (seen.needle) error.tip_px = (seen.needle->tip_um - truth.needle->tip_um).norm() / pixel_size_um;
  return error;
}

FrameSight sight_of(const Observation& seen, const Observation& truth, const ForceEstimate& estimate) {
  FrameSight sight;
  sight.tracked = seen.state;
  sight.judged = estimate.judged_state(seen.state);
  sight.truth = truth.state;
  sight.is_doubted = estimate.puncture_doubted;
  sight.confidence = seen.confidence;
  sight.has_needle = seen.outer && seen.needle;
  if (sight.has_needle) {
    sight.needle_confidence = seen.needle->confidence;
    sight.tip_um = needle_contact(seen).tip_depth_um;
    sight.tip_sigma_um = seen.needle->tip_sigma_um;
    sight.flank_um = flank_depth_um(seen, needle_contact(seen));
    sight.side_um = seen.side_bulge_um;
    sight.pierced_probability = seen.pierced_probability;
    sight.rest_radius_um = seen.rest_outer_radius_um;
    sight.membrane_um = seen.indentation_um;
    sight.membrane_sigma_um = seen.indentation_sigma_um;
    sight.outer_sigma_um = usual_sigma_um(*seen.outer);
  }
  sight.depth_um = estimate.depth_um;
  if (truth.outer && truth.needle) {
    sight.true_tip_um = needle_contact(truth).tip_depth_um;
    sight.true_membrane_um = truth.indentation_um;
    sight.center_ahead_um = (seen.center_um - truth.center_um).dot(truth.needle->direction);
  }
  sight.residual_um = estimate.shape.residual_rms_um;
  sight.dimple_residual_um = estimate.shape.dimple_residual_um;
  sight.noise_um = estimate.shape.noise_um;
  sight.force_uN = estimate.contact_force_uN;
  sight.lower_uN = estimate.by_picture.lower_uN;
  sight.upper_uN = estimate.by_picture.upper_uN;
  const SizesByContour unsaid{.stiffening_effect = ForceEstimate::kNotMeasured,
                              .stiffening_effect_sigma = ForceEstimate::kNotMeasured};
  const SizesByContour said = estimate.sizes_by_contour.value_or(unsaid);
  sight.stiffening_effect = said.stiffening_effect;
  sight.stiffening_effect_sigma = said.stiffening_effect_sigma;
  sight.sizes_ratio = said.force_ratio;
  return sight;
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

bool FilmRun::is_confident_and_wrong(const FrameError& error) const {
  if (error.confidence <= 0.8) return false;
  const bool sees_cell = error.state != CellState::kNoCell && error.state != CellState::kLost;
  return has_cell ? error.outer_px > 2.0 || error.tip_px > 3.0 : sees_cell;
}

namespace {

VirtualMicroscope microscope_of(const RandomFilm& film) {
  if (film.drawing) return VirtualMicroscope(film.scenario);
  return VirtualMicroscope(film.scenario, film.look);
}

FilmSizes sizes_of(const Observation& o) {
  return {o.rest_outer_radius_um, o.rest_inner_radius_um > 0 ? o.rest_outer_radius_um - o.rest_inner_radius_um : 0.0,
          o.needle ? o.needle->tip_radius_um : 0.0, o.holder ? o.holder->outer_radius_um : 0.0,
          o.rest_thickness_sigma_um};
}

// The force by the profile's thickness, tip and holder.
class ProfileForce {
 public:
  explicit ProfileForce(const CellProfile& profile) : profile_(profile) {}
  double at(const Observation& o, double depth_um) {
    const double radius_um = o.rest_outer_radius_um - 0.5 * profile_.thickness_um;
    if (!indenter_ || std::abs(radius_um / indenter_->model().setup().mid_radius_um - 1.0) > 0.004)
      indenter_.emplace(profile_, MembraneSetup{radius_um, profile_.thickness_um});
    return depth_um > 0.0 ? indenter_->advance_to(depth_um).push_force_uN : 0.0;
  }

 private:
  CellProfile profile_;
  std::optional<Indenter> indenter_;
};

}  // namespace

FilmRun run_film(const RandomFilm& film, const TrackerOptions& options, bool is_commanded) {
  using Clock = std::chrono::steady_clock;
  FilmRun run;
  run.film = film;
  run.has_cell = film.scenario.cell.in_view;
  VirtualMicroscope microscope = microscope_of(film);
  const bool shipped = std::filesystem::path(film.scenario.cell.reference).has_parent_path() == false;
  const CellProfile of_kind = load_profile(shipped ? film.scenario.cell.reference : "mouse-oocyte");
  const CellProfile profile = film.relaxes ? with_relaxation(of_kind) : of_kind;
  TrackerOptions of_size = options;
  of_size.expected_radius_um = profile.mid_radius_um + 0.5 * profile.thickness_um;
  MembraneTracker tracker(of_size);
  RelaxingTruth relaxing(film.seed);
  std::optional<ProfileForce> by_profile;
  if (!shipped) by_profile.emplace(profile);
  std::optional<SpecimenTrial> specimen;
  if (!shipped) specimen.emplace(film, profile);
  double profile_squares = 0.0, sight_squares = 0.0;
  int sight_count = 0;
  ForceObserver observer(profile, {}), of_truth(profile, {});
  std::vector<double> frame_ms;
  double force_squares = 0.0, peak_uN = 0.0, worst_badness = -1.0;
  double tracking_squares = 0.0, pushed_squares = 0.0, peak_of_truth_uN = 0.0;
  int pushed_count = 0;
  std::optional<long> punctured_at;
  std::vector<FilmPicture> every;
  std::optional<FilmManipulator> manipulator;
  if (is_commanded) manipulator.emplace(film);
  std::optional<Eigen::Vector2d> reported_um;
  while (const std::optional<Frame> frame = microscope.next()) {
    FrameHints hints;
    if (manipulator) {
      const Eigen::Vector2d now_um = manipulator->at(frame->time_s);
      if (reported_um) hints.needle_motion_um = now_um - *reported_um;
      reported_um = now_um;
    }
    const auto start = Clock::now();
    const Observation seen = tracker.process(view_of(frame->image.get()), frame->time_s, frame->frame_index, hints);
    frame_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    Truth truth = microscope.truth();
    if (film.relaxes) truth.contact_force_uN = relaxing.add(frame->time_s, truth.contact_force_uN);
    const ForceEstimate estimate = observer.process(seen);
    // What is reported: the tracker's state after the verdict on a puncture.
    const CellState state = estimate.judged_state(seen.state);
    FrameError error = error_of(seen, truth.observation, film.scenario.image.pixel_size_um);
    error.state = state;
    run.errors.push_back(error);
    run.sights.push_back(sight_of(seen, truth.observation, estimate));
    if (seen.outer) ++run.found_count;

    const bool contact = truth.observation.state == CellState::kContact;
    if (contact) ++run.contact_count;
    const bool false_puncture = contact && state == CellState::kPunctured;
    if (false_puncture) ++run.false_puncture_count;
    if (truth.observation.state == CellState::kPunctured) {
      if (!punctured_at) punctured_at = frame->frame_index;
      run.punctures = true;
      if (!run.puncture_delay && state == CellState::kPunctured)
        run.puncture_delay = frame->frame_index - *punctured_at;
    }
    const bool bold = run.is_confident_and_wrong(error);
    if (bold) ++run.confident_and_wrong_count;

    const bool measured = std::isfinite(estimate.contact_force_uN);
    const double force_uN = measured ? estimate.contact_force_uN : 0.0;
    force_squares += std::pow(force_uN - truth.contact_force_uN, 2);
    if (by_profile) {
      const double other_uN =
          measured && seen.outer ? by_profile->at(seen, contact ? std::max(0.0, estimate.depth_um) : 0.0) : 0.0;
      profile_squares += std::pow(other_uN - truth.contact_force_uN, 2);
    }
    if (seen.state == CellState::kFree) run.seen_sizes = sizes_of(seen);
    if (truth.observation.outer) run.true_sizes = sizes_of(truth.observation);
    const double expected_uN = of_truth.process(truth.observation).contact_force_uN;
    if (std::isfinite(expected_uN)) {
      tracking_squares += std::pow(force_uN - expected_uN, 2);
      peak_of_truth_uN = std::max(peak_of_truth_uN, expected_uN);
      if (contact && measured) {
        pushed_squares += std::pow(force_uN - expected_uN, 2);
        ++pushed_count;
      }
    }
    peak_uN = std::max(peak_uN, truth.contact_force_uN);
    const double true_uN = shipped ? expected_uN : truth.contact_force_uN;
    if (contact && measured && std::isfinite(true_uN)) {
      ++run.measured_count;
      if (estimate.by_picture.lower_uN <= true_uN && true_uN <= estimate.by_picture.upper_uN) ++run.covered_count;
    }
    run.sights.back().expected_uN = expected_uN;
    run.sights.back().true_uN = truth.contact_force_uN;
    if (contact && std::isfinite(expected_uN)) {
      sight_squares += std::pow(expected_uN - truth.contact_force_uN, 2);
      ++sight_count;
    }
    if (specimen) specimen->add(seen, estimate, contact, truth.contact_force_uN, truth.observation.indentation_um);

    const double missed = run.has_cell && !seen.outer ? 5.0 : 0.0;
    const double badness = (bold ? 1000.0 : 0.0) + (false_puncture ? 300.0 : 0.0) + missed +
                           std::min(std::max(error.outer_px, 0.0), 50.0) + std::min(std::max(error.tip_px, 0.0), 50.0);
    run.badness += badness;
    every.push_back({frame->frame_index, seen, truth.observation});
    if (badness > worst_badness) {
      worst_badness = badness;
      run.worst = {frame->frame_index, seen, truth.observation};
    }
  }
  constexpr std::size_t kPictures = kSheetColumns * kSheetRows;
  for (std::size_t k = 0; k < std::min(kPictures, every.size()); ++k)
    run.pictures.push_back(
        every[(every.size() - 1) * k / std::max<std::size_t>(1, std::min(kPictures, every.size()) - 1)]);
  run.badness /= static_cast<double>(std::max<std::size_t>(1, run.errors.size()));
  if (peak_uN > 0)
    run.force_rms_percent = 100.0 * std::sqrt(force_squares / static_cast<double>(run.errors.size())) / peak_uN;
  if (peak_uN > 0 && by_profile)
    run.profile_force_rms_percent =
        100.0 * std::sqrt(profile_squares / static_cast<double>(run.errors.size())) / peak_uN;
  if (peak_of_truth_uN > kLeastPeak_uN)
    run.tracking_force_rms_percent =
        100.0 * std::sqrt(tracking_squares / static_cast<double>(run.errors.size())) / peak_of_truth_uN;
  if (peak_of_truth_uN > kLeastPeak_uN && pushed_count > 0)
    run.pushed_force_rms_percent = 100.0 * std::sqrt(pushed_squares / pushed_count) / peak_of_truth_uN;
  if (specimen) run.specimen = specimen->result();
  if (sight_count > 0) run.true_sight_percent = 100.0 * std::sqrt(sight_squares / sight_count) / peak_uN;
  run.median_frame_ms = median_of(frame_ms);
  return run;
}

namespace {

// Frame `index` of the film, with the true contours and tip (green) and those found (red); `microscope` has given
// `given` frames before.
cv::Mat drawn(VirtualMicroscope& microscope, long& given, const FilmRun& run, const FilmPicture& picture) {
  for (; given < picture.frame_index; ++given)
    run.film.look.camera.interlaced ? void(microscope.next()) : void(microscope.skip());
  const std::optional<Frame> frame = microscope.next();
  ++given;
  const ImageView view = view_of(frame->image.get());
  const cv::Mat grey(view.height_px, view.width_px, CV_8U, const_cast<void*>(view.data),
                     static_cast<std::size_t>(view.row_bytes));
  cv::Mat result;
  cv::cvtColor(grey, result, cv::COLOR_GRAY2BGR);
  auto place = [&](const Eigen::Vector2d& p) {
    return cv::Point(static_cast<int>(std::lround(16 * p.x() / view.pixel_size_um)),
                     static_cast<int>(std::lround(16 * p.y() / view.pixel_size_um)));
  };
  auto draw = [&](const Observation& seen, const cv::Scalar& colour) {
    for (const auto* contour : {&seen.outer, &seen.inner}) {
      if (!*contour) continue;
      const Contour_um& points = (*contour)->points_um;
      for (Eigen::Index i = 0; i < points.cols(); ++i)
        cv::line(result, place(points.col(i)), place(points.col((i + 1) % points.cols())), colour, 1, cv::LINE_AA, 4);
    }
    if (!seen.needle) return;
    const Eigen::Vector2d tip = seen.needle->tip_um;
    cv::circle(result, place(tip), 5 * 16, colour, 1, cv::LINE_AA, 4);
    cv::line(result, place(tip), place(tip - 40 * view.pixel_size_um * seen.needle->direction), colour, 1, cv::LINE_AA,
             4);
  };
  draw(picture.truth, {0, 200, 0});
  draw(picture.seen, {60, 60, 255});
  return result;
}

}  // namespace

void draw_worst(const FilmRun& run, const std::string& file) {
  VirtualMicroscope microscope = microscope_of(run.film);
  long given = 0;
  cv::imwrite(file, drawn(microscope, given, run, run.worst));
}

void draw_sheet(const FilmRun& run, const std::string& file) {
  VirtualMicroscope microscope = microscope_of(run.film);
  long given = 0;
  cv::Mat sheet;
  int place = 0;
  for (const FilmPicture& picture : run.pictures) {
    const cv::Mat one = drawn(microscope, given, run, picture);
    char text[80];
    std::snprintf(text, sizeof text, "%ld %s (%s) %.2f", picture.frame_index,
                  std::string(to_string(picture.seen.state)).c_str(),
                  std::string(to_string(picture.truth.state)).c_str(), picture.seen.confidence);
    cv::putText(one, text, {4, 16}, cv::FONT_HERSHEY_SIMPLEX, 0.5, {0, 255, 255}, 1, cv::LINE_AA);
    if (sheet.empty()) sheet = cv::Mat::zeros(kSheetRows * one.rows, kSheetColumns * one.cols, one.type());
    one.copyTo(sheet({place % kSheetColumns * one.cols, place / kSheetColumns * one.rows, one.cols, one.rows}));
    ++place;
  }
  cv::imwrite(file, sheet);
}

}  // namespace pellucida::test
