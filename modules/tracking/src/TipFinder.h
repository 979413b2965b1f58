#pragma once
#include <Eigen/Core>
#include <vector>

#include "FrameSampler.h"
#include "MembraneBackdrop.h"
#include "NeedleModel.h"

namespace pellucida {

/// Where a needle's edges end, relative to the tip looked round.
struct TipResult {
  bool found = false;
  double ahead = 0.0;         ///< px: how much further ahead the tip is
  double ahead_sigma = 0.0;   ///< px, from the image's noise alone
  double disagreement = 0.0;  ///< RMS of what the model leaves unexplained, over the noise
  double unexplained = 0.0;   ///< its mean square, relative to the medium
};

/// Finds the end of the needle: the learnt look, drawn round the model's end at a series of places along the axis,
/// against the image; the place that leaves least unexplained. Each row counts without its mean: what is alike all
/// across, as a membrane in front of the tip or a darker body behind it, says nothing. Far residuals count no more than
/// `kOutlier` contrasts, so that debris or a membrane in front does not decide. The tip is the model's own end, so blur
/// does not move it.
class TipFinder {
 public:
  void prepare(const NeedleModel& model);

  /// Takes the image's rows about the tip of `axis`. `reach_px`: how far ahead and back the tip may be; what lies
  /// further ahead of the axis's tip than `clear_px` is not looked at. False where too little is in view.
  bool sample(const FrameSampler& image, const NeedleAxis& axis, double reach_px, double clear_px);

  /// The end in the rows sampled last, as often as asked: another end may be prepared meanwhile, of the same look and
  /// cone. `gain` and `medium`: of this frame, from the shaft; `backdrop`: seen behind it, null for plain medium.
  TipResult find(double gain, double medium, double noise, const MembraneBackdrop* backdrop = nullptr);

 private:
  double cost(double ahead) const;
  void sample_row(const FrameSampler& image, const Eigen::Vector2d& from, const Eigen::Vector2d& step,
                  const Eigen::Vector2d& direction, float* row);

  Eigen::MatrixXf model_;             // (columns x rows): the look, half a unit from row to row
  Eigen::MatrixXf samples_, values_;  // (columns x rows): the image, and relative to the medium; one unit apart
  NeedleAxis axis_;                   // they were sampled on
  std::vector<double> costs_;
  std::vector<float> line_;
  double unit_ = 1.0, step_ = 0.5, before_ = 0.0, half_across_ = 0.0, depth_ = 0.1;
  float limit_ = 1.0F;
  int columns_ = 0, model_rows_ = 0, first_ = 0, rows_ = 0, reach_ = 2, lines_ = 1;
};

}  // namespace pellucida
