#include "CellControl.h"

#include <QFileDialog>

#include "GuideMemory.h"
#include "RunControl.h"
#include "Words.h"
#include "pellucida/core/CellNameNote.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/report/PassportReport.h"
#include "widgets/CellDrawer.h"
#include "widgets/RecordStrip.h"

namespace pellucida {
namespace {

// How often the list that is shown is made anew without an event.
constexpr int kRenewed_ms = 2000;

}  // namespace

CellControl::CellControl(RunControl& run, const std::string& profile, QWidget& window,
                         std::function<void()> close_drawer, Notify notify)
    : QObject(&window), run_(run), window_(window), notify_(std::move(notify)), log_(profile) {
  drawer_ = new CellDrawer({[this] { save(); }, [this] { choose_folder(); }, std::move(close_drawer)}, &window);
  drawer_->show_folder(QString::fromStdString(run_.place().string()));
  drawer_->show_cells({});
  drawer_->hide();
  RecordStrip::Actions actions;
  actions.name = [this](const QString& name) { run_.remark(std::string(kCellNameNote) + name.toStdString()); };
  actions.note = [this](const QString& text) { run_.note(text); };
  strip_ = new RecordStrip(std::move(actions), &window);
  strip_->offer_name(QString::fromStdString(log_.suggested_name()), false);
}

void CellControl::take(const Scene& scene, std::span<const Measurement> rows) {
  if (scene.run_index != run_index_) log_.begin_anew(scene.measurement.frame);
  run_index_ = scene.run_index;
  log_.take(rows, {});
  // The cell in view changes without an event: its size, its time, a force that rises.
  if (drawer_->isVisible() && (!evaluated_.isValid() || evaluated_.elapsed() > kRenewed_ms)) is_stale_ = true;
}

void CellControl::take(std::span<const Event> events) {
  if (!events.empty() && log_.take({}, events)) {
    is_stale_ = true;
    const bool is_given = !log_.name().empty();
    strip_->offer_name(QString::fromStdString(is_given ? log_.name() : log_.suggested_name()), is_given);
  }
  if (is_stale_ && !task_.running()) evaluate();
}

void CellControl::evaluate() {
  is_stale_ = false;
  evaluated_.start();
  task_.run(
      [this, pending = log_.pending()](const BackgroundTask::Control&) mutable -> std::function<void()> {
        auto cells = std::make_shared<std::vector<CellPassport>>(CellLog::evaluate(std::move(pending)));
        return [this, cells] {
          log_.settle(std::move(*cells));
          show_cells();
        };
      },
      {}, [this](const std::string& text) { notify_(QString::fromStdString(say_message(text)), true); });
}

void CellControl::show_cells() {
  std::vector<CellRow> rows;
  for (const CellPassport& cell : log_.cells()) rows.push_back(cell_row(cell));
  drawer_->show_cells(rows);
}

void CellControl::begin_recording() {
  if (!log_.name().empty()) run_.remark(std::string(kCellNameNote) + log_.name());
  strip_->show();
}

void CellControl::begin_name() {
  strip_->begin_name();
}

void CellControl::begin_note() {
  strip_->begin_note();
}

void CellControl::save() {
  const std::filesystem::path file = run_.cells_file();
  try {
    make_folder(file.parent_path());
    OutputFile output(file);
    output.write(cells_csv(log_.cells()));
    output.finish();
    notify_(words("List of cells saved: ") + QString::fromStdString(file.string()), false);
  } catch (const Error& error) {
    notify_(words_of(error), true);
  }
}

// Not modal: the cell lives on, and the stop is in reach.
void CellControl::choose_folder() {
  auto* dialog =
      new QFileDialog(&window_, words("Folder for recordings"), QString::fromStdString(run_.place().string()));
  dialog->setObjectName("folderDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
    run_.set_place(folder.toStdString());
    remember_recordings(folder.toStdString());
    drawer_->show_folder(folder);
    notify_(words("The next recording goes into ") + folder, false);
  });
  dialog->show();
}

}  // namespace pellucida
