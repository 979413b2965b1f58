#pragma once
#include <Eigen/Core>
#include <array>
#include <memory>

#include "GrayImage.h"

namespace pellucida {

/// What a pixel shows, in the order of the network's outputs.
enum class SceneClass { kBackground, kZona, kInside, kNeedle, kHolder, kOtherBody };
inline constexpr int kSceneClassCount = 6;
/// Network pixels between two pixels of its map.
inline constexpr int kSceneMapStep = 2;

/// The network's map of an image or a part of it. A map pixel (column x, row y) lies at origin_px + pitch_px (x, y).
struct SceneMap {
  using Plane = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::array<Plane, kSceneClassCount> shares;  ///< probability of each class, 0..1; they sum to 1
  Plane tip;                                   ///< 0..1: the needle's tip is here
  double pitch_px = 1.0;                       ///< px of the image a map pixel
  Eigen::Vector2d origin_px = Eigen::Vector2d::Zero();

  const Plane& share(SceneClass which) const { return shares[static_cast<std::size_t>(which)]; }
  Eigen::Vector2d to_image(const Eigen::Vector2d& place) const { return origin_px + pitch_px * place; }
};

/// A part of an image.
struct SceneWindow {
  Eigen::Vector2d center_px = Eigen::Vector2d::Zero();
  double width_px = 0.0, height_px = 0.0;
};

/// A small convolutional network that labels each pixel of a micrograph in any contrast: zona, inside of the cell,
/// needle, holding pipette, another body, background; and where the needle's tip is. A first guess, never a
/// measurement: the snakes have the last word. Trained by `resources/networks/train_scene.py` on drawn pictures of the
/// tuning families; run by OpenCV. Polarity and brightness don't matter to it by training.
class SceneNetwork {
 public:
  /// Reads `networks/scene.onnx` of the resources. Throws InputError when it can't be read.
  SceneNetwork();
  ~SceneNetwork();
  SceneNetwork(SceneNetwork&&) noexcept;
  SceneNetwork& operator=(SceneNetwork&&) noexcept;

  /// The map of `window`, seen with `pixel_per_px` network pixels an image px. What of the window lies outside the
  /// image shows the image mirrored at its border.
  SceneMap read(const GrayImage& image, const SceneWindow& window, double pixel_per_px);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
