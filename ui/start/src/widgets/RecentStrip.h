#pragma once
#include <QWidget>
#include <filesystem>
#include <functional>
#include <vector>

#include "BackgroundTask.h"
#include "SessionThumbnail.h"

class QHBoxLayout;
class QLabel;

namespace pellucida {

/// The newest sessions, each with picture, date and duration; a click opens one. Read on a thread of its own.
class RecentStrip : public QWidget {
 public:
  RecentStrip(std::filesystem::path sessions, std::function<void(const std::filesystem::path&)> open);
  ~RecentStrip() override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();
  void read(std::filesystem::path sessions);
  void show_sessions(const std::vector<SessionThumbnail>& found);
  void show_text(const QString& text);

  std::function<void(const std::filesystem::path&)> open_;
  QWidget* strip_;
  QHBoxLayout* row_;
  QLabel* hint_;
  BackgroundTask task_;
};

}  // namespace pellucida
