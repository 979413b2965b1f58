#include "pellucida/microscopy/OpticalRenderer.h"

#include "CameraModel.h"
#include "CellContents.h"
#include "CellPath.h"
#include "Contrast.h"
#include "OpticalPath.h"

namespace pellucida {

class OpticalRenderer::Impl {
 public:
  Impl(const Look& look, const ImageView& image, double cell_radius_um, std::uint64_t seed)
      : look_(look),
        image_(image),
        cell_(look.cell, image.pixel_size_um),
        contents_(look.cell, cell_radius_um, image.pixel_size_um, seed),
        contrast_(look.contrast, image.pixel_size_um),
        camera_(look.camera, image, seed) {}

  ImageView render(const MicroscopeScene& scene) {
    const double pixel_um = image_.pixel_size_um;
    path_.clear({image_.width_px, image_.height_px});
    if (scene.cell) {
      cell_.add(path_, *scene.cell);
      contents_.add(path_, *scene.cell);
    }
    for (const SceneBall& ball : scene.balls) add_ball(path_, ball, pixel_um);
    add_holder(path_, scene, look_.holder.index, pixel_um);
    add_needle(path_, scene, pixel_um);
    contrast_.develop(path_, scene.needle_out_of_plane_um, light_);
    const cv::Mat& grey = camera_.expose(light_, scene.frame_index, scene.time_s, scene.lamp_ratio);
    image_.data = grey.data;
    image_.row_bytes = static_cast<std::ptrdiff_t>(grey.step[0]);
    return image_;
  }

 private:
  Look look_;
  ImageView image_;
  CellPath cell_;
  CellContents contents_;
  Contrast contrast_;
  CameraModel camera_;
  OpticalPath path_;
  cv::Mat1f light_;
};

OpticalRenderer::OpticalRenderer(const Look& look, const ImageView& image, double cell_radius_um, std::uint64_t seed)
    : impl_(std::make_unique<Impl>(look, image, cell_radius_um, seed)) {}
OpticalRenderer::~OpticalRenderer() = default;

ImageView OpticalRenderer::render(const MicroscopeScene& scene) {
  return impl_->render(scene);
}

}  // namespace pellucida
