// A developer's tool, not installed and no test: what the networks make of labelled pictures (film_samples), on which
// the limits of tracking/src/MembraneReading.cpp and SceneVerdict.cpp were set.
//   network_study FOLDER > FILE.csv
// A row each time an outline is read, from the true one, one too small or too large, or one beside the cell (`start`:
// its size, or `beside`): the network's score, and how far the outer contour it ends on lies from the true one, RMS in
// % of the radius. And rows for the whole picture (`start`: auto, lines, scene, the ways of detection): the confidence
// of the tracker's first frame, and the same distance of its contour; 100 where it has no cell. `thickness_ratio`: the
// zona's thickness over the true one, by the areas within both contours; 0 where there is no inner one.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <string>

#include "BoundaryNetwork.h"
#include "ContourMath.h"
#include "FrameSampler.h"
#include "MembraneSnakes.h"
#include "pellucida/core/Error.h"
#include "pellucida/tracking/MembraneTracker.h"

namespace {

using namespace pellucida;

constexpr double kSizes[] = {1.0, 0.75, 0.88, 1.12};
constexpr double kBeside_radii = 2.2;
constexpr double kNone_percent = 100.0;

struct Boundaries {
  Eigen::Matrix2Xd outer, inner;
};

/// By file, px; those with both.
std::map<std::string, Boundaries> boundaries_in(const std::filesystem::path& folder) {
  std::map<std::string, Boundaries> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!entry.path().filename().string().starts_with("contours_")) continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      std::istringstream words(line);
      std::string name, which, number;
      std::getline(words, name, ',');
      std::getline(words, which, ',');
      if (which != "outer" && which != "inner") continue;
      std::vector<double> values;
      while (std::getline(words, number, ',')) values.push_back(std::stod(number));
      (which == "outer" ? found[name].outer : found[name].inner) =
          Eigen::Map<Eigen::Matrix2Xd>(values.data(), 2, static_cast<Eigen::Index>(values.size() / 2));
    }
  }
  std::erase_if(found, [](const auto& one) { return one.second.outer.cols() == 0 || one.second.inner.cols() == 0; });
  return found;
}

double radius_px(const Eigen::Matrix2Xd& outline) {
  return std::sqrt(std::abs(contour::signed_area(outline)) / M_PI);
}

/// RMS distance of `points` from a closed outline, % of its radius.
double away_percent(const Eigen::Matrix2Xd& points, const Eigen::Matrix2Xd& outline) {
  if (points.cols() == 0) return kNone_percent;
  constexpr int kFine = 1440;
  const Eigen::Matrix2Xd fine = contour::resample(contour::positively_oriented(outline), kFine);
  double sum = 0.0;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    sum += (fine.colwise() - points.col(i)).colwise().squaredNorm().minCoeff();
  return 100.0 * std::sqrt(sum / static_cast<double>(points.cols())) / radius_px(outline);
}

double thickness_px(const Eigen::Matrix2Xd& outer, const Eigen::Matrix2Xd& inner) {
  return outer.cols() == 0 || inner.cols() == 0 ? 0.0 : radius_px(outer) - radius_px(inner);
}

void study(const std::string& name, const cv::Mat& grey, const Boundaries& truth, BoundaryNetwork& network) {
  const Eigen::Matrix2Xd& outer = truth.outer;
  const ImageView view{.data = grey.data,
                       .width_px = grey.cols,
                       .height_px = grey.rows,
                       .row_bytes = static_cast<std::ptrdiff_t>(grey.step),
                       .pixel_size_um = 1.0};
  const FrameSampler image(view);
  const Eigen::Vector2d middle = outer.rowwise().mean();
  const auto print = [&](const char* start, double score, const Eigen::Matrix2Xd& seen_outer,
                         const Eigen::Matrix2Xd& seen_inner) {
    std::printf("%s,%s,%.4f,%.3f,%.3f\n", name.c_str(), start, score, away_percent(seen_outer, outer),
                thickness_px(seen_outer, seen_inner) / thickness_px(outer, truth.inner));
  };
  const auto read = [&](const char* start, const Eigen::Matrix2Xd& outline) {
    MembraneSnakes snakes{TrackerOptions{}};
    (void)snakes.start(image, network, outline, 1.0, nullptr);
    print(start, snakes.outer().score, snakes.outer().points, snakes.inner().points);
  };
  for (const double size : kSizes)
    read(std::to_string(size).substr(0, 4).c_str(), (size * (outer.colwise() - middle)).colwise() + middle);
  const double side = middle.x() < 0.5 * grey.cols ? 1.0 : -1.0;
  read("beside", outer.colwise() + Eigen::Vector2d(side * kBeside_radii * radius_px(outer), 0.0));
  using Detection = TrackerOptions::Detection;
  for (const auto& [start_name, detection] :
       {std::pair{"auto", Detection::kAuto}, {"lines", Detection::kLines}, {"scene", Detection::kScene}}) {
    TrackerOptions options;
    options.detection = detection;
    MembraneTracker tracker(options);
    const Observation seen = tracker.process(view, 0.0, 0);
    const auto points = [](const auto& contour) { return contour ? contour->points_um : Eigen::Matrix2Xd(2, 0); };
    print(start_name, seen.confidence, points(seen.outer), points(seen.inner));
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: network_study FOLDER\n"), 2;
  cv::setNumThreads(1);
  try {
    BoundaryNetwork network;
    std::puts("file,start,score,away_percent,thickness_ratio");
    for (const auto& [name, truth] : boundaries_in(arguments[1])) {
      const cv::Mat grey = cv::imread((std::filesystem::path(arguments[1]) / name).string(), cv::IMREAD_GRAYSCALE);
      if (!grey.empty()) study(name, grey, truth, network);
    }
  } catch (const Error& error) {
    return std::fprintf(stderr, "network_study: %s\n", error.what()), 1;
  }
  return 0;
}
