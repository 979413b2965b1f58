// What the lesson on snakes says in numbers, computed on the picture that it shows, against the virtual cell's truth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "SnakePicture.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pellucida/teaching/KassSnake.h"
#include "pellucida/teaching/Lesson.h"

namespace pellucida {
namespace {

class SnakeLessonTest : public testing::Test {
 protected:
  SnakeLessonTest() {
    const auto microscope = open_virtual("default");
    for (int k = 0; k < 60; ++k) microscope->skip();
    microscope->next();
    inner_um_ = microscope->truth().observation.inner->points_um;
    outer_um_ = microscope->truth().observation.outer->points_um;
    tip_um_ = microscope->truth().observation.needle->tip_um;
  }

  // To its end, or as far as the window runs it.
  KassSnake run(const SnakeSetting& setting) {
    const auto picture =
        step_.process({setting.picture, setting.time_s, setting.parameters.blur_px, setting.parameters.attraction});
    pixel_um_ = (*picture)->pixel_size_um;
    KassSnake snake(setting.parameters);
    snake.set_field((*picture)->field);
    snake.start(Eigen::Vector2d(setting.start_x_um, setting.start_y_um) / pixel_um_,
                setting.start_radius_um / pixel_um_);
    while (snake.state() == SnakeState::kMoving && snake.iteration() < 3000 && snake.step()) {
    }
    return snake;
  }
  // RMS distance of its points to a contour, um.
  double off_um(const KassSnake& snake, const Contour_um& contour) const {
    const Eigen::Matrix2Xd points_um = pixel_um_ * snake.points_px();
    double squares = 0.0;
    for (Eigen::Index i = 0; i < points_um.cols(); ++i) {
      squares += (contour.colwise() - points_um.col(i)).colwise().squaredNorm().minCoeff();
    }
    return std::sqrt(squares / static_cast<double>(points_um.cols()));
  }
  // How far the snake stays from the bottom of the dimple, um.
  double cut_um(const KassSnake& snake) const {
    const Contour_um snake_um = pixel_um_ * snake.points_px();
    double deepest = 1e9;
    Eigen::Index at = 0;
    for (Eigen::Index i = 0; i < inner_um_.cols(); ++i) {
      const double d = (inner_um_.col(i) - tip_um_).norm();
      if (d >= deepest) continue;
      deepest = d;
      at = i;
    }
    return (snake_um.colwise() - inner_um_.col(at)).colwise().norm().minCoeff();
  }

  SnakePictureStep step_;
  Contour_um inner_um_, outer_um_;
  Eigen::Vector2d tip_um_;
  double pixel_um_ = 1.0;
};

TEST_F(SnakeLessonTest, TheLessonsSnakeFindsTheMembraneAndItsDimple) {
  const SnakeSetting setting = load_lesson("what-a-snake-does").snake;
  const KassSnake snake = run(setting);
  EXPECT_EQ(snake.state(), SnakeState::kConverged);
  EXPECT_NEAR(snake.iteration(), 220, 15);
  EXPECT_NEAR(off_um(snake, inner_um_), 0.3, 0.05);
  EXPECT_LT(cut_um(snake), 1.0);
}

TEST_F(SnakeLessonTest, TooStiffRoundsTheDimpleOrDoesNotReachIt) {
  SnakeSetting setting;
  setting.parameters.beta = 120.0;
  const KassSnake stiff = run(setting);
  EXPECT_EQ(stiff.state(), SnakeState::kConverged);
  EXPECT_NEAR(off_um(stiff, inner_um_), 4.6, 0.5);
  setting.parameters.beta = 300.0;
  const KassSnake stiffer = run(setting);
  EXPECT_EQ(stiffer.state(), SnakeState::kConverged);
  EXPECT_GT(cut_um(stiffer), 5.0);
  EXPECT_NEAR(std::sqrt(enclosed_area_px2(stiffer.points_px()) / std::numbers::pi) * pixel_um_, setting.start_radius_um,
              2.0);
}

TEST_F(SnakeLessonTest, TooLongAStepLosesIt) {
  SnakeSetting setting;
  setting.parameters.gamma = 0.05;
  EXPECT_EQ(run(setting).state(), SnakeState::kLeftPicture);
}

TEST_F(SnakeLessonTest, TooWeakAPushIsCaughtByTheGrain) {
  SnakeSetting setting;
  setting.parameters.balloon = 0.03;
  const KassSnake weak = run(setting);
  EXPECT_EQ(weak.state(), SnakeState::kConverged);
  EXPECT_NEAR(weak.iteration(), 1540, 150);
  EXPECT_NEAR(off_um(weak, inner_um_), 9.0, 0.5);
}

TEST_F(SnakeLessonTest, FromOutsideItRestsOnTheOuterMembrane) {
  SnakeSetting setting;
  setting.start_radius_um = 58.0;
  setting.parameters.balloon = 0.0;
  const KassSnake outside = run(setting);
  EXPECT_EQ(outside.state(), SnakeState::kConverged);
  EXPECT_NEAR(outside.iteration(), 1800, 400);
  EXPECT_LT(off_um(outside, outer_um_), 0.6);
}

TEST_F(SnakeLessonTest, APictureThatIsNotThereIsSaid) {
  const auto picture = step_.process({"no-such-recording", 0.0, 1.0, "dark-lines"});
  EXPECT_NE((*picture)->fault.find("no-such-recording"), std::string::npos);
  EXPECT_FALSE((*picture)->field);
}

}  // namespace
}  // namespace pellucida
