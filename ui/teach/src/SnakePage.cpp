#include "SnakePage.h"

#include <QComboBox>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "FileChoice.h"
#include "Words.h"
#include "pellucida/teaching_vtk/OutlineStyle.h"
#include "widgets/ButtonKey.h"
#include "widgets/FigureBar.h"
#include "widgets/KeySheet.h"
#include "widgets/Panel.h"
#include "widgets/ParameterSlider.h"
#include "widgets/SidePage.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr double kFramed_ratio = 1.15;  // of the circle at the start, at least the lesson's cell
constexpr double kLeastFramed_um = 58.0;
constexpr double kRimReach_px = 9.0;
// Of a picture's smaller side, where no lesson says where to begin.
constexpr double kFirstRadius_ratio = 0.2;

struct ShippedPicture {
  const char* name;
  const char* source;
  double time_s;
};
constexpr ShippedPicture kShippedPictures[] = {{PELLUCIDA_WORDS("Cell at rest"), "virtual:default", 0.0},
                                               {PELLUCIDA_WORDS("Cell with a dimple"), "virtual:default", 2.0},
                                               {PELLUCIDA_WORDS("Cell with a deep dimple"), "virtual:default", 4.8},
                                               {PELLUCIDA_WORDS("Poor camera, a dimple"), "virtual:noisy", 2.0}};

}  // namespace

SnakePage::SnakePage()
    : picture_stage_(
          picture_step_, orders_, [this](SnakePicturePtr picture) { pictures_.publish(std::move(picture)); }, clock_) {
  picture_stage_.start();
}

SnakePage::~SnakePage() {
  picture_stage_.stop();
}

QWidget* SnakePage::make_figures() {
  figures_ = new FigureBar(words("Left the picture"),
                           {{"snakeStep", words("STEP"), "0000", {}, true},
                            {"snakeEnergy", words("ENERGY"), "-000.00", {}, true},
                            {"snakeStretching", words("STRETCHING"), "000.00", {}, false},
                            {"snakeBending", words("BENDING"), "000.00", {}, false},
                            {"snakeImage", words("IMAGE"), "-000.00", {}, false},
                            {"snakeBalloon", words("BALLOON"), "-000.00", {}, false},
                            {"snakeMotion", words("FARTHEST MOVE"), "00.000 px", {}, false}},
                           nullptr);
  return figures_;
}

QWidget* SnakePage::make_stage() {
  view_widget_ = new ViewWidget(view_, 0, nullptr);
  view_widget_->setObjectName("snake");
  view_widget_->setAccessibleName(words("Snake"));
  vtkNew<OutlineStyle> style;
  style->pressed = [this](int x_px, int y_px) { press(x_px, y_px); };
  style->dragged = [this](int x_px, int y_px) { drag(x_px, y_px); };
  view_widget_->set_style(style);
  explain_gesture(*view_widget_, words("Drag"), words("Move the circle, or its rim; elsewhere place it"));
  explain_gesture(*view_widget_, words("Right drag, wheel"), words("Move the image, zoom"));
  auto* panel = new pellucida::Panel(words("Snake"), view_widget_, nullptr);
  QObject::connect(panel->add_button(words("Step"), words("One step"), Qt::Key_S), &QToolButton::clicked, panel,
                   [this] {
                     run(false);
                     step();
                   });
  run_button_ =
      panel->add_toggle(words("Run"), words("Steps until it rests, or until it is stopped"), Qt::Key_R, false);
  run_button_->setObjectName("runSnake");
  QObject::connect(run_button_, &QToolButton::toggled, panel, [this](bool on) { run(on); });
  QObject::connect(panel->add_button(words("Reset"), tip_with_key(words("Back to the first point of view"), Qt::Key_V)),
                   &QToolButton::clicked, panel, [this] { reset_view(); });

  constexpr int kSamples = 4;
  chart_widget_ = new ViewWidget(chart_, kSamples, nullptr);
  chart_widget_->setAccessibleName(words("Energy over steps"));
  return view_over_chart(panel, new pellucida::Panel(words("Energy over steps"), chart_widget_, nullptr));
}

QWidget* SnakePage::make_side() {
  auto* page = new SidePage(nullptr);
  picture_choice_ =
      page->add_choice(words("Picture"), "pictureChoice", words("Of the virtual microscope, or recorded"));
  for (const ShippedPicture& picture : kShippedPictures) picture_choice_->addItem(words(picture.name));
  picture_choice_->addItem(words("A recorded session \u2026"));
  QObject::connect(picture_choice_, qOverload<int>(&QComboBox::activated), page,
                   [this](int index) { choose_picture(index); });
  ask_recording = [page] { return dialogs_over(*page->window()).session(words("Choose a session")); };
  const auto add = [&](SnakeSlider which) {
    auto*& slider = sliders_[static_cast<std::size_t>(which)];
    slider = new ParameterSlider(
        snake_scale(which), [this, which](double value) { change(which, value); }, page);
    page->add(slider);
  };
  add(SnakeSlider::kMoment);
  fault_ = new QLabel(page);
  fault_->setObjectName("pictureFault");
  fault_->setWordWrap(true);
  fault_->hide();
  page->add(fault_);
  attraction_ =
      page->add_choice(words("Drawn to"), "attractionChoice", words("What has the least energy in the image"));
  attraction_->addItem(words("Dark lines"), "dark-lines");
  attraction_->addItem(words("Edges"), "edges");
  QObject::connect(attraction_, qOverload<int>(&QComboBox::activated), page, [this] {
    setting_.parameters.attraction = attraction_->currentData().toString().toStdString();
    order_picture();
  });
  for (const SnakeSlider which : {SnakeSlider::kAlpha, SnakeSlider::kBeta, SnakeSlider::kGamma, SnakeSlider::kBalloon,
                                  SnakeSlider::kBlur, SnakeSlider::kRadius, SnakeSlider::kPace}) {
    add(which);
  }
  page->end();
  return scrolled(page);
}

void SnakePage::begin(const Lesson& lesson) {
  setting_ = lesson.snake;
  snake_.set_parameters(setting_.parameters);
  order_picture();
  show_controls();
  restart();
  reset_view();
}

void SnakePage::show_controls() {
  const SnakeParameters& p = setting_.parameters;
  for (const auto& [which, value] :
       {std::pair(SnakeSlider::kAlpha, p.alpha), std::pair(SnakeSlider::kBeta, p.beta),
        std::pair(SnakeSlider::kGamma, p.gamma), std::pair(SnakeSlider::kBalloon, p.balloon),
        std::pair(SnakeSlider::kBlur, p.blur_px), std::pair(SnakeSlider::kRadius, setting_.start_radius_um),
        std::pair(SnakeSlider::kMoment, setting_.time_s), std::pair(SnakeSlider::kPace, steps_per_s_)}) {
    slider(which).show_value(value);
  }
  attraction_->setCurrentIndex(attraction_->findData(QString::fromStdString(p.attraction)));
  const auto* shipped =
      std::find_if(std::begin(kShippedPictures), std::end(kShippedPictures), [&](const ShippedPicture& one) {
        return one.source == setting_.picture && std::abs(one.time_s - setting_.time_s) < 1e-3;
      });
  // Another moment or another film: of none of the names.
  picture_choice_->setCurrentIndex(
      shipped == std::end(kShippedPictures) ? -1 : static_cast<int>(shipped - std::begin(kShippedPictures)));
}

void SnakePage::choose_picture(int index) {
  if (index < static_cast<int>(std::size(kShippedPictures))) {
    setting_.picture = kShippedPictures[index].source;
    setting_.time_s = kShippedPictures[index].time_s;
  } else {
    const std::filesystem::path folder = ask_recording();
    if (!folder.empty()) {
      setting_.picture = folder.string();
      setting_.time_s = 0.0;
    }
  }
  show_controls();
  order_picture();
}

void SnakePage::change(SnakeSlider which, double value) {
  SnakeParameters& p = setting_.parameters;
  switch (which) {
    case SnakeSlider::kAlpha:
      p.alpha = value;
      break;
    case SnakeSlider::kBeta:
      p.beta = value;
      break;
    case SnakeSlider::kGamma:
      p.gamma = value;
      break;
    case SnakeSlider::kBalloon:
      p.balloon = value;
      break;
    case SnakeSlider::kBlur:
      p.blur_px = value;
      order_picture();
      break;
    case SnakeSlider::kRadius:
      setting_.start_radius_um = value;
      restart();
      break;
    case SnakeSlider::kMoment:
      setting_.time_s = value;
      order_picture();
      break;
    case SnakeSlider::kPace:
      steps_per_s_ = value;
      return;
  }
  snake_.set_parameters(p);
  shown_changed_ = true;
}

void SnakePage::order_picture() {
  orders_.publish({setting_.picture, setting_.time_s, setting_.parameters.blur_px, setting_.parameters.attraction});
}

void SnakePage::take_picture() {
  const auto newest = pictures_.peek().value_or(nullptr);
  if (!newest || newest == picture_) return;
  const bool other_source = picture_ && picture_->order.source != newest->order.source;
  picture_ = newest;
  fault_->setText(QString::fromStdString(say_message(newest->fault)));
  fault_->setVisible(!newest->fault.empty());
  view_.set_empty_text(newest->fault.empty() ? say("Preparing the picture") : say("No picture"));
  view_.set_picture(newest->image);
  if (!newest->fault.empty()) {
    snake_.set_field(nullptr);
    return;
  }
  const double width_um = newest->field->width_px() * newest->pixel_size_um;
  const double height_um = newest->field->height_px() * newest->pixel_size_um;
  if (setting_.start_x_um >= width_um || setting_.start_y_um >= height_um) {
    setting_.start_x_um = 0.5 * width_um;
    setting_.start_y_um = 0.5 * height_um;
    setting_.start_radius_um = kFirstRadius_ratio * std::min(width_um, height_um);
  }
  snake_.set_field(newest->field);
  NumberScale moment = snake_scale(SnakeSlider::kMoment);
  moment.high = std::max(newest->duration_s, 0.1);
  slider(SnakeSlider::kMoment).set_scale(moment);
  slider(SnakeSlider::kMoment).show_value(setting_.time_s);
  if (energies_.empty() || other_source || snake_.iteration() == 0) restart();
  if (setting_.runs && snake_.iteration() == 0) run(true);
  reset_view();
}

void SnakePage::set_shown(bool shown) {
  if (!shown) run(false);
  // Opened by hand, without a lesson of its own.
  if (shown && !orders_.peek()) begin(Lesson{});
  shown_changed_ = true;
}

Eigen::Vector2d SnakePage::start_px() const {
  return Eigen::Vector2d(setting_.start_x_um, setting_.start_y_um) / picture_->pixel_size_um;
}

void SnakePage::restart() {
  run(false);
  energies_.clear();
  shown_changed_ = true;
  if (!picture_ || !picture_->field) return;
  snake_.start(start_px(), setting_.start_radius_um / picture_->pixel_size_um);
  record();
}

void SnakePage::run(bool on) {
  running_ = on && picture_ && picture_->field;
  owed_steps_ = 1.0;
  run_since_s_ = clock_.now_s();
  if (run_button_ && run_button_->isChecked() != running_) run_button_->setChecked(running_);
  shown_changed_ = true;
}

void SnakePage::step() {
  if (!snake_.step()) {
    run(false);
    return;
  }
  record();
}

void SnakePage::record() {
  energies_.push_back(snake_.energy());
  shown_changed_ = true;
}

void SnakePage::tick() {
  picture_stage_.rethrow();
  take_picture();
  if (running_) {
    const double now_s = clock_.now_s();
    // A window that was busy doesn't catch up.
    owed_steps_ = std::min(owed_steps_ + steps_per_s_ * (now_s - run_since_s_), std::max(1.0, 0.1 * steps_per_s_));
    run_since_s_ = now_s;
    for (; running_ && owed_steps_ >= 1.0; owed_steps_ -= 1.0) {
      step();
      if (snake_.state() != SnakeState::kMoving || snake_.iteration() >= kMostSteps) run(false);
    }
  }
  if (shown_changed_) {
    show_snake();
  } else {
    view_widget_->render();
  }
}

void SnakePage::show_newest() {
  take_picture();
  show_snake();
}

void SnakePage::show_snake() {
  shown_changed_ = false;
  const bool has_picture = picture_ && picture_->field;
  const SnakeTexts texts =
      snake_texts(snake_, has_picture, running_, snake_.iteration() >= kMostSteps, current_theme());
  figures_->show_state(texts.state);
  figures_->show_figures(texts.figures);
  if (has_picture) {
    view_.set_start({setting_.start_x_um, setting_.start_y_um}, setting_.start_radius_um);
    view_.set_snake(picture_->pixel_size_um * snake_.points_px());
  }
  CurveChartData data;
  data.x_title = words("Step");
  data.y_title = words("Energy");
  data.curve_name = words("internal");
  data.other_name = words("external");
  NamedCurve sum{words("sum"), {}, CurveRole::kFaintReference};
  for (std::size_t k = 0; k < energies_.size(); ++k) {
    data.curve.add(static_cast<double>(k), energies_[k].internal());
    data.other.add(static_cast<double>(k), energies_[k].external());
    sum.curve.add(static_cast<double>(k), energies_[k].total());
  }
  data.named.push_back(std::move(sum));
  if (energies_.size() < 2) {
    data = CurveChartData{.x_title = words("Step"), .y_title = words("Energy")};
    data.empty_text = words("S: one step. R: run.");
  }
  chart_.set_data(std::move(data));
  view_widget_->render();
  chart_widget_->render();
}

// The circle's middle moves it, its rim changes its size, and elsewhere it is put.
void SnakePage::press(int x_px, int y_px) {
  const Eigen::Vector2d at_um = view_.place_on_picture_um(x_px, y_px);
  const Eigen::Vector2d center_um(setting_.start_x_um, setting_.start_y_um);
  const double away_um = (at_um - center_um).norm();
  const bool on_rim = std::abs(away_um - setting_.start_radius_um) < kRimReach_px * view_.um_per_px();
  grip_ = on_rim ? Grip::kSize : Grip::kMove;
  grip_offset_um_ = away_um < setting_.start_radius_um ? Eigen::Vector2d(center_um - at_um) : Eigen::Vector2d::Zero();
  drag(x_px, y_px);
}

void SnakePage::drag(int x_px, int y_px) {
  const Eigen::Vector2d at_um = view_.place_on_picture_um(x_px, y_px);
  if (grip_ == Grip::kSize) {
    const NumberScale scale = snake_scale(SnakeSlider::kRadius);
    const double radius_um = (at_um - Eigen::Vector2d(setting_.start_x_um, setting_.start_y_um)).norm();
    setting_.start_radius_um = std::clamp(radius_um, scale.low, scale.high);
    slider(SnakeSlider::kRadius).show_value(setting_.start_radius_um);
  } else {
    setting_.start_x_um = std::max(0.0, at_um.x() + grip_offset_um_.x());
    setting_.start_y_um = std::max(0.0, at_um.y() + grip_offset_um_.y());
  }
  restart();
}

void SnakePage::nudge(double right_um, double up_um) {
  setting_.start_x_um = std::max(0.0, setting_.start_x_um + right_um);
  setting_.start_y_um = std::max(0.0, setting_.start_y_um - up_um);
  restart();
}

void SnakePage::reset_view() {
  view_.frame_place({setting_.start_x_um, setting_.start_y_um},
                    std::max(kFramed_ratio * setting_.start_radius_um, kLeastFramed_um));
  shown_changed_ = true;
}

void SnakePage::set_type_scale(double scale) {
  for (ViewWidget* widget : {view_widget_, chart_widget_}) {
    widget->set_type_scale(scale);
    widget->render();
  }
}

}  // namespace pellucida
