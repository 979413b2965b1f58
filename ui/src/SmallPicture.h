#pragma once
#include <QImage>
#include <QSize>

class vtkImageData;

namespace pellucida {

/// A session's image (grey, frame W) as a small picture of exactly `size_px`, its middle where the shapes differ: grey
/// values from the darkest to the brightest. Null for an image without pixels. Any thread.
QImage small_picture(vtkImageData& image, QSize size_px);

/// The middle of a picture in exactly this size.
QImage middle_of(const QImage& picture, QSize size_px);

}  // namespace pellucida
