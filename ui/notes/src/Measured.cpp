#include "Measured.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "pellucida/core/OutputFile.h"
#include "pellucida/core/Table.h"
#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr double kTwoSided95 = 1.959964;
constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

Eigen::Vector2d vector_of(const Annotation::Place& place) {
  return {place.x_um, place.y_um};
}

// Digits behind the point so that the interval has two figures.
int decimals_for(double half_width) {
  return half_width > 0.0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(half_width))), 0, 3) : 1;
}

}  // namespace

std::optional<Measured> measured(const Annotation& note, double pixel_size_um) {
  if (!note.place_um || note.further_um.empty()) return std::nullopt;
  const double sigma_um = kClickSigma_px * pixel_size_um;
  const Eigen::Vector2d first = vector_of(*note.place_um), second = vector_of(note.further_um[0]);
  Measured result;
  if (note.further_um.size() == 1) {
    result.value = (second - first).norm();
    result.half_width = kTwoSided95 * std::numbers::sqrt2 * sigma_um;
    return result;
  }
  const Eigen::Vector2d a = first - second, b = vector_of(note.further_um[1]) - second;
  result.is_angle = true;
  result.value = kDegreesPerRadian * std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b));
  // An end turns its leg by the way across it over the leg's length; the vertex turns both.
  const double legs_um2 = a.norm() * b.norm();
  const double sigma_rad = sigma_um * std::sqrt(1.0 / a.squaredNorm() + 1.0 / b.squaredNorm() +
                                                (a - b).squaredNorm() / (legs_um2 * legs_um2));
  result.half_width = std::min(kTwoSided95 * kDegreesPerRadian * sigma_rad, 180.0);
  if (!(legs_um2 > 0.0)) result.half_width = 180.0;
  return result;
}

std::string words_of(const Measured& measured) {
  const int decimals = decimals_for(measured.half_width);
  const std::string number =
      readout::number(measured.value, decimals) + " ± " + readout::number(measured.half_width, decimals);
  return measured.is_angle ? say("Angle ") + number + "°" : say("Distance ") + number + " µm";
}

void write_measured(const std::vector<Annotation>& notes, double pixel_size_um, const std::filesystem::path& file) {
  OutputFile output(file);
  output.add("time_s,kind,distance_um,angle_deg,half_width_95,x1_um,y1_um,x2_um,y2_um,x3_um,y3_um,text");
  for (const Annotation& note : notes) {
    const auto result = measured(note, pixel_size_um);
    if (!result) continue;
    const std::string value = csv_number(result->value);
    std::string line = csv_number(note.time_s) + (result->is_angle ? ",angle,," + value : ",distance," + value + ',') +
                       ',' + csv_number(result->half_width);
    std::vector<Annotation::Place> places{*note.place_um};
    places.insert(places.end(), note.further_um.begin(), note.further_um.end());
    for (std::size_t k = 0; k < 3; ++k) {
      line += k < places.size() ? ',' + csv_number(places[k].x_um) + ',' + csv_number(places[k].y_um) : ",,";
    }
    output.add(line + ',' + csv_cell(note.text));
  }
  output.finish();
}

}  // namespace pellucida
