// A developer's tool, not installed and no test: labelled pictures to train a network on, one of each random film of
// the families of tuning. (Of validation or unseen they are to check with.)
//   film_samples --out FOLDER [--split tuning|wide|validation|unseen] [--count N] [--first SEED] [--plain yes]
//                [--specimens FOLDER] [--punctured yes|soon] [--pushed yes] [--empty yes]
// Writes FOLDER/NNNNN.png (8-bit grey), NNNNN_label.png (0 background, 1 zona, 2 inside the zona's inner boundary,
// 3 needle, 4 holding pipette, 5 bystander cell or bubble), samples_SEED.csv, and contours_SEED.csv (file; outer,
// inner, needle or holder; then x and y of the outline's points, px); NNNNN is the film's seed. Several of them may run
// at once with other seeds; a picture that is there is not replaced. Truth may lie outside the picture. Empty where
// there is no cell. --plain: the virtual microscope's plain drawing instead of a look. --specimens: cells of
// finite-element tables (tests/specimens), with zonae from thin to thick; else each zona is a tenth of its cell's
// radius thick. --punctured: those films alone whose membrane gives way, in a frame after that: the needle's tip lies
// in the ooplasm; soon: in one of the first four, while the membrane springs back. --pushed: in
// a frame of those in which the needle has touched the cell. --empty: those films alone that show no cell.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "films/RandomFilm.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/NeedleContact.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"

namespace {

using namespace pellucida;

constexpr int kWidest_px = 1024;
constexpr std::uint64_t kSoon_frames = 4;

void fill(cv::Mat& label, const Contour_um& points_um, double pixel_um, int value) {
  constexpr int kShift = 4;
  std::vector<cv::Point> polygon;
  for (Eigen::Index i = 0; i < points_um.cols(); ++i)
    polygon.emplace_back(static_cast<int>(std::lround(points_um(0, i) / pixel_um * (1 << kShift))),
                         static_cast<int>(std::lround(points_um(1, i) / pixel_um * (1 << kShift))));
  cv::fillPoly(label, std::vector<std::vector<cv::Point>>{polygon}, cv::Scalar(value), cv::LINE_8, kShift);
}

void fill_ball(cv::Mat& label, double x_um, double y_um, double radius_um, double pixel_um) {
  if (radius_um > 0)
    cv::circle(label, {static_cast<int>(std::lround(x_um / pixel_um)), static_cast<int>(std::lround(y_um / pixel_um))},
               static_cast<int>(std::lround(radius_um / pixel_um)), cv::Scalar(5), cv::FILLED);
}

cv::Mat label_of(const Scenario& scenario, const Observation& seen) {
  const double pixel_um = scenario.image.pixel_size_um;
  cv::Mat label(scenario.image.height_px, scenario.image.width_px, CV_8U, cv::Scalar(0));
  // A picture moves with the stage by what the cell's centre has moved.
  const double dx = seen.center_um.x() - scenario.cell.center_x_um, dy = seen.center_um.y() - scenario.cell.center_y_um;
  const Scenario::Bystander& other = scenario.bystander;
  fill_ball(label, other.cell_x_um + dx, other.cell_y_um + dy, other.cell_radius_um, pixel_um);
  fill_ball(label, other.bubble_x_um + dx, other.bubble_y_um + dy, other.bubble_radius_um, pixel_um);
  if (seen.outer) fill(label, seen.outer->points_um, pixel_um, 1);
  if (seen.inner) fill(label, seen.inner->points_um, pixel_um, 2);
  if (seen.holder) fill(label, seen.holder->outline_um, pixel_um, 4);
  fill(label, seen.needle->outline_um, pixel_um, 3);
  return label;
}

void write(std::ofstream& csv, const char* stem, const char* which, const Contour_um& points_um, double pixel_um) {
  csv << stem << ".png," << which;
  for (Eigen::Index i = 0; i < points_um.cols(); ++i)
    csv << ',' << points_um(0, i) / pixel_um << ',' << points_um(1, i) / pixel_um;
  csv << std::endl;
}

}  // namespace

int main(int count, char** arguments) {
  std::filesystem::path out;
  std::uint64_t first = 1, wanted = 100;
  test::Split split = test::Split::kTuning;
  bool is_plain = false, is_punctured = false, is_soon = false, is_pushed = false, is_empty = false;
  std::vector<std::string> specimens;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string word = arguments[i], value = arguments[i + 1];
    if (word == "--out")
      out = value;
    else if (word == "--count")
      wanted = std::stoull(value);
    else if (word == "--first")
      first = std::stoull(value);
    else if (word == "--split")
      split = test::split_of(value);
    else if (word == "--plain")
      is_plain = value == "yes";
    else if (word == "--punctured")
      is_soon = value == "soon", is_punctured = is_soon || value == "yes";
    else if (word == "--pushed")
      is_pushed = value == "yes";
    else if (word == "--empty")
      is_empty = value == "yes";
    else if (word == "--specimens")
      specimens = test::specimens_in(value);
    else
      return std::fprintf(stderr, "film_samples: unknown argument %s\n", word.c_str()), 2;
  }
  if (out.empty()) return std::fprintf(stderr, "film_samples: --out is missing\n"), 2;
  std::filesystem::create_directories(out);
  cv::setNumThreads(1);
  const std::filesystem::path table = out / ("samples_" + std::to_string(first) + ".csv");
  if (std::filesystem::exists(table))
    return std::fprintf(stderr, "film_samples: %s is there already: take other seeds or another folder\n",
                        table.c_str()),
           1;
  std::ofstream csv(table);
  csv << "file,tip_x_px,tip_y_px,direction_x,direction_y,tip_radius_px,center_x_px,center_y_px,outer_radius_px,"
         "tip_depth_px,membrane_depth_px,contrast,family,frame\n";
  std::ofstream contours(out / ("contours_" + std::to_string(first) + ".csv"));
  contours << std::fixed << std::setprecision(3);
  for (std::uint64_t seed = first; seed < first + wanted; ++seed) {
    try {
      const test::RandomFilm film = test::draw_film(split, seed, kWidest_px, specimens);
      if (is_punctured && !film.scenario.puncture.enabled) continue;
      if (is_empty && film.scenario.cell.in_view) continue;
      VirtualMicroscope microscope =
          is_plain ? VirtualMicroscope(film.scenario) : VirtualMicroscope(film.scenario, film.look);
      // Any of its frames; of an interlaced camera the one before as well.
      const long frames = *microscope.info().frame_count;
      const long earliest = is_punctured ? frames / 3 : is_pushed ? test::first_frame_in(film, CellState::kContact) : 0;
      if (earliest >= frames) continue;
      const long wanted_frame =
          is_soon ? test::first_frame_in(film, CellState::kPunctured) + static_cast<long>(seed % kSoon_frames)
                  : earliest + static_cast<long>((seed * 7919) % static_cast<std::uint64_t>(frames - earliest));
      if (wanted_frame >= frames) continue;
      for (long k = 0; k + 1 < wanted_frame; ++k) microscope.skip();
      if (wanted_frame > 0) film.look.camera.interlaced ? void(microscope.next()) : void(microscope.skip());
      const std::optional<Frame> frame = microscope.next();
      const ImageView view = view_of(frame->image.get());
      const cv::Mat grey(view.height_px, view.width_px, CV_8U, const_cast<void*>(view.data),
                         static_cast<std::size_t>(view.row_bytes));
      const Observation& seen = microscope.truth().observation;
      if (is_punctured && seen.state != CellState::kPunctured) continue;
      if (is_pushed && seen.state == CellState::kFree) continue;
      char stem[24];
      std::snprintf(stem, sizeof stem, "%05llu", static_cast<unsigned long long>(seed));
      if (std::filesystem::exists(out / (std::string(stem) + ".png")))
        return std::fprintf(stderr, "film_samples: %s.png is there already: take other seeds or another folder\n",
                            stem),
               1;
      const std::vector<int> quick{cv::IMWRITE_PNG_COMPRESSION, 1};
      cv::imwrite((out / (std::string(stem) + ".png")).string(), grey, quick);
      cv::imwrite((out / (std::string(stem) + "_label.png")).string(), label_of(film.scenario, seen), quick);
      const double pixel_um = view.pixel_size_um;
      csv << stem << ".png," << seen.needle->tip_um.x() / pixel_um << ',' << seen.needle->tip_um.y() / pixel_um << ','
          << seen.needle->direction.x() << ',' << seen.needle->direction.y() << ','
          << seen.needle->tip_radius_um / pixel_um << ',';
      if (seen.outer)
        csv << seen.center_um.x() / pixel_um << ',' << seen.center_um.y() / pixel_um << ','
            << seen.rest_outer_radius_um / pixel_um << ',' << needle_contact(seen).tip_depth_um / pixel_um << ','
            << seen.indentation_um / pixel_um << ',';
      else
        csv << ",,,,,";
      if (seen.outer) write(contours, stem, "outer", seen.outer->points_um, pixel_um);
      if (seen.inner) write(contours, stem, "inner", seen.inner->points_um, pixel_um);
      write(contours, stem, "needle", seen.needle->outline_um, pixel_um);
      if (seen.holder) write(contours, stem, "holder", seen.holder->outline_um, pixel_um);
      csv << film.contrast << ',' << film.family << ',' << seen.frame_index << std::endl;
    } catch (const Error& error) {
      return std::fprintf(stderr, "film_samples: film %llu: %s\n", static_cast<unsigned long long>(seed), error.what()),
             1;
    }
  }
  return csv && contours ? 0 : 1;
}
