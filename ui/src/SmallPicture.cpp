#include "SmallPicture.h"

#include <vtkImageData.h>

#include <algorithm>
#include <cmath>

namespace pellucida {

QImage small_picture(vtkImageData& image, QSize size_px, QRect part) {
  const int* dimensions = image.GetDimensions();
  if (image.GetNumberOfScalarComponents() < 1) return {};
  const QRect whole(0, 0, dimensions[0], dimensions[1]);
  part = part.isEmpty() ? whole : part.intersected(whole);
  if (part.isEmpty()) return {};
  const QSize size = part.size().scaled(size_px, Qt::KeepAspectRatioByExpanding);
  double range[2];
  image.GetScalarRange(range);
  const double scale = range[1] > range[0] ? 255.0 / (range[1] - range[0]) : 0.0;
  QImage picture(size, QImage::Format_Grayscale8);
  for (int y = 0; y < size.height(); ++y) {
    uchar* line = picture.scanLine(y);
    const int row = part.top() + y * part.height() / size.height();
    for (int x = 0; x < size.width(); ++x) {
      const int column = part.left() + x * part.width() / size.width();
      const double value = image.GetScalarComponentAsDouble(column, row, 0, 0);
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
