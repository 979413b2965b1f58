#include "ReviewExport.h"

#include <QImage>
#include <QPixmap>
#include <QWidget>

#include "WindowPicture.h"
#include "Words.h"
#include "pellucida/core/Error.h"
#include "pellucida/report/PassportReport.h"
#include "pellucida/session/SessionExport.h"
#include "presenters/ChartForPrint.h"
#include "presenters/RecordedSession.h"
#include "presenters/SeenTables.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPictureKinds = PELLUCIDA_WORDS("Picture (*.png)");
constexpr const char* kChartKinds = PELLUCIDA_WORDS("Drawing (*.svg);;Page (*.pdf);;Picture (*.png);;Table (*.csv)");
constexpr const char* kVideoKinds = PELLUCIDA_WORDS("Video (*.mp4);;Lossless video (*.avi)");
constexpr const char* kTableKinds = PELLUCIDA_WORDS("Table (*.csv)");
constexpr PictureSize kChartSize{.width_px = 1200, .height_px = 800};

QString shown(const fs::path& path) {
  return QString::fromStdString(path.string());
}

}  // namespace

ReviewExport::ReviewExport(FileChoice choice, Notify notify, Work work, QObject* parent)
    : QObject(parent), choice_(std::move(choice)), notify_(std::move(notify)), work_(std::move(work)) {}

void ReviewExport::set_session(const fs::path& folder) {
  cancel();
  session_ = folder;
}

fs::path ReviewExport::proposal(const std::string& what, const char* ending) const {
  const fs::path beside = fs::absolute(session_).lexically_normal();
  return beside.parent_path() / (session_name_of(session_) + "-" + what + ending);
}

void ReviewExport::save_image(const QImage& image, const fs::path& file) {
  const bool saved = image.save(shown(file), "PNG");
  notify_(saved ? words("Saved ") + shown(file)
                : shown(file) + words(": the picture can't be written; choose a folder that exists and may be written"),
          !saved);
}

QSize ReviewExport::size_for(const QString& title, QSize seen, bool keeps_shape) const {
  return choice_.picture_size ? choice_.picture_size(title, seen, keeps_shape) : seen;
}

void ReviewExport::save_window(QWidget& window) {
  const QSize size = size_for(words("Window as PNG"), window.size() * window.devicePixelRatioF(), true);
  if (size.isEmpty()) return;
  const QImage image = window_picture(window, size.width());
  const fs::path file = choice_.file_to_write(words("Window as PNG"), proposal("window", ".png"), words(kPictureKinds));
  if (!file.empty()) save_image(image, file);
}

void ReviewExport::save_view(ViewWidget& view, const std::string& what) {
  const QSize size = size_for(words("View as PNG"), view.size() * view.devicePixelRatioF(), false);
  if (size.isEmpty()) return;
  const QImage image = view.picture(size);
  const fs::path file = choice_.file_to_write(words("View as PNG"), proposal(what, ".png"), words(kPictureKinds));
  if (!file.empty()) save_image(image, file);
}

fs::path ReviewExport::ask_for_video() const {
  return choice_.file_to_write(words("Video of the views"), proposal("views", ".mp4"), words(kVideoKinds));
}

void ReviewExport::save_chart(const CurveChart& chart, const QString& title, const std::string& what,
                              const std::function<void(const fs::path&)>& write) {
  const ChartPanel panel = chart_for_print(chart.data(), title.toStdString());
  const fs::path file = choice_.file_to_write(title, proposal(what, ".svg"), words(kChartKinds));
  if (file.empty()) return;
  try {
    if (file.extension() != ".csv") {
      render_charts({&panel, 1}, 1, file, kChartSize);
    } else if (write) {
      write(file);
    } else {
      write_chart_table(chart.data(), file);
    }
    notify_(words("Saved ") + shown(file), false);
  } catch (const Error& error) {
    notify_(words_of(error), true);
  }
}

void ReviewExport::save_table(const QString& title, const std::string& what,
                              const std::function<void(const fs::path&)>& write) {
  const fs::path file = choice_.file_to_write(title, proposal(what, ".csv"), words(kTableKinds));
  if (file.empty()) return;
  try {
    write(file);
    notify_(words("Saved ") + shown(file), false);
  } catch (const Error& error) {
    notify_(words_of(error), true);
  }
}

void ReviewExport::save_seen(const SeenFrame& frame) {
  const fs::path folder =
      choice_.folder_to_write(words("Folder for the tables"), proposal("frame-" + std::to_string(frame.row.frame), ""));
  if (folder.empty() || !may_write(seen_files(frame, folder))) return;
  try {
    write_seen(frame, folder);
    notify_(words("%1 tables written to %2").arg(seen_files(frame, folder).size()).arg(shown(folder)), false);
  } catch (const Error& error) {
    notify_(words_of(error), true);
  }
}

bool ReviewExport::may_write(const std::vector<fs::path>& files) const {
  std::vector<fs::path> present;
  for (const fs::path& file : files) {
    if (fs::exists(file)) present.push_back(file);
  }
  return present.empty() || choice_.may_replace(present);
}

void ReviewExport::run(const QString& text, std::function<std::function<void()>(const BackgroundTask::Control&)> work) {
  if (task_.running()) {
    notify_(words("Wait for the export that is running, or cancel it"), true);
    return;
  }
  work_(text, 0, 0);
  task_.run(
      [this, work = std::move(work)](const BackgroundTask::Control& control) -> std::function<void()> {
        auto done = work(control);
        return [this, done = std::move(done)] {
          work_({}, 0, 0);
          done();
        };
      },
      [this, text](std::size_t done, std::size_t all) { work_(text, done, all); },
      [this](const std::string& error) {
        work_({}, 0, 0);
        notify_(QString::fromStdString(error), true);
      });
}

void ReviewExport::save_tables() {
  const fs::path folder = choice_.folder_to_write(words("Folder for the tables"), proposal("tables", ""));
  if (folder.empty()) return;
  if (!may_write(export_names(folder))) return;
  run(words("Writing tables"), [this, session = session_, folder](const BackgroundTask::Control& control) {
    ExportOptions options;
    options.progress = [&](std::size_t done, std::size_t all) { control.progress(done, all); };
    const ExportReport report = export_session(session, folder, options);
    return [this, folder, count = report.files.size()] {
      notify_(words("%1 tables written to %2").arg(count).arg(shown(folder)), false);
    };
  });
}

void ReviewExport::report() {
  const fs::path standard = session_ / kReportFolder / "report.html";
  const fs::path page = choice_.file_to_write(words("Report"), standard, words("Page (*.html)"));
  if (page.empty()) return;
  // The standard place has tables with the standard names; the page itself was asked about.
  const fs::path output = page.lexically_normal() == standard.lexically_normal() ? fs::path() : page;
  std::vector<fs::path> tables = report_names(session_, output);
  tables.erase(tables.begin());
  if (!may_write(tables)) return;
  run(words("Writing the report"), [this, session = session_, page, output](const BackgroundTask::Control& control) {
    write_report(session, output, [&](std::size_t done, std::size_t all) { control.progress(done, all); });
    return [this, page] {
      notify_(words("Report written: ") + shown(page), false);
      choice_.show_page(page);
    };
  });
}

void ReviewExport::cancel() {
  task_.cancel();
  work_({}, 0, 0);
}

}  // namespace pellucida
