#include "widgets/RecordingCard.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "Words.h"
#include "presenters/NumberField.h"
#include "presenters/StartLists.h"
#include "widgets/CardFields.h"
#include "widgets/Choice.h"
#include "widgets/PixelSizeDialog.h"

namespace pellucida {

RecordingCard::RecordingCard(const StartForm& form, Actions actions)
    : StartCard({StartCardId::kRecording, Pictogram::kOpen, words("Open a recording or a video"),
                 words("A video, a folder of images or a stack is measured; a recorded session opens in Review."),
                 words("Open")},
                actions.start),
      actions_(std::move(actions)) {
  path_ = make_number_line("", words("drop one on this window"), form.path);
  path_field_ = add_field(words("File or folder"), path_, "path");
  add_widget(build_path_row());
  profile_ = make_choice(profile_entries(), form.recording_profile);
  add_field(words("Profile of the cell"), profile_, "recordingProfile");
  pixel_ = make_number_line("µm", words("from the file"), form.recording_pixel_um);
  pixel_field_ = add_field(words("Edge of a pixel"), pixel_, "recordingPixel");
  add_widget(measure_ = make_measure_button());
  connect(measure_, &QPushButton::clicked, this, [this] { measure_pixel_size(); });
  rate_ = make_number_line(words("frames/s"), words("from the file"), form.frame_rate_hz);
  rate_field_ = add_field(words("Frame rate"), rate_, "frameRate");
  finish();
  connect(path_, &QLineEdit::textEdited, this, [this] {
    look_.cancel();
    judged_.reset();
    path_field_->show_note({});
    path_field_->show_problem({});
  });
  connect(path_, &QLineEdit::editingFinished, this, [this] {
    if (path_->text().isEmpty() || judged_ || look_.running()) return;
    look_at(path_->text().toStdString(), false);
  });
  connect(pixel_, &QLineEdit::textEdited, this, [this] { pixel_field_->show_note({}); });
  for (QLineEdit* line : {pixel_, rate_}) {
    connect(line, &QLineEdit::textEdited, this, [this] { clear_problems(); });
    connect(line, &QLineEdit::editingFinished, this, [this] { check_numbers(); });
  }
}

QWidget* RecordingCard::build_path_row() {
  auto* buttons = new QWidget;
  auto* row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  for (const bool folder : {false, true}) {
    auto* button = new QPushButton(folder ? words("Folder ...") : words("File ..."));
    button->setObjectName(folder ? "chooseFolder" : "chooseFile");
    button->setAccessibleName(folder ? words("Choose a folder") : words("Choose a file"));
    button->setFixedHeight(28);
    connect(button, &QPushButton::clicked, this, [this, folder] {
      if (const auto path = actions_.ask(folder); !path.empty()) take(path);
    });
    row->addWidget(button, 1);
  }
  return buttons;
}

// On the first image of what the path was seen to be.
void RecordingCard::measure_pixel_size() {
  if (!judged_ || judged_->kind != PathKind::kRecording) {
    show_problem({StartField::kPath, words("Choose a file or a folder of images first.").toStdString()});
    return;
  }
  auto* dialog = new PixelSizeDialog(
      judged_->path.string(),
      [this](const PixelMeasure& measure) {
        pixel_->setText(QString::fromStdString(measure.typed));
        check_numbers();
        pixel_field_->show_note(measured_note(measure));
      },
      window());
  dialog->open();
}

void RecordingCard::take(const std::filesystem::path& path) {
  path_->setText(QString::fromStdString(path.string()));
  look_at(path, true);
}

void RecordingCard::look_at(const std::filesystem::path& path, bool report_session) {
  judged_.reset();
  path_field_->show_problem({});
  path_field_->show_note(words("Looking at it ..."));
  look_.run(
      [this, path, report_session](const BackgroundTask::Control&) {
        const PathJudgement judgement = judge_path(path);
        return [this, judgement, report_session] {
          show_judgement(judgement);
          if (report_session && judgement.kind == PathKind::kSession) actions_.has_session(judgement.path);
        };
      },
      {}, [this](const std::string& text) { path_field_->show_problem(text); });
}

void RecordingCard::show_judgement(const PathJudgement& judgement) {
  judged_ = judgement;
  if (judgement.kind == PathKind::kSession) {
    path_field_->show_note(words("A recorded session: it opens in Review."));
    return;
  }
  check_numbers();
  path_field_->show_problem(judgement.problem);
}

void RecordingCard::check_numbers() {
  pixel_field_->show_problem(read_number(pixel_->text().toStdString(), kPixelSizeNumber).problem);
  rate_field_->show_problem(read_number(rate_->text().toStdString(), kFrameRateNumber).problem);
  if (judged_) path_field_->show_note(recording_note(*judged_, pixel_->text().toStdString()));
}

void RecordingCard::write(StartForm& form) const {
  form.path = path_->text().toStdString();
  form.recording_profile = value_of(*profile_);
  form.recording_pixel_um = pixel_->text().toStdString();
  form.frame_rate_hz = rate_->text().toStdString();
}

bool RecordingCard::show_problem(const StartProblem& problem) {
  CardField* field = problem.field == StartField::kPath             ? path_field_
                     : problem.field == StartField::kRecordingPixel ? pixel_field_
                     : problem.field == StartField::kFrameRate      ? rate_field_
                                                                    : nullptr;
  return point_at(field, problem.text);
}

void RecordingCard::clear_problems() {
  for (CardField* field : {path_field_, pixel_field_, rate_field_}) field->show_problem({});
}

}  // namespace pellucida
