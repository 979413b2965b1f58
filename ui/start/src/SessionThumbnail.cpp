#include "SessionThumbnail.h"

#include <vtkImageData.h>

#include <QImageReader>
#include <algorithm>

#include "SmallPicture.h"
#include "pellucida/core/Error.h"
#include "pellucida/session/SessionReader.h"

namespace pellucida {
namespace {

QImage first_image(const SessionReader& reader, QSize size_px) {
  const auto& steps = reader.steps();
  const auto with_image =
      std::find_if(steps.begin(), steps.end(), [](const SessionStep& step) { return step.has(SessionPart::kFrame); });
  if (with_image == steps.end()) return {};
  try {
    const auto image = reader.read_image(static_cast<std::size_t>(with_image - steps.begin()));
    return image ? small_picture(*image, size_px) : QImage();
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

SessionThumbnail read_thumbnail(const std::filesystem::path& session, QSize size_px) {
  const SessionReader reader(session);
  SessionThumbnail thumbnail{recent_session(reader), {}};
  if (const auto file = picture_in(session); !file.empty()) {
    QImageReader picture(QString::fromStdString(file.string()));
    thumbnail.picture = picture.read();
  }
  if (thumbnail.picture.isNull()) thumbnail.picture = first_image(reader, size_px);
  thumbnail.picture = middle_of(thumbnail.picture, size_px);
  return thumbnail;
}

}  // namespace pellucida
