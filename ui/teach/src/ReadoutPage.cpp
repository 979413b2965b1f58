#include "ReadoutPage.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QSplitter>
#include <QTabWidget>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "Words.h"
#include "pellucida/teaching_vtk/PokeStyle.h"
#include "widgets/ButtonKey.h"
#include "widgets/FigureBar.h"
#include "widgets/KeySheet.h"
#include "widgets/NodeForceTable.h"
#include "widgets/Panel.h"
#include "widgets/ParameterSlider.h"
#include "widgets/SidePage.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr std::size_t kEquilibriumFigure = 1, kPrescribedFigure = 2;
constexpr std::pair<const char*, const char*> kContours[] = {
    {PELLUCIDA_WORDS("A solid wall (finite elements)"), "finite-elements"},
    {PELLUCIDA_WORDS("The spring network itself"), "model"}};
constexpr std::pair<const char*, const char*> kLayings[] = {
    {PELLUCIDA_WORDS("At equal distances, as a snake's points"), "equal-distances"},
    {PELLUCIDA_WORDS("Where each piece really is"), "true-places"},
    {PELLUCIDA_WORDS("At the nearest place"), "nearest"}};

}  // namespace

ReadoutPage::ReadoutPage()
    : stage_(
          step_, orders_, [this](ReadoutPairPtr pair) { pairs_.publish(std::move(pair)); }, clock_),
      curve_stage_(
          curve_step_, curve_orders_, [this](ReadoutCurvesPtr curves) { curves_.publish(std::move(curves)); }, clock_) {
  // The scales are the same: each view has room for one.
  views_[0].show_scales(true, false);
  views_[1].show_scales(false, true);
  // Turned together.
  views_[1].renderer()->SetActiveCamera(views_[0].renderer()->GetActiveCamera());
  stage_.start();
  curve_stage_.start();
}

ReadoutPage::~ReadoutPage() {
  stage_.stop();
  curve_stage_.stop();
}

QWidget* ReadoutPage::make_figures() {
  figures_ = new FigureBar(words("Prescribed: wrong"),
                           {{"trueForce", words("TRUE FORCE"), "-00.00 µN", {}, true},
                            {"equilibriumForce", words("EQUILIBRIUM"), "-00.00 µN", "+000 %", true},
                            {"prescribedForce", words("PRESCRIBED"), "-00.00 µN", "-000 %", true},
                            {"seenDepth", words("DEPTH SEEN"), "00.00 µm", {}, false}},
                           nullptr);
  return figures_;
}

Panel* ReadoutPage::make_view(std::size_t which, const QString& title) {
  auto* widget = widgets_[which] = new ViewWidget(views_[which], 0, nullptr);
  widget->setObjectName(which == 0 ? "equilibriumView" : "prescribedView");
  widget->setAccessibleName(title);
  views_[which].set_hints({say("Click: forces on a node"), say("Drag: turn")});
  vtkNew<PokeStyle> style;
  style->turns_with_left = true;
  style->clicked = [this, which](int x_px, int y_px) { pick(which, x_px, y_px); };
  widget->set_style(style);
  explain_gesture(*widget, words("Click"), words("Forces on a node"));
  explain_gesture(*widget, words("Drag, wheel"), words("Turn both cells, zoom"));
  return new pellucida::Panel(title, widget, nullptr);
}

QWidget* ReadoutPage::make_stage() {
  auto* both = new QSplitter(Qt::Horizontal);
  both->setHandleWidth(4);
  both->setChildrenCollapsible(false);
  both->addWidget(make_view(0, words("In equilibrium")));
  auto* right = make_view(1, words("Every node prescribed"));
  both->addWidget(right);
  QObject::connect(right->add_button(words("Reset"), tip_with_key(words("Back to the first point of view"), Qt::Key_V)),
                   &QToolButton::clicked, right, [this] { reset_view(); });
  constexpr int kSamples = 4;
  widgets_[2] = new ViewWidget(chart_, kSamples, nullptr);
  widgets_[2]->setAccessibleName(words("Force over depth"));
  return view_over_chart(both, new pellucida::Panel(words("Force over depth"), widgets_[2], nullptr));
}

QWidget* ReadoutPage::make_side() {
  side_ = make_side_tabs();
  auto* page = new SidePage(nullptr);
  contour_ = page->add_choice(words("Whose contour"), "contourChoice", words("What the image shows"));
  for (const auto& [text, name] : kContours) contour_->addItem(words(text), QString(name));
  laying_ = page->add_choice(words("Where a node is laid on it"), "layingChoice",
                             words("The image shows where the membrane is, not which piece of it is where"));
  for (const auto& [text, name] : kLayings) laying_->addItem(words(text), QString(name));
  for (QComboBox* choice : {contour_, laying_}) {
    QObject::connect(choice, qOverload<int>(&QComboBox::activated), page, [this] {
      parameters_.contour = contour_->currentData().toString().toStdString();
      parameters_.laying = laying_->currentData().toString().toStdString();
      order();
    });
  }
  for (const ReadoutSlider which : {ReadoutSlider::kDepth, ReadoutSlider::kNoise, ReadoutSlider::kMesh}) {
    auto*& slider = sliders_[static_cast<std::size_t>(which)];
    slider = new ParameterSlider(
        readout_scale(which), [this, which](double value) { change(which, value); }, page);
    page->add(slider);
  }
  auto* again = new QPushButton(words("Other noise"), page);
  again->setObjectName("otherNoise");
  again->setFixedHeight(30);
  again->setFocusPolicy(Qt::TabFocus);
  bind_key(*again, Qt::Key_N, words("Draws the contour's errors anew"));
  QObject::connect(again, &QPushButton::clicked, page, [this] {
    parameters_.draw += 1.0;
    order();
  });
  page->add(again);
  page->add_note(
      words("Both read the same contour with the same springs. In equilibrium the contour says how deep the needle is, "
            "and the shape is the network's own; prescribed, every node is laid on the contour, and the connectors "
            "under the tip are read."));
  page->end();
  side_->addTab(scrolled(page), words("Contour"));
  force_table_ = new NodeForceTable(nullptr);
  QObject::connect(&force_table_->head_to_tail(), &QCheckBox::toggled, side_, [this](bool on) {
    for (PokedCellView& view : views_) view.set_head_to_tail(on);
  });
  side_->addTab(scrolled(force_table_), words("Node forces"));
  return side_;
}

void ReadoutPage::begin(const Lesson& lesson) {
  first_ = lesson.readouts;
  node_.reset();
  restart();
  side_->setCurrentIndex(0);
}

void ReadoutPage::restart() {
  parameters_ = first_;
  show_controls();
  order();
}

void ReadoutPage::show_controls() {
  slider(ReadoutSlider::kDepth).show_value(parameters_.depth_um);
  slider(ReadoutSlider::kNoise).show_value(parameters_.noise_um);
  slider(ReadoutSlider::kMesh).show_value(parameters_.mesh_frequency);
  contour_->setCurrentIndex(contour_->findData(QString::fromStdString(parameters_.contour)));
  laying_->setCurrentIndex(laying_->findData(QString::fromStdString(parameters_.laying)));
}

void ReadoutPage::change(ReadoutSlider which, double value) {
  switch (which) {
    case ReadoutSlider::kDepth:
      parameters_.depth_um = value;
      break;
    case ReadoutSlider::kNoise:
      parameters_.noise_um = value;
      break;
    case ReadoutSlider::kMesh:
      parameters_.mesh_frequency = static_cast<int>(value);
      node_.reset();
      break;
  }
  order();
}

void ReadoutPage::order() {
  orders_.publish({parameters_, node_});
  const auto ordered = curve_orders_.peek();
  if (!ordered || !have_same_curves(*ordered, parameters_)) curve_orders_.publish(parameters_);
}

void ReadoutPage::pick(std::size_t which, int x_px, int y_px) {
  explained_ = which;
  node_ = views_[which].node_at(x_px, y_px);
  if (node_) {
    side_->setCurrentIndex(1);
  } else {
    force_table_->show_hint();
  }
  order();
}

void ReadoutPage::set_shown(bool shown) {
  if (shown && !orders_.peek()) restart();
}

void ReadoutPage::take() {
  stage_.rethrow();
  curve_stage_.rethrow();
  if (const auto newest = pairs_.peek().value_or(nullptr); newest && newest != pair_) {
    pair_ = newest;
    show_pair();
  }
  ReadoutCurvesPtr curves = curves_.peek().value_or(nullptr);
  if (curves && !have_same_curves(curves->parameters, parameters_)) curves.reset();
  if (curves && curves != shown_curves_) {
    shown_curves_ = curves;
    show_curves(*curves);
  }
}

void ReadoutPage::tick() {
  take();
  for (ViewWidget* widget : widgets_) widget->render();
}

void ReadoutPage::show_newest() {
  take();
}

void ReadoutPage::show_pair() {
  const ComparisonTexts texts = comparison_texts(*pair_, current_theme());
  figures_->show_state(texts.state);
  figures_->show_figures(texts.figures);
  figures_->show_note(kEquilibriumFigure, texts.equilibrium_note);
  figures_->show_note(kPrescribedFigure, texts.prescribed_note);
  // On the same scales, which hold both.
  PokedCellView::Scales scales;
  for (const Readout* readout : {&pair_->equilibrium, &pair_->prescribed}) {
    const PokedCellView::Scales own = PokedCellView::scales_for(readout->shape);
    scales.pull_uN = std::max(scales.pull_uN, own.pull_uN);
    scales.field_uN = std::max(scales.field_uN, own.field_uN);
  }
  NiceRange pull_uN{0.001}, field_uN{0.001};
  views_[0].set_snapshot(std::make_shared<CellSnapshot>(pair_->equilibrium.shape));
  views_[1].set_snapshot(std::make_shared<CellSnapshot>(pair_->prescribed.shape));
  for (PokedCellView& view : views_)
    view.set_scales({{pull_uN.update(scales.pull_uN), field_uN.update(scales.field_uN)}});
  chart_.set_cursor(pair_->parameters.depth_um, pair_->prescribed.force_uN, true);
  const CellSnapshot& explained = explained_ == 0 ? pair_->equilibrium.shape : pair_->prescribed.shape;
  if (explained.node_forces) force_table_->show_forces(*explained.node_forces, current_theme());
}

void ReadoutPage::show_curves(const ReadoutCurves& curves) {
  CurveChartData data;
  data.x_title = words("Indentation (µm)");
  data.y_title = words("Force (µN)");
  data.curve_name = words("in equilibrium");
  data.other_name = words("prescribed");
  NamedCurve truth{words("true"), {}, CurveRole::kFaintReference};
  for (std::size_t k = 0; k < curves.depth_um.size(); ++k) {
    data.curve.add(curves.depth_um[k], curves.equilibrium_uN[k]);
    data.other.add(curves.depth_um[k], curves.prescribed_uN[k]);
    truth.curve.add(curves.depth_um[k], curves.true_uN[k]);
  }
  data.named.push_back(std::move(truth));
  data.x_end = 50.0;
  chart_.set_data(std::move(data));
}

void ReadoutPage::nudge(double right_um, double) {
  // The needle comes from the right.
  const NumberScale scale = readout_scale(ReadoutSlider::kDepth);
  parameters_.depth_um = std::clamp(parameters_.depth_um - right_um, scale.low, scale.high);
  show_controls();
  order();
}

void ReadoutPage::reset_view() {
  views_[0].reset_camera();
}

void ReadoutPage::set_type_scale(double scale) {
  for (ViewWidget* widget : widgets_) {
    widget->set_type_scale(scale);
    widget->render();
  }
}

}  // namespace pellucida
