#pragma once
#include <QImage>
#include <QSize>
#include <string>

class vtkImageData;

namespace pellucida {

/// Grey values from the darkest to the brightest, one sample a pixel of a picture that covers `size_px` in the image's
/// proportions. The first row of both is the top. Null for an image without pixels.
QImage grey_picture(vtkImageData& image, QSize size_px);

/// The first frame of a recording, or one of a camera that has settled, as it is: one pixel for each of its own. For
/// any thread. Throws as `open_source` and FrameSource::next; InputError where there is no frame.
QImage first_picture(const std::string& source);

}  // namespace pellucida
