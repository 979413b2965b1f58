#pragma once
#include <QImage>
#include <string>

namespace pellucida {

/// The first frame of a recording, or one of a camera that has settled, as it is: one pixel for each of its own. For
/// any thread. Throws as `open_source` and FrameSource::next; InputError where there is no frame.
QImage first_picture(const std::string& source);

}  // namespace pellucida
