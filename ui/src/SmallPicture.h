#pragma once
#include <QImage>
#include <QRect>
#include <QSize>

class vtkImageData;

namespace pellucida {

/// A session's image (grey, frame W) as a small picture of exactly `size_px`, its middle where the shapes differ: grey
/// values from the darkest to the brightest. `part`: of the image, pixels; empty: all of it. Null for an image without
/// pixels there. Any thread.
QImage small_picture(vtkImageData& image, QSize size_px, QRect part = {});

/// The middle of a picture in exactly this size.
QImage middle_of(const QImage& picture, QSize size_px);

}  // namespace pellucida
