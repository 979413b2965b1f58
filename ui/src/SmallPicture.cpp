#include "SmallPicture.h"

#include <vtkImageData.h>

#include <algorithm>
#include <cmath>

namespace pellucida {

QImage small_picture(vtkImageData& image, QSize size_px) {
  const int* dimensions = image.GetDimensions();
  if (dimensions[0] < 1 || dimensions[1] < 1 || image.GetNumberOfScalarComponents() < 1) return {};
  const QSize size = QSize(dimensions[0], dimensions[1]).scaled(size_px, Qt::KeepAspectRatioByExpanding);
  double range[2];
  image.GetScalarRange(range);
  const double scale = range[1] > range[0] ? 255.0 / (range[1] - range[0]) : 0.0;
  QImage picture(size, QImage::Format_Grayscale8);
  for (int y = 0; y < size.height(); ++y) {
    uchar* line = picture.scanLine(y);
    for (int x = 0; x < size.width(); ++x) {
      const double value =
          image.GetScalarComponentAsDouble(x * dimensions[0] / size.width(), y * dimensions[1] / size.height(), 0, 0);
      line[x] = static_cast<uchar>(std::clamp(std::lround(scale * (value - range[0])), 0L, 255L));
    }
  }
  return middle_of(picture, size_px);
}

QImage middle_of(const QImage& picture, QSize size_px) {
  if (picture.isNull()) return picture;
  const QImage scaled = picture.scaled(size_px, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  return scaled.copy((scaled.width() - size_px.width()) / 2, (scaled.height() - size_px.height()) / 2, size_px.width(),
                     size_px.height());
}

}  // namespace pellucida
