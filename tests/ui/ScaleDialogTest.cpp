#include "widgets/ScaleDialog.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>

#include "pellucida/core/Error.h"
#include "presenters/ScalePresenter.h"
#include "ui/OffscreenWidgets.h"
#include "widgets/ReadoutBar.h"

namespace pellucida {
namespace {

class ScaleDialogTest : public test::OffscreenWidgets {
 protected:
  ScaleDialog::Actions actions() {
    return {[this](const ScaleMeasurement& measurement) { taken_.push_back(measurement); }, [this] { ++forgotten_; }};
  }
  template <class Widget>
  static Widget* part(QWidget& parent, const char* name) {
    auto* widget = parent.findChild<Widget*>(name);
    EXPECT_TRUE(widget) << name;
    return widget;
  }

  const CellProfile profile_ = load_profile("mouse-oocyte");
  std::vector<ScaleMeasurement> taken_;
  int forgotten_ = 0;
};

TEST_F(ScaleDialogTest, APushIsTakenAndAnIncompleteOneIsNamed) {
  ScaleMeasurement seen;
  seen.at_indentation_um = 6.5;
  ScaleDialog dialog(profile_, seen, false, actions(), nullptr);
  EXPECT_EQ(part<QDoubleSpinBox>(dialog, "Push_at_indentation_um")->value(), 6.5);
  EXPECT_FALSE(part<QPushButton>(dialog, "scaleForget")->isEnabled());
  part<QPushButton>(dialog, "scaleMeasure")->click();
  EXPECT_TRUE(taken_.empty());
  EXPECT_NE(part<QLabel>(dialog, "scaleProblem")->text(), "");
  part<QDoubleSpinBox>(dialog, "Push_known_force_uN")->setValue(0.9);
  part<QPushButton>(dialog, "scaleMeasure")->click();
  ASSERT_EQ(taken_.size(), 1U);
  EXPECT_EQ(way_of(taken_[0]), ScaleWay::kForce);
  EXPECT_EQ(taken_[0].known_force_uN, 0.9);
  EXPECT_EQ(taken_[0].at_indentation_um, 6.5);
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
}

TEST_F(ScaleDialogTest, AFibreHasAPageOfItsOwn) {
  ScaleDialog dialog(profile_, {}, true, actions(), nullptr);
  part<QTabWidget>(dialog, "scalePages")->setCurrentIndex(1);
  part<QDoubleSpinBox>(dialog, "Fibre_fibre_stiffness_uN_per_um")->setValue(0.05);
  part<QDoubleSpinBox>(dialog, "Fibre_fibre_deflection_um")->setValue(10.0);
  part<QDoubleSpinBox>(dialog, "Fibre_at_indentation_um")->setValue(5.0);
  part<QPushButton>(dialog, "scaleMeasure")->click();
  ASSERT_EQ(taken_.size(), 1U);
  EXPECT_EQ(push_of(taken_[0]).known_force_uN, 0.5);
  part<QPushButton>(dialog, "scaleForget")->click();
  EXPECT_EQ(forgotten_, 1);
}

TEST_F(ScaleDialogTest, AnAspirationComesWithItsModulus) {
  ScaleMeasurement seen;
  seen.zona_thickness_um = 5.0;
  ScaleDialog dialog(profile_, seen, false, actions(), nullptr);
  part<QTabWidget>(dialog, "scalePages")->setCurrentIndex(2);
  part<QDoubleSpinBox>(dialog, "Aspiration_suction_kPa")->setValue(20.0);
  part<QDoubleSpinBox>(dialog, "Aspiration_tongue_um")->setValue(4.0);
  part<QDoubleSpinBox>(dialog, "Aspiration_mouth_radius_um")->setValue(10.0);
  part<QPushButton>(dialog, "scaleMeasure")->click();
  EXPECT_FALSE(part<QPushButton>(dialog, "scaleMeasure")->isEnabled());
  QElapsedTimer clock;
  clock.start();
  while (taken_.empty() && clock.elapsed() < 120000) QApplication::processEvents(QEventLoop::AllEvents, 50);
  ASSERT_EQ(taken_.size(), 1U);
  EXPECT_GT(taken_[0].modulus_kPa, 50.0);
  EXPECT_GT(taken_[0].modulus_sigma_percent, 5.0);
  EXPECT_NEAR(taken_[0].modulus_of_profile_ratio, 1.28, 0.06);
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
}

TEST_F(ScaleDialogTest, TheBarShowsTheGauge) {
  ReadoutBar bar(nullptr);
  bar.show_scale({.text = {"±8 %"}, .kind_sigma = 0.46, .ratio = 1.2, .sigma = 0.08, .is_own = true});
  EXPECT_EQ(part<QLabel>(bar, "scale")->text(), "±8 %");
  EXPECT_TRUE(bar.findChild<QWidget*>("scaleGauge"));
}

}  // namespace
}  // namespace pellucida
