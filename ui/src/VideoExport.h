#pragma once
#include <QObject>
#include <QString>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>

class QWidget;

namespace pellucida {

class VideoFile;

/// A film of what the window's views and charts show, frame after frame of the session, at its usual pace: each tick of
/// the window writes the step that is shown whole, and asks for the next one. So the window stays usable, and nothing
/// of a frame is missing.
class VideoExport : public QObject {
 public:
  struct Actions {
    std::function<void(std::size_t step)> go_to;
    std::function<void(const QString& text, bool problem)> notify;
    /// Progress; an empty text at the end.
    std::function<void(const QString& text, std::size_t done, std::size_t all)> work;
  };

  /// `pictured`: the widget that is filmed; must outlive the export.
  VideoExport(QWidget& pictured, Actions actions, QObject* parent);
  ~VideoExport() override;

  bool active() const noexcept { return video_ != nullptr; }
  /// Begins with the first of `step_count` steps; in place of one that is being written.
  void start(const std::filesystem::path& file, std::size_t step_count, double frame_rate_hz);
  /// The step that the views and charts show now.
  void shown(std::size_t step);
  /// Nothing is left of the film.
  void cancel();

 private:
  void finish();

  QWidget& pictured_;
  Actions actions_;
  std::unique_ptr<VideoFile> video_;
  std::filesystem::path file_;
  std::size_t next_ = 0, count_ = 0;
  int width_px_ = 0, height_px_ = 0;
};

}  // namespace pellucida
