#pragma once
#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "SnakePicture.h"
#include "TeachPage.h"
#include "pellucida/charts_vtk/CurveChart.h"
#include "pellucida/core/Clock.h"
#include "pellucida/core/SharedLatest.h"
#include "pellucida/core/Stage.h"
#include "pellucida/teaching/KassSnake.h"
#include "pellucida/teaching_vtk/SnakeView.h"
#include "presenters/SnakePresenter.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace pellucida {

class FigureBar;
class ParameterSlider;
class ViewWidget;

/// A snake on a picture: one step, a run, its energies, its parameters. The picture is prepared on a thread of its own.
class SnakePage : public TeachPage {
 public:
  /// Steps after which a snake that runs is stopped.
  static constexpr int kMostSteps = 3000;

  SnakePage();
  ~SnakePage() override;

  const KassSnake& snake() const noexcept { return snake_; }
  const SnakeSetting& setting() const noexcept { return setting_; }
  const SnakePicturePtr& picture() const noexcept { return picture_; }
  const SnakeView& view() const noexcept { return view_; }
  ViewWidget& view_widget() noexcept { return *view_widget_; }
  const CurveChartData& chart_data() const noexcept { return chart_.data(); }
  ParameterSlider& slider(SnakeSlider which) { return *sliders_[static_cast<std::size_t>(which)]; }
  /// How the folder of a recording is asked for; a test answers in a person's stead.
  std::function<std::filesystem::path()> ask_recording;

  bool is_running() const noexcept { return running_; }

  QWidget* make_figures() override;
  QWidget* make_stage() override;
  QWidget* make_side() override;
  void begin(const Lesson& lesson) override;
  void set_shown(bool shown) override;
  void tick() override;
  void show_newest() override;
  void restart() override;
  void nudge(double right_um, double up_um) override;
  void reset_view() override;
  void set_type_scale(double scale) override;

 private:
  void show_controls();
  void change(SnakeSlider which, double value);
  void order_picture();
  void take_picture();
  void choose_picture(int index);
  void run(bool on);
  void step();
  void record();
  void show_snake();
  void press(int x_px, int y_px);
  void drag(int x_px, int y_px);
  Eigen::Vector2d start_px() const;

  SnakeSetting setting_;
  KassSnake snake_;
  std::vector<SnakeEnergy> energies_;  // one a step, the start's first
  bool running_ = false;
  double steps_per_s_ = 20.0;
  double owed_steps_ = 0.0;
  double run_since_s_ = 0.0;

  SteadyClock clock_;
  SharedLatest<SnakePictureOrder> orders_;
  SharedLatest<SnakePicturePtr> pictures_;
  SnakePictureStep picture_step_;
  Stage<SnakePictureStep, SharedLatest<SnakePictureOrder>> picture_stage_;
  SnakePicturePtr picture_;

  SnakeView view_;
  CurveChart chart_;
  bool shown_changed_ = true;
  enum class Grip { kMove, kSize } grip_ = Grip::kMove;
  Eigen::Vector2d grip_offset_um_ = Eigen::Vector2d::Zero();

  FigureBar* figures_ = nullptr;
  ViewWidget* view_widget_ = nullptr;
  ViewWidget* chart_widget_ = nullptr;
  QToolButton* run_button_ = nullptr;
  QComboBox* picture_choice_ = nullptr;
  QComboBox* attraction_ = nullptr;
  QLabel* fault_ = nullptr;
  std::array<ParameterSlider*, kSnakeSliderCount> sliders_{};
};

}  // namespace pellucida
