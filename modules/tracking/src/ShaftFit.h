#pragma once
#include <Eigen/Core>
#include <vector>

#include "FrameSampler.h"
#include "NeedleModel.h"

namespace pellucida {

/// What a shaft's cross-sections say about the needle, relative to the axis they were taken along.
struct ShaftResult {
  bool found = false;
  double offset = 0.0;        ///< px across at the tip
  double slope = 0.0;         ///< px across per px behind the tip
  double offset_sigma = 0.0;  ///< px
  double ahead = 0.0;         ///< px: how much further ahead the tip is by the width of the shaft on the known cone
  double ahead_sigma = 0.0;   ///< px; large where the cone is a cylinder
  double support = 0.0;       ///< 0..1: share of the stations where the needle's look was seen
  double gain = 0.0;          ///< contrast over the learnt one
  double medium = 0.0;        ///< grey value beside the shaft near the tip
  int stations = 0;           ///< stations seen
};

/// Fits the learnt look to cross-sections of the shaft. At each station four numbers are solved for by least squares:
/// grey value beside the needle, contrast, shift across, change of width; so light and contrast may change along the
/// shaft and from frame to frame. Straight lines through shift and change of width, robust against stations where
/// something else crosses, give the axis and the place on the cone. Allocates only when the model's size changes.
class ShaftFit {
 public:
  /// Prepares for a model: stations from just behind the tip to `behind_px`.
  void prepare(const NeedleModel& model, double behind_px);

  /// `axis`: within about a blur of the truth; `noise`: of the image.
  ShaftResult measure(const FrameSampler& image, const NeedleAxis& axis, double noise);

  /// Adds the last measured frame to the model's look and cone; the tip lies `ahead` px ahead of the axis measured
  /// along, `weight` (0..1] is this frame's share in the mean.
  void learn(NeedleModel& model, double ahead, double weight);

  /// How far beside `axis` a shaft like this one lies, searched within +-`reach_px`; nothing of that kind: 0.
  double find_beside(const FrameSampler& image, const NeedleAxis& axis, double reach_px, double& correlation);

  double behind_px() const noexcept { return behind_px_; }
  /// Blur of the look prepared for, px.
  double blur_px() const noexcept { return blur_; }

 private:
  struct Station {
    double s = 0.0, half_width = 0.0, widening = 0.0;
    int first = 0, count = 0;  // columns used
    double shift_variance = 0.0, width_variance = 0.0;
    // Of this frame:
    double medium = 0.0, contrast = 0.0, shift = 0.0, wider = 0.0;
    bool inside = false, seen = false;
  };
  void sample_station(const FrameSampler& image, const NeedleAxis& axis, const Station& station, float* values);
  void fit_axis(double noise, ShaftResult& result);
  void fit_cone(double noise, ShaftResult& result);

  std::vector<Station> stations_;
  Eigen::MatrixXf solve_;    // (4 * columns x stations): rows of the least-squares solution
  Eigen::MatrixXf profile_;  // (columns x stations): the look without medium
  Eigen::MatrixXf values_;   // (columns x stations): the image
  std::vector<float> mean_, wide_;
  std::vector<double> scratch_, learn_s_, learn_width_, learn_weight_;
  double step_ = 0.5, half_across_ = 0.0, behind_px_ = 0.0, unit_ = 1.0, blur_ = 1.0;
  double seen_to_ = 0.0;               // px behind the tip
  double offset_ = 0.0, slope_ = 0.0;  // of the last frame
  int columns_ = 0, lines_ = 1;
};

}  // namespace pellucida
