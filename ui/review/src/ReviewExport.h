#pragma once
#include <QObject>
#include <QSize>
#include <QString>
#include <filesystem>
#include <functional>

#include "BackgroundTask.h"
#include "FileChoice.h"

class QWidget;

namespace pellucida {

class CurveChart;
struct SeenFrame;
class ViewWidget;

/// Writes what the window shows, and what the session holds, to files. Nothing is replaced without a question.
class ReviewExport : public QObject {
 public:
  /// The text, and whether it is a problem.
  using Notify = std::function<void(const QString&, bool)>;
  /// What is being done and how much of it; an empty text: nothing any more.
  using Work = std::function<void(const QString&, std::size_t, std::size_t)>;

  ReviewExport(FileChoice choice, Notify notify, Work work, QObject* parent);

  /// The session that is exported.
  void set_session(const std::filesystem::path& folder);

  void save_window(QWidget& window);
  /// `what`: ends the proposed name, "3d".
  void save_view(ViewWidget& view, const std::string& what);
  /// A chart for print, as SVG, PDF or PNG.
  /// As a table too, which `write` writes; none: the chart's points.
  void save_chart(const CurveChart& chart, const QString& title, const std::string& what,
                  const std::function<void(const std::filesystem::path&)>& write = {});
  /// A table that `write` writes to the file it is given; it may throw Error.
  void save_table(const QString& title, const std::string& what,
                  const std::function<void(const std::filesystem::path&)>& write);
  /// Asks for a film's file; empty: not now.
  std::filesystem::path ask_for_video() const;
  /// The session's rows, events, contours and nodes at the peak, as `pellucida export` writes them.
  void save_tables();
  /// The dose passport, then its page is shown.
  void report();
  /// The frame shown: its row, its nodes, the charts, each as a table.
  void save_seen(const SeenFrame& frame);
  /// Ends what runs in the background.
  void cancel();

 private:
  std::filesystem::path proposal(const std::string& what, const char* ending) const;
  void save_image(const QImage& image, const std::filesystem::path& file);
  void run(const QString& text, std::function<std::function<void()>(const BackgroundTask::Control&)> work);
  QSize size_for(const QString& title, QSize seen, bool keeps_shape) const;
  bool may_write(const std::vector<std::filesystem::path>& files) const;

  FileChoice choice_;
  Notify notify_;
  Work work_;
  std::filesystem::path session_;
  BackgroundTask task_;
};

}  // namespace pellucida
