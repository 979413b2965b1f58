#include "widgets/ScaleDialog.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "Words.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/identification/Aspiration.h"
#include "presenters/ScalePresenter.h"

namespace pellucida {
namespace {

constexpr int kTextWidth_px = 440, kRow_px = 26;
constexpr double kMostEntered = 1e5;

// "uN/um" as people write it.
QString shown_unit(std::string_view unit) {
  QString text = QString::fromUtf8(unit.data(), static_cast<int>(unit.size()));
  return text.replace("uN", "µN").replace("um", "µm");
}

}  // namespace

ScaleDialog::ScaleDialog(const CellProfile& profile, const ScaleMeasurement& seen, bool has_own_scale, Actions actions,
                         QWidget* parent)
    : QDialog(parent), profile_(profile), actions_(std::move(actions)) {
  setObjectName("scaleDialog");
  setWindowTitle(words("Scale of this cell"));
  auto* column = new QVBoxLayout(this);
  auto* text = new QLabel(
      words("The picture shows shapes, not how stiff this cell is. One measurement makes all forces its own. "
            "Several add up."));
  text->setObjectName("pageText");
  text->setWordWrap(true);
  column->addWidget(text);
  pages_ = new QTabWidget;
  pages_->setObjectName("scalePages");
  column->addWidget(pages_);
  boxes_.resize(scale_forms().size());
  for (std::size_t form = 0; form < scale_forms().size(); ++form) {
    pages_->addTab(make_page(form, seen), QString::fromStdString(scale_forms()[form].title));
  }
  problem_ = new QLabel;
  problem_->setObjectName("scaleProblem");
  problem_->setWordWrap(true);
  problem_->setMinimumHeight(2 * problem_->fontMetrics().height());
  column->addWidget(problem_);
  auto* buttons = new QDialogButtonBox;
  measure_ = buttons->addButton(words("Use this measurement"), QDialogButtonBox::AcceptRole);
  measure_->setObjectName("scaleMeasure");
  QPushButton* forget = buttons->addButton(words("Back to its kind"), QDialogButtonBox::ResetRole);
  forget->setObjectName("scaleForget");
  forget->setToolTip(words("Forget this cell's own scale: for another cell"));
  forget->setEnabled(has_own_scale);
  buttons->addButton(QDialogButtonBox::Cancel);
  connect(measure_, &QPushButton::clicked, this, [this] { measure(); });
  connect(forget, &QPushButton::clicked, this, [this] {
    actions_.forget();
    accept();
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
}

QWidget* ScaleDialog::make_page(std::size_t form, const ScaleMeasurement& seen) {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  auto* text = new QLabel(QString::fromStdString(scale_forms()[form].explanation));
  text->setObjectName("pageText");
  text->setWordWrap(true);
  text->setMinimumWidth(kTextWidth_px);
  column->addWidget(text);
  auto* rows = new QFormLayout;
  rows->setLabelAlignment(Qt::AlignVCenter);
  rows->setVerticalSpacing(8);
  rows->setHorizontalSpacing(14);
  column->addLayout(rows);
  column->addStretch(1);
  ScaleMeasurement values = seen;
  const FieldList fields = fields_of(values);
  for (const auto& [key, label] : scale_forms()[form].rows) {
    const FieldPlace& field = *fields.find(key);
    auto* box = new QDoubleSpinBox;
    box->setObjectName(QString::fromStdString(scale_forms()[form].title + "_" + key));
    box->setDecimals(3);
    box->setRange(0.0, std::min(field.range.high, kMostEntered));
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setSuffix(" " + shown_unit(field.unit));
    box->setValue(*std::get<double*>(field.value));
    box->setToolTip(QString::fromUtf8(field.doc.data(), static_cast<int>(field.doc.size())));
    box->setMinimumHeight(kRow_px);
    auto* name = new QLabel(words(label.c_str()));
    name->setObjectName("nodeFact");
    rows->addRow(name, box);
    boxes_[form][key] = box;
  }
  return page;
}

ScaleMeasurement ScaleDialog::entered() const {
  ScaleMeasurement measurement;
  const FieldList fields = fields_of(measurement);
  for (const auto& [key, box] : boxes_[static_cast<std::size_t>(pages_->currentIndex())]) {
    *std::get<double*>(fields.find(key)->value) = box->value();
  }
  return measurement;
}

void ScaleDialog::measure() {
  if (task_.running()) return;
  try {
    const ScaleMeasurement measurement = entered();
    if (way_of(measurement) != ScaleWay::kAspiration) return take(measurement);
    problem_->setText(words("Finite elements of the aspirated zona …"));
    measure_->setEnabled(false);
    task_.run(
        [this, measurement, profile = profile_](const BackgroundTask::Control&) -> std::function<void()> {
          const ScaleMeasurement whole = with_modulus(measurement, profile);
          return [this, whole] { take(whole); };
        },
        {}, [this](const std::string& text) { show_problem(text); });
  } catch (const Error& error) {
    show_problem(say_message(error.what()));
  }
}

void ScaleDialog::take(const ScaleMeasurement& measurement) {
  try {
    actions_.measured(measurement);
    accept();
  } catch (const Error& error) {
    show_problem(say_message(error.what()));
  }
}

void ScaleDialog::show_problem(const std::string& text) {
  measure_->setEnabled(true);
  problem_->setText(QString::fromStdString(text));
}

}  // namespace pellucida
