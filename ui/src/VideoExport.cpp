#include "VideoExport.h"

#include <QImage>
#include <QPixmap>
#include <QWidget>

#include "VideoFile.h"
#include "Words.h"
#include "pellucida/core/Error.h"

namespace pellucida {

VideoExport::VideoExport(QWidget& pictured, Actions actions, QObject* parent)
    : QObject(parent), pictured_(pictured), actions_(std::move(actions)) {}
VideoExport::~VideoExport() = default;

void VideoExport::start(const std::filesystem::path& file, std::size_t step_count, double frame_rate_hz) {
  if (step_count == 0) return;
  file_ = file;
  next_ = 0;
  count_ = step_count;
  // Encoders want even sizes; the film keeps the size it began with.
  const double ratio = pictured_.devicePixelRatioF();
  width_px_ = static_cast<int>(ratio * pictured_.width()) & ~1;
  height_px_ = static_cast<int>(ratio * pictured_.height()) & ~1;
  try {
    video_ = std::make_unique<VideoFile>(file, width_px_, height_px_, frame_rate_hz);
  } catch (const Error& error) {
    video_.reset();
    actions_.notify(words_of(error), true);
    return;
  }
  actions_.work(words("Video"), 0, count_);
  actions_.go_to(0);
}

void VideoExport::shown(std::size_t step) {
  if (!video_) return;
  if (step != next_) {
    actions_.go_to(next_);
    return;
  }
  QImage picture = pictured_.grab().toImage().convertToFormat(QImage::Format_RGB888);
  // A window that was made larger or smaller meanwhile.
  if (picture.width() < width_px_ || picture.height() < height_px_) {
    picture = picture.scaled(width_px_, height_px_, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  }
  video_->add(picture.constBits(), picture.bytesPerLine());
  ++next_;
  actions_.work(words("Video"), next_, count_);
  next_ < count_ ? actions_.go_to(next_) : finish();
}

void VideoExport::finish() {
  try {
    video_->close();
    actions_.notify(words("Saved ") + QString::fromStdString(file_.string()), false);
  } catch (const Error& error) {
    actions_.notify(words_of(error), true);
  }
  video_.reset();
  actions_.work({}, 0, 0);
}

void VideoExport::cancel() {
  if (!video_) return;
  video_.reset();
  actions_.work({}, 0, 0);
  actions_.notify(words("Cancelled; no video was written"), false);
}

}  // namespace pellucida
