#include "films/FilmRun.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/mechanics/ForceObserver.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/membrane/Indenter.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pellucida/tracking/MembraneTracker.h"

namespace pellucida::test {
namespace {

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
          o.needle ? o.needle->tip_radius_um : 0.0, o.holder ? o.holder->outer_radius_um : 0.0};
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

FilmRun run_film(const RandomFilm& film, const TrackerOptions& options) {
  using Clock = std::chrono::steady_clock;
  FilmRun run;
  run.film = film;
  run.has_cell = film.scenario.cell.in_view;
  VirtualMicroscope microscope = microscope_of(film);
  MembraneTracker tracker(options);
  const bool shipped = std::filesystem::path(film.scenario.cell.reference).has_parent_path() == false;
  const CellProfile profile = load_profile(shipped ? film.scenario.cell.reference : "mouse-oocyte");
  std::optional<ProfileForce> by_profile;
  if (!shipped) by_profile.emplace(profile);
  double profile_squares = 0.0;
  ForceObserver observer(profile, {}), of_truth(profile, {});
  std::vector<double> frame_ms;
  double force_squares = 0.0, peak_uN = 0.0, worst_badness = -1.0;
  double tracking_squares = 0.0, peak_of_truth_uN = 0.0;
  std::optional<long> punctured_at;
  while (const std::optional<Frame> frame = microscope.next()) {
    const auto start = Clock::now();
    const Observation seen = tracker.process(view_of(frame->image.get()), frame->time_s, frame->frame_index);
    frame_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    const Truth& truth = microscope.truth();
    const ForceEstimate estimate = observer.process(seen);
    // What is reported: the tracker's state after the verdict on a puncture.
    const CellState state = estimate.judged_state(seen.state);
    FrameError error = error_of(seen, truth.observation, film.scenario.image.pixel_size_um);
    error.state = state;
    run.errors.push_back(error);
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
    }
    peak_uN = std::max(peak_uN, truth.contact_force_uN);
    if (contact && measured && estimate.contact_force_lower_uN <= truth.contact_force_uN &&
        truth.contact_force_uN <= estimate.contact_force_upper_uN)
      ++run.covered_count;

    const double missed = run.has_cell && !seen.outer ? 5.0 : 0.0;
    const double badness = (bold ? 1000.0 : 0.0) + (false_puncture ? 300.0 : 0.0) + missed +
                           std::min(std::max(error.outer_px, 0.0), 50.0) + std::min(std::max(error.tip_px, 0.0), 50.0);
    run.badness += badness;
    if (badness > worst_badness) {
      worst_badness = badness;
      run.worst = {frame->frame_index, seen, truth.observation};
    }
  }
  run.badness /= static_cast<double>(std::max<std::size_t>(1, run.errors.size()));
  if (peak_uN > 0)
    run.force_rms_percent = 100.0 * std::sqrt(force_squares / static_cast<double>(run.errors.size())) / peak_uN;
  if (peak_uN > 0 && by_profile)
    run.profile_force_rms_percent =
        100.0 * std::sqrt(profile_squares / static_cast<double>(run.errors.size())) / peak_uN;
  if (peak_of_truth_uN > 0)
    run.tracking_force_rms_percent =
        100.0 * std::sqrt(tracking_squares / static_cast<double>(run.errors.size())) / peak_of_truth_uN;
  run.median_frame_ms = median_of(frame_ms);
  return run;
}

void draw_worst(const FilmRun& run, const std::string& file) {
  VirtualMicroscope microscope = microscope_of(run.film);
  for (long k = 0; k < run.worst.frame_index; ++k)
    run.film.look.camera.interlaced ? void(microscope.next()) : void(microscope.skip());
  const std::optional<Frame> frame = microscope.next();
  const ImageView view = view_of(frame->image.get());
  const cv::Mat grey(view.height_px, view.width_px, CV_8U, const_cast<void*>(view.data),
                     static_cast<std::size_t>(view.row_bytes));
  cv::Mat picture;
  cv::cvtColor(grey, picture, cv::COLOR_GRAY2BGR);
  auto place = [&](const Eigen::Vector2d& p) {
    return cv::Point(static_cast<int>(std::lround(16 * p.x() / view.pixel_size_um)),
                     static_cast<int>(std::lround(16 * p.y() / view.pixel_size_um)));
  };
  auto draw = [&](const Observation& seen, const cv::Scalar& colour) {
    for (const auto* contour : {&seen.outer, &seen.inner}) {
      if (!*contour) continue;
      const Contour_um& points = (*contour)->points_um;
      for (Eigen::Index i = 0; i < points.cols(); ++i)
        cv::line(picture, place(points.col(i)), place(points.col((i + 1) % points.cols())), colour, 1, cv::LINE_AA, 4);
    }
    if (!seen.needle) return;
    const Eigen::Vector2d tip = seen.needle->tip_um;
    cv::circle(picture, place(tip), 5 * 16, colour, 1, cv::LINE_AA, 4);
    cv::line(picture, place(tip), place(tip - 40 * view.pixel_size_um * seen.needle->direction), colour, 1, cv::LINE_AA,
             4);
  };
  draw(run.worst.truth, {0, 200, 0});
  draw(run.worst.seen, {60, 60, 255});
  cv::imwrite(file, picture);
}

}  // namespace pellucida::test
