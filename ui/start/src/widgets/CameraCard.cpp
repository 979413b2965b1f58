#include "widgets/CameraCard.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "Words.h"
#include "pellucida/visualization/Readout.h"
#include "presenters/NumberField.h"
#include "presenters/StartLists.h"
#include "widgets/CardFields.h"
#include "widgets/Choice.h"
#include "widgets/PixelSizeDialog.h"

namespace pellucida {

CameraCard::CameraCard(const StartForm& form, std::filesystem::path listing, std::function<void()> start)
    : StartCard({StartCardId::kCamera, Pictogram::kCamera, words("Connect a camera"),
                 words("The live image of your microscope's camera, measured as it comes."), words("Connect")},
                std::move(start)),
      listing_(std::move(listing)) {
  camera_field_ = add_field(words("Camera"), camera_ = make_choice({}, {}), "camera");
  auto* again = new QPushButton(words("Search again"));
  again->setObjectName("searchCameras");
  again->setFixedHeight(28);
  connect(again, &QPushButton::clicked, this, [this] {
    search(value_of(*camera_));
    show_size();
  });
  add_widget(again);
  profile_ = make_choice(profile_entries(), form.camera_profile);
  add_field(words("Profile of the cell"), profile_, "cameraProfile");
  objective_ = make_choice(objective_entries(), form.objective);
  objective_->setToolTip(words("Magnification from the specimen to the camera, the adapter's included"));
  add_field(words("Objective"), objective_, "objective");
  camera_pixel_ = make_number_line("µm", words("such as 3.45"), form.camera_pixel_um);
  camera_pixel_field_ = add_field(words("Camera's own pixel"), camera_pixel_, "cameraPixel");
  specimen_pixel_ = make_number_line("µm", words("such as 0.825"), form.specimen_pixel_um);
  specimen_pixel_field_ = add_field(words("Pixel in the specimen"), specimen_pixel_, "specimenPixel");
  add_widget(measure_ = make_measure_button());
  connect(measure_, &QPushButton::clicked, this, [this] { measure_pixel_size(); });
  add_widget(computed_ = new QLabel);
  computed_->setObjectName("computedSize");
  finish();
  connect(objective_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] { show_size(); });
  connect(camera_pixel_, &QLineEdit::textChanged, this, [this] { show_size(); });
  connect(specimen_pixel_, &QLineEdit::textEdited, this, [this] {
    specimen_pixel_field_->show_problem({});
    specimen_pixel_field_->show_note({});
  });
  connect(specimen_pixel_, &QLineEdit::editingFinished, this, [this] {
    specimen_pixel_field_->show_problem(read_number(specimen_pixel_->text().toStdString(), kPixelSizeNumber).problem);
  });
  connect(camera_pixel_, &QLineEdit::editingFinished, this, [this] {
    camera_pixel_field_->show_problem(read_number(camera_pixel_->text().toStdString(), kCameraPixelNumber).problem);
  });
  search(form.camera);
  show_size();
}

void CameraCard::search(const std::string& chosen) {
  const CameraList found = camera_list(listing_);
  camera_->clear();
  for (const auto& camera : found.cameras) {
    camera_->addItem(QString::fromStdString(camera.title), QString::fromStdString(camera.value));
  }
  if (found.cameras.empty()) camera_->addItem(words("No camera"), QString());
  if (!found.cameras.empty()) camera_->setCurrentIndex(index_of(found.cameras, chosen));
  camera_->setEnabled(!found.cameras.empty());
  camera_field_->show_note(found.notice);
  camera_field_->show_problem({});
}

void CameraCard::measure_pixel_size() {
  auto* dialog = new PixelSizeDialog(
      value_of(*camera_),
      [this](const PixelMeasure& measure) {
        specimen_pixel_->setText(QString::fromStdString(measure.typed));
        specimen_pixel_field_->show_problem({});
        specimen_pixel_field_->show_note(measured_note(measure));
      },
      window());
  dialog->open();
}

void CameraCard::show_size() {
  const std::string objective = value_of(*objective_);
  camera_pixel_field_->setVisible(!objective.empty());
  specimen_pixel_field_->setVisible(objective.empty());
  measure_->setVisible(objective.empty());
  measure_->setEnabled(!value_of(*camera_).empty());
  camera_pixel_field_->show_problem({});
  specimen_pixel_field_->show_problem({});
  computed_->setVisible(!objective.empty());
  const auto size = size_by_objective(objective.empty() ? "1" : objective, camera_pixel_->text().toStdString());
  computed_->setText(size.pixel_size_um ? words("= %1 µm per px").arg(readout::plain(*size.pixel_size_um).c_str())
                                        : words("= – µm per px"));
}

void CameraCard::write(StartForm& form) const {
  form.camera = value_of(*camera_);
  form.camera_profile = value_of(*profile_);
  form.objective = value_of(*objective_);
  form.camera_pixel_um = camera_pixel_->text().toStdString();
  form.specimen_pixel_um = specimen_pixel_->text().toStdString();
}

bool CameraCard::show_problem(const StartProblem& problem) {
  CardField* field = problem.field == StartField::kCamera          ? camera_field_
                     : problem.field == StartField::kCameraPixel   ? camera_pixel_field_
                     : problem.field == StartField::kSpecimenPixel ? specimen_pixel_field_
                                                                   : nullptr;
  return point_at(field, problem.text);
}

void CameraCard::clear_problems() {
  for (CardField* field : {camera_field_, camera_pixel_field_, specimen_pixel_field_}) field->show_problem({});
}

}  // namespace pellucida
