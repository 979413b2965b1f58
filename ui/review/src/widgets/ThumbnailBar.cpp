#include "widgets/ThumbnailBar.h"

#include <vtkImageData.h>

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "SmallPicture.h"
#include "Theme.h"
#include "Words.h"
#include "pellucida/core/Error.h"
#include "pellucida/session/SessionReader.h"
#include "presenters/RecordedSession.h"
#include "widgets/TimelineBar.h"

namespace pellucida {
namespace {

constexpr int kPictureHeight_px = 42;
constexpr int kPictureWidth_px = 63;
constexpr int kMargin_px = 4;
constexpr double kGap_px = 2.0;
constexpr int kResizePause_ms = 250;

QRect part_of(const RecordedSession& session) {
  const auto region_um = session.cell_region_um();
  const double pixel_um = session.info.source.pixel_size_um;
  if (!region_um || !(pixel_um > 0.0)) return {};
  const auto& [x, y, width, height] = *region_um;
  return QRectF(x / pixel_um, y / pixel_um, width / pixel_um, height / pixel_um).toRect();
}

QImage picture_of(const SessionReader& reader, std::optional<std::size_t> step, QSize size_px, QRect part) {
  if (!step) return {};
  try {
    const auto image = reader.read_image(*step);
    return image ? small_picture(*image, size_px, part) : QImage();
  } catch (const InputError&) {
    // The frame itself names the damage once it is shown.
    return {};
  }
}

}  // namespace

ThumbnailBar::ThumbnailBar(const TimelineBar& timeline, std::function<void(double)> seek, QWidget* parent)
    : QWidget(parent), timeline_(timeline), seek_(std::move(seek)) {
  setObjectName("thumbnails");
  setAccessibleName(words("Images along the session's time"));
  setFixedHeight(kPictureHeight_px + 2 * kMargin_px);
  setCursor(Qt::PointingHandCursor);
  setToolTip(words("The session's images along its time; a press seeks"));
  due_.setSingleShot(true);
  connect(&due_, &QTimer::timeout, this, [this] { read(); });
  hide();
}

void ThumbnailBar::set_session(const RecordedSession* session) {
  reading_.cancel();
  due_.stop();
  session_ = session;
  pictures_.clear();
  arrange();
}

void ThumbnailBar::set_room(bool room) {
  if (room == room_) return;
  room_ = room;
  arrange();
}

void ThumbnailBar::set_position_s(double time_s) {
  if (time_s == position_s_) return;
  position_s_ = time_s;
  update();
}

void ThumbnailBar::arrange() {
  setVisible(room_ && session_ && !session_->image_steps.empty());
  if (!isHidden()) due_.start(0);
  update();
}

std::vector<std::optional<std::size_t>> ThumbnailBar::steps() const {
  const double width_px = timeline_.bar().width();
  const auto count = static_cast<std::size_t>(std::max(std::floor(width_px / kPictureWidth_px), 1.0));
  std::vector<std::optional<std::size_t>> steps(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double middle = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    steps[i] = session_->image_step_at(timeline_.time_at(timeline_.bar().left() + middle * width_px));
  }
  return steps;
}

QRectF ThumbnailBar::place(std::size_t index) const {
  const double width_px = timeline_.bar().width() / static_cast<double>(std::max<std::size_t>(pictures_.size(), 1));
  return {timeline_.bar().left() + static_cast<double>(index) * width_px, kMargin_px, width_px, kPictureHeight_px};
}

void ThumbnailBar::read() {
  if (!session_ || isHidden()) return;
  const double ratio = devicePixelRatioF();
  const auto wanted = steps();
  pictures_.resize(wanted.size());
  // Each fills its stretch, which is a little wider than the least.
  const QSize size = QSizeF(ratio * place(0).width(), ratio * kPictureHeight_px).toSize();
  reading_.run(
      [this, folder = session_->folder, part = part_of(*session_), wanted, size,
       ratio](const BackgroundTask::Control& control) -> std::function<void()> {
        const SessionReader reader(folder);
        std::vector<QImage> made;
        for (const auto& step : wanted) {
          control.progress(made.size(), wanted.size());
          made.push_back(picture_of(reader, step, size, part));
          made.back().setDevicePixelRatio(ratio);
        }
        return [this, made = std::move(made)] {
          pictures_ = made;
          update();
        };
      },
      {}, [this](const std::string&) { pictures_.clear(); });
}

void ThumbnailBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), to_qt(current_theme().panel));
  for (std::size_t i = 0; i < pictures_.size(); ++i) {
    const QRectF box = place(i).adjusted(0.5 * kGap_px, 0.0, -0.5 * kGap_px, 0.0);
    if (pictures_[i].isNull()) {
      painter.fillRect(box, to_qt(current_theme().window));
    } else {
      painter.drawImage(box, pictures_[i]);
    }
    const double x = timeline_.x_of(position_s_);
    const bool last = i + 1 == pictures_.size();
    if (x < place(i).left() || (x >= place(i).right() && !last)) continue;
    painter.setPen(QPen(to_qt(current_theme().text), 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(box.adjusted(1.0, 1.0, -1.0, -1.0));
  }
}

void ThumbnailBar::resizeEvent(QResizeEvent*) {
  if (!isHidden()) due_.start(kResizePause_ms);
}

void ThumbnailBar::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) seek_(timeline_.time_at(event->localPos().x()));
}

void ThumbnailBar::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) seek_(timeline_.time_at(event->localPos().x()));
}

}  // namespace pellucida
