#pragma once
#include <QImage>
#include <QTimer>
#include <QWidget>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "BackgroundTask.h"

namespace pellucida {

struct RecordedSession;
class TimelineBar;

/// Small images of the session above its timeline, as many as fit: each is the frame in the middle of its stretch of
/// time. They are read and made on a thread of their own. Press or drag seeks. Hidden where the session has no images,
/// or the window no room.
class ThumbnailBar : public QWidget {
 public:
  /// `timeline` is as wide as this one and must outlive it. `seek` is called with a time of the session, s.
  ThumbnailBar(const TimelineBar& timeline, std::function<void(double)> seek, QWidget* parent);

  /// `session` must outlive its showing; null: none.
  void set_session(const RecordedSession* session);
  /// Whether the window is high enough for it.
  void set_room(bool room);
  /// The image of that time has a frame round it.
  void set_position_s(double time_s);

  /// One for each stretch, in the order of time; null where there is none, or it isn't made yet.
  const std::vector<QImage>& pictures() const noexcept { return pictures_; }
  bool reading() const noexcept { return reading_.running() || due_.isActive(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  void arrange();
  void read();
  std::vector<std::optional<std::size_t>> steps() const;
  QRectF place(std::size_t index) const;

  const TimelineBar& timeline_;
  std::function<void(double)> seek_;
  const RecordedSession* session_ = nullptr;
  bool room_ = true;
  double position_s_ = 0.0;
  std::vector<QImage> pictures_;
  QTimer due_;  // a window that is being resized is waited for
  BackgroundTask reading_;
};

}  // namespace pellucida
