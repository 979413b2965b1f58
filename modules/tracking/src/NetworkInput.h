#pragma once
#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <opencv2/dnn.hpp>
#include <string_view>

#include "FrameSampler.h"

namespace pellucida {

/// What the networks of the tracker share.

/// Reads `networks/<name>.onnx` of the resources. Throws InputError when it can't be read.
cv::dnn::Net read_network(std::string_view name);

/// Zero median, unit mean absolute deviation, bounded: what every network is trained to see, so that brightness and
/// contrast don't matter.
void normalise(cv::Mat1f& picture);

/// `count` samples at from, from + step, ... of what is blurred a little where the samples lie further apart than a px.
void sample_blurred(const FrameSampler& image, const Eigen::Vector2d& from, const Eigen::Vector2d& step, int count,
                    float* out);

/// What the networks are shown of how finely an image is sampled.
float spacing_code(double spacing_px);

/// A batch of a patch and its mirror image, top for bottom, each with a plane that says how finely it is sampled
/// (2 x 2 x rows x columns): the mean of both answers is that of a mirrored film.
cv::Mat with_mirror_image(const cv::Mat1f& patch, double spacing_px);

/// Mean and spread of a network's answer (logits of one place each) about its highest place, in places.
struct PeakPlace {
  double mean = 0.0, spread = 0.0;
};
PeakPlace peak_of(const float* logits, int count);
/// Standard deviation of the whole answer about `mean`, in places, the labels' own taken off: what of it lies away from
/// the peak counts.
double spread_about(const float* logits, int count, double mean);

}  // namespace pellucida
