// A developer's tool, not installed: runs the tracker over a scenario of the virtual microscope, or over stills, prints
// a line a frame and draws the contours over chosen frames.
//   tracking_overlay virtual:NAME [--every N] [--draw F,F,...] [--out PREFIX]
//   tracking_overlay IMAGE_OR_VIDEO... [--every N] [--draw F,F,...] [--out PREFIX] [--pixel-size-um X]
//   --plain: contours on a plain ground, for pictures that must not be shown; --reference FILE: lines drawn by eye,
//   a point "x y" (px) a row, an empty row between lines.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <sstream>
#include <string>

#include "pellucida/core_vtk/SceneData.h"
#include "support/MatView.h"
#include "tracking/ScenarioRun.h"

namespace {

using namespace pellucida;

struct Choice {
  int every = 10;
  std::vector<long> draw;
  std::string out = "overlay";
  double pixel_size_um = 0.5;
  bool plain = false;
  std::vector<Contour_um> reference_px;
};

// Polylines of a text file: a point a row, an empty row between lines.
std::vector<Contour_um> read_polylines(const std::string& file) {
  std::ifstream in(file);
  std::vector<Contour_um> lines(1, Contour_um(2, 0));
  for (std::string row; std::getline(in, row);) {
    std::istringstream numbers(row);
    Eigen::Vector2d p;
    if (numbers >> p.x() >> p.y()) {
      lines.back().conservativeResize(2, lines.back().cols() + 1);
      lines.back().rightCols(1) = p;
    } else if (lines.back().cols() > 0) {
      lines.emplace_back(2, 0);
    }
  }
  return lines;
}

void draw(const cv::Mat& grey, const Observation& seen, double pixel_size_um, const std::string& file,
          const Choice& choice) {
  cv::Mat picture;
  cv::normalize(grey, picture, 0, 255, cv::NORM_MINMAX, CV_8U);
  cv::cvtColor(picture, picture, cv::COLOR_GRAY2BGR);
  if (choice.plain) picture.setTo(cv::Scalar(245, 245, 245));
  cv::Rect crop(0, 0, grey.cols, grey.rows);
  if (seen.outer) {
    const int reach = static_cast<int>(2.0 * seen.rest_outer_radius_um / pixel_size_um);
    crop &= cv::Rect(static_cast<int>(seen.center_um.x() / pixel_size_um) - reach,
                     static_cast<int>(seen.center_um.y() / pixel_size_um) - reach, 2 * reach, 2 * reach);
  }
  const int zoom = std::clamp(1000 / std::max(crop.width, 1), 1, 6);
  cv::Mat(picture(crop)).copyTo(picture);
  cv::resize(picture, picture, {}, zoom, zoom, cv::INTER_CUBIC);
  const auto place = [&](const Eigen::Vector2d& p) {
    return cv::Point(static_cast<int>(std::lround((p.x() / pixel_size_um - crop.x + 0.5) * zoom * 16)),
                     static_cast<int>(std::lround((p.y() / pixel_size_um - crop.y + 0.5) * zoom * 16)));
  };
  const auto line = [&](const Contour_um& points, const cv::Scalar& colour, bool closed) {
    for (Eigen::Index i = 0; i + (closed ? 0 : 1) < points.cols(); ++i)
      cv::line(picture, place(points.col(i)), place(points.col((i + 1) % points.cols())), colour, 1, cv::LINE_AA, 4);
  };
  for (const Contour_um& reference : choice.reference_px) line(reference * pixel_size_um, {60, 60, 200}, false);
  if (seen.outer) line(seen.outer->points_um, choice.plain ? cv::Scalar(0, 140, 0) : cv::Scalar(0, 255, 0), true);
  if (seen.inner) line(seen.inner->points_um, {0, 128, 255}, true);
  if (seen.oolemma) line(seen.oolemma->points_um, {255, 0, 255}, true);
  if (seen.needle) line(seen.needle->outline_um, {255, 80, 80}, false);
  if (seen.holder) line(seen.holder->outline_um, {255, 255, 0}, false);
  cv::imwrite(file, picture);
}

void print(const Observation& seen, double pixel_size_um, double took_ms) {
  std::printf("%4ld %-9s conf %.2f", seen.frame_index, std::string(to_string(seen.state)).c_str(), seen.confidence);
  if (seen.outer)
    std::printf(" R %.1f r %.1f px%s", seen.rest_outer_radius_um / pixel_size_um,
                seen.rest_inner_radius_um / pixel_size_um, seen.inner ? "" : " no inner");
  if (seen.needle)
    std::printf(" tip %.1f %.1f conf %.2f depth %.2f um", seen.needle->tip_um.x() / pixel_size_um,
                seen.needle->tip_um.y() / pixel_size_um, seen.needle->confidence, seen.indentation_um);
  if (seen.holder) std::printf(" holder");
  std::printf(" %.1f ms", took_ms);
}

bool chosen(const Choice& choice, long frame) {
  return std::find(choice.draw.begin(), choice.draw.end(), frame) != choice.draw.end();
}

void run_virtual(const std::string& name, const Choice& choice) {
  MembraneTracker tracker;
  double took = 0.0;
  const Scenario scenario = load_scenario(name);
  VirtualMicroscope microscope(scenario);
  std::vector<test::FrameError> errors;
  while (const std::optional<Frame> frame = microscope.next()) {
    const ImageView view = view_of(frame->image.get());
    const auto start = std::chrono::steady_clock::now();
    const Observation seen = tracker.process(view, frame->time_s, frame->frame_index);
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (frame->frame_index > 0) took += ms;
    const test::FrameError e = test::compare(seen, microscope.truth().observation, scenario.image.pixel_size_um);
    errors.push_back(e);
    if (frame->frame_index % choice.every == 0) {
      print(seen, scenario.image.pixel_size_um, ms);
      std::printf(" | true %s out %.2f in %.2f tip %.2f cen %.2f px ind %.2f-%.2f um dimple %.1f/%.1f\n",
                  std::string(to_string(e.true_state)).c_str(), e.outer_px, e.inner_px, e.tip_px, e.center_px,
                  seen.indentation_um, e.true_indentation_um, seen.dimple_radius_um,
                  microscope.truth().observation.dimple_radius_um);
    }
    if (chosen(choice, frame->frame_index)) {
      const cv::Mat grey(view.height_px, view.width_px, view.format == PixelFormat::kGray16 ? CV_16U : CV_8U,
                         const_cast<void*>(view.data), static_cast<std::size_t>(view.row_bytes));
      draw(grey, seen, view.pixel_size_um, choice.out + "_" + std::to_string(frame->frame_index) + ".png", choice);
    }
  }
  const test::ErrorSummary outer = summarize(errors, &test::FrameError::outer_px);
  const test::ErrorSummary inner = summarize(errors, &test::FrameError::inner_px);
  const test::ErrorSummary tip = summarize(errors, &test::FrameError::tip_px);
  const test::ErrorSummary depth = summarize_indentation(errors);
  double covered = 0.0;
  int bold = 0, state_errors = 0;
  for (const test::FrameError& e : errors) {
    covered += e.covered_ratio();
    bold += e.confident_and_wrong() ? 1 : 0;
    state_errors += e.state != e.true_state ? 1 : 0;
  }
  std::printf(
      "%s: outer %.3f (max %.2f, missing %d) inner %.3f (max %.2f, missing %d) tip %.3f (max %.2f, missing %d) px, "
      "indentation RMS %.3f (max %.2f) um, %.2f ms a frame, 1-sigma %.2f, confident and wrong %d, state differs %d of "
      "%zu\n",
      name.c_str(), outer.rms, outer.largest, outer.missing, inner.rms, inner.largest, inner.missing, tip.rms,
      tip.largest, tip.missing, depth.rms, depth.largest, took / std::max<std::size_t>(1, errors.size() - 1),
      covered / static_cast<double>(errors.size()), bold, state_errors, errors.size());
}

void run_files(const std::string& file, const Choice& choice) {
  MembraneTracker tracker;
  cv::Mat grey = cv::imread(file, cv::IMREAD_ANYDEPTH | cv::IMREAD_GRAYSCALE);
  cv::VideoCapture video;
  if (grey.empty()) video.open(file);
  const std::string stem = file.substr(file.rfind('/') + 1);
  for (long frame = 0;; ++frame) {
    if (video.isOpened()) {
      cv::Mat colour;
      if (!video.read(colour)) break;
      cv::cvtColor(colour, grey, cv::COLOR_BGR2GRAY);
    } else if (frame > 0 || grey.empty()) {
      break;
    }
    const ImageView view = test::mat_view(grey, choice.pixel_size_um);
    const auto start = std::chrono::steady_clock::now();
    const Observation seen = tracker.process(view, static_cast<double>(frame) / 30.0, frame);
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (frame % choice.every == 0) {
      std::printf("%s ", stem.c_str());
      print(seen, choice.pixel_size_um, ms);
      std::printf("\n");
    }
    if (chosen(choice, frame))
      draw(grey, seen, choice.pixel_size_um, choice.out + "_" + stem + "_" + std::to_string(frame) + ".png", choice);
  }
}

}  // namespace

int main(int count, char** arguments) {
  Choice choice;
  std::vector<std::string> inputs;
  for (int i = 1; i < count; ++i) {
    const std::string word = arguments[i];
    const auto value = [&] { return i + 1 < count ? std::string(arguments[++i]) : std::string(); };
    if (word == "--every") {
      choice.every = std::max(1, std::atoi(value().c_str()));
    } else if (word == "--out") {
      choice.out = value();
    } else if (word == "--pixel-size-um") {
      choice.pixel_size_um = std::atof(value().c_str());
    } else if (word == "--plain") {
      choice.plain = true;
    } else if (word == "--reference") {
      choice.reference_px = read_polylines(value());
    } else if (word == "--draw") {
      std::string list = value() + ",";
      for (std::size_t at = 0, end; (end = list.find(',', at)) != std::string::npos; at = end + 1)
        if (end > at) choice.draw.push_back(std::atol(list.substr(at, end - at).c_str()));
    } else {
      inputs.push_back(word);
    }
  }
  for (const std::string& input : inputs) {
    if (input.rfind("virtual:", 0) == 0) {
      run_virtual(input.substr(8), choice);
    } else {
      run_files(input, choice);
    }
  }
  return 0;
}
