// The real start page on an X server, driven by mouse and keys.
#include "StartWindow.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QToolButton>
#include <QUrl>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <random>

#include "Theme.h"
#include "Translation.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/visualization/Palette.h"
#include "review/TouchSession.h"
#include "support/Files.h"
#include "ui/DisplayTest.h"
#include "ui/TabStops.h"
#include "ui/XInput.h"
#include "widgets/RulerCanvas.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;
using test::XInput;
constexpr std::uint32_t kReturnKey = 0xff0d, kTabKey = 0xff09, kDownKey = 0xff54, kControlKey = 0xffe3, kQKey = 0x71,
                        kZeroKey = 0x30, kOneKey = 0x31;

class StartWindowTest : public test::DisplayTest {
 protected:
  StartWindowTest() {
    apply_theme(*qApp, dark_theme());
    options_.settings_file = folder_ / "start.ini";
    options_.sessions_folder = folder_ / "sessions";
    options_.cameras_listing = folder_ / "no cameras";
  }

  void open() {
    window_ = std::make_unique<StartWindow>(options_, [this](bool) { return answer_; });
    ASSERT_TRUE(activate(*window_)) << "not active";
    pass(100);
  }

  template <class Widget>
  Widget& child(const char* name) {
    auto* found = window_->findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << name;
    return *found;
  }

  void click(QWidget& widget) {
    const QPoint place = widget.mapToGlobal(widget.rect().center());
    input_.move(place.x(), place.y());
    pass(50);
    input_.left_button(true);
    pass(50);
    input_.left_button(false);
    pass(50);
  }
  // The start button of the card that holds a control.
  QPushButton& start_of(QWidget& control) {
    QWidget* card = &control;
    while (card && card->objectName() != "startCard") card = card->parentWidget();
    return *card->findChild<QPushButton*>("startRun");
  }

  void drop(const fs::path& path) {
    QMimeData dropped;
    dropped.setUrls({QUrl::fromLocalFile(QString::fromStdString(path.string()))});
    QDragEnterEvent enter({50, 50}, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &drop);
  }

  // The sentence below a control, when there is one.
  std::string problem_at(const char* control) {
    const auto* label = child<QWidget>(control).parentWidget()->findChild<QLabel*>("fieldProblem");
    return label && label->isVisible() ? label->text().toStdString() : "";
  }

  void choose(QComboBox& list, const char* value) {
    const int index = list.findData(QString(value));
    ASSERT_GE(index, 0) << value;
    list.setCurrentIndex(index);
  }

  TemporaryFolder folder_;
  StartOptions options_;
  fs::path answer_;
  XInput input_;
  std::unique_ptr<StartWindow> window_;
};

TEST_F(StartWindowTest, AScenarioIsChosenWithTheMouse) {
  open();
  auto& scenario = child<QComboBox>("scenario");
  choose(scenario, "puncture");
  choose(child<QComboBox>("hand"), "none");
  EXPECT_FALSE(window_->choice());
  click(start_of(scenario));
  ASSERT_TRUE(pass_until([&] { return !window_->isVisible(); }));
  ASSERT_TRUE(window_->choice());
  EXPECT_EQ(window_->choice()->source, "virtual:puncture");
  EXPECT_EQ(window_->choice()->hand, "none");
}

TEST_F(StartWindowTest, CardsAreChosenAndStartedWithKeys) {
  open();
  for (const int k : {3, 1, 2, 0}) {
    input_.tap(kOneKey + static_cast<std::uint32_t>(k));
    EXPECT_TRUE(pass_until([&] { return window_->current_card() == static_cast<StartCardId>(k); })) << k;
  }
  input_.tap(kOneKey + 3);
  ASSERT_TRUE(pass_until([&] { return window_->current_card() == StartCardId::kLesson; }));
  input_.tap(kTabKey);
  ASSERT_TRUE(pass_until([&] { return qApp->focusWidget() == &child<QListWidget>("lessons"); }));
  input_.tap(kDownKey);
  ASSERT_TRUE(pass_until([&] { return child<QListWidget>("lessons").currentRow() == 1; }));
  input_.tap(kReturnKey);
  ASSERT_TRUE(pass_until([&] { return window_->choice().has_value(); }));
  EXPECT_EQ(window_->choice()->mode, StartMode::kTeach);
  EXPECT_EQ(window_->choice()->lesson, "from-contour-to-3d");
}

TEST_F(StartWindowTest, ASessionDroppedOrClickedOpensReview) {
  test::write_touch(folder_ / "sessions" / "S");
  open();
  ASSERT_TRUE(pass_until([&] { return window_->findChild<QToolButton*>("recentSession") != nullptr; }));
  auto& recent = child<QToolButton>("recentSession");
  EXPECT_TRUE(recent.text().endsWith("2.90 s")) << recent.text().toStdString();
  // Its first image, not one colour.
  const QImage picture = recent.icon().pixmap(recent.iconSize()).toImage();
  bool varies = false;
  for (int x = 1; x < picture.width(); ++x) varies |= picture.pixel(x, 20) != picture.pixel(0, 20);
  EXPECT_TRUE(varies);
  click(recent);
  ASSERT_TRUE(pass_until([&] { return window_->choice().has_value(); }));
  EXPECT_EQ(window_->choice()->mode, StartMode::kReview);
  EXPECT_EQ(window_->choice()->session, (folder_ / "sessions" / "S").string());

  open();
  drop(folder_ / "sessions" / "S");
  ASSERT_TRUE(pass_until([&] { return window_->choice().has_value(); }));
  EXPECT_EQ(window_->choice()->mode, StartMode::kReview);
}

TEST_F(StartWindowTest, ABadPixelSizeIsRefusedAtItsField) {
  fs::create_directories(folder_ / "images");
  for (const char* name : {"f1.png", "f2.png"}) {
    ASSERT_TRUE(cv::imwrite((folder_ / "images" / name).string(), cv::Mat(48, 64, CV_8UC1, cv::Scalar(90))));
  }
  open();
  drop(folder_ / "images");
  auto& path = child<QLineEdit>("path");
  const auto* note = path.parentWidget()->findChild<QLabel*>("fieldNote");
  ASSERT_TRUE(pass_until([&] { return note->text().contains("pixel size not in the file"); }))
      << note->text().toStdString();
  EXPECT_EQ(window_->current_card(), StartCardId::kRecording);
  click(start_of(path));
  EXPECT_TRUE(problem_at("recordingPixel").find("does not state") != std::string::npos) << problem_at("recordingPixel");

  auto& pixel = child<QLineEdit>("recordingPixel");
  ASSERT_TRUE(pass_until([&] { return pixel.hasFocus(); }));
  input_.tap(kZeroKey);
  ASSERT_TRUE(pass_until([&] { return pixel.text() == "0"; }));
  input_.tap(kReturnKey);
  ASSERT_TRUE(pass_until([&] { return problem_at("recordingPixel").find("0.001 to 100 µm") != std::string::npos; }));
  EXPECT_FALSE(window_->choice());
  EXPECT_TRUE(window_->isVisible());

  pixel.setText("0.5");
  child<QLineEdit>("frameRate").setText("30");
  pixel.setFocus();
  input_.tap(kReturnKey);
  ASSERT_TRUE(pass_until([&] { return window_->choice().has_value(); })) << problem_at("recordingPixel");
  EXPECT_EQ(window_->choice()->source, (folder_ / "images").string());
  EXPECT_EQ(window_->choice()->pixel_size_um, 0.5);
  EXPECT_EQ(window_->choice()->frame_rate_hz, 30.0);
}

TEST_F(StartWindowTest, WhatIsNoRecordingIsSaidWithARemedy) {
  test::put(folder_ / "table.csv", "a,b\n1,2\n");
  open();
  answer_ = folder_ / "table.csv";
  click(child<QPushButton>("chooseFile"));
  ASSERT_TRUE(pass_until([&] { return problem_at("path").find("give a video") != std::string::npos; }))
      << problem_at("path");
  EXPECT_FALSE(window_->choice());
}

TEST_F(StartWindowTest, TheObjectiveComputesThePixelSize) {
  open();
  EXPECT_FALSE(child<QComboBox>("camera").isEnabled());
  const auto* notice = child<QComboBox>("camera").parentWidget()->findChild<QLabel*>("fieldNote");
  EXPECT_TRUE(notice->text().contains("plugged in")) << notice->text().toStdString();
  EXPECT_FALSE(child<QLineEdit>("cameraPixel").isVisible());
  choose(child<QComboBox>("objective"), "20");
  EXPECT_FALSE(child<QLineEdit>("specimenPixel").isVisible());
  child<QLineEdit>("cameraPixel").setText("6.5");
  EXPECT_EQ(child<QLabel>("computedSize").text().toStdString(), "= 0.325 µm per px");
}

TEST_F(StartWindowTest, WhatWasFilledInIsThereTheNextTime) {
  open();
  choose(child<QComboBox>("scenario"), "embryo");
  choose(child<QComboBox>("recordingProfile"), "mouse-embryo");
  child<QLineEdit>("recordingPixel").setText("0.65");
  window_->resize(1100, 700);
  input_.tap(kOneKey + 2);
  ASSERT_TRUE(pass_until([&] { return window_->current_card() == StartCardId::kCamera; }));
  input_.key(kControlKey, true);
  input_.tap(kQKey);
  input_.key(kControlKey, false);
  ASSERT_TRUE(pass_until([&] { return !window_->isVisible(); }));
  EXPECT_FALSE(window_->choice());

  open();
  EXPECT_EQ(child<QComboBox>("scenario").currentData().toString(), "embryo");
  EXPECT_EQ(child<QComboBox>("recordingProfile").currentData().toString(), "mouse-embryo");
  EXPECT_EQ(child<QLineEdit>("recordingPixel").text(), "0.65");
  EXPECT_EQ(window_->current_card(), StartCardId::kCamera);
  EXPECT_EQ(window_->size(), QSize(1100, 700));
}

TEST_F(StartWindowTest, DamagedSettingsLeaveTheDefaultsAndAreReplaced) {
  std::mt19937 numbers(7);
  std::string noise(4000, ' ');
  for (char& c : noise) c = static_cast<char>(numbers() & 0xFFU);
  const std::string shifted =
      "card=99\n[virtual]\nscenario=algebra\nhand=@Variant(\\0\\0\\0\\x7f)\n[window]\nwidth_px=-5\nheight_px="
      "99999999999\n";
  for (const std::string& text : {noise, shifted, std::string("[[[[\n====\n%%%")}) {
    test::put(options_.settings_file, text);
    open();
    EXPECT_EQ(child<QComboBox>("scenario").currentData().toString(), "injection");
    EXPECT_EQ(child<QComboBox>("hand").currentData().toString(), "demonstration");
    EXPECT_EQ(window_->current_card(), StartCardId::kVirtual);
    EXPECT_EQ(window_->size(), QSize(1400, 900));
    choose(child<QComboBox>("scenario"), "noisy");
    window_->close();
    open();
    EXPECT_EQ(child<QComboBox>("scenario").currentData().toString(), "noisy");
    window_.reset();
  }
}

TEST_F(StartWindowTest, TabReachesEveryControlInItsOrderAndAllHaveNames) {
  open();
  input_.tap(kOneKey);
  std::vector<QWidget*> visited;
  for (int k = 0; k < 60; ++k) {
    QWidget* now = qApp->focusWidget();
    ASSERT_NE(now, nullptr);
    if (!visited.empty() && now == visited.front()) break;
    visited.push_back(now);
    input_.tap(kTabKey);
    ASSERT_TRUE(pass_until([&] { return qApp->focusWidget() != now; })) << now->objectName().toStdString();
  }
  const auto place = [&](const char* name) {
    const auto found = std::find(visited.begin(), visited.end(), &child<QWidget>(name));
    EXPECT_NE(found, visited.end()) << name;
    return found - visited.begin();
  };
  long before = -1;
  for (const char* name :
       {"scenario", "hand", "path", "chooseFile", "chooseFolder", "recordingProfile", "recordingPixel", "frameRate",
        "searchCameras", "cameraProfile", "objective", "specimenPixel", "lessons", "largeLetters"}) {
    EXPECT_GT(place(name), before) << name;
    before = place(name);
  }
  for (const QWidget* widget : visited) {
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    EXPECT_FALSE(widget->accessibleName().isEmpty() && (!button || button->text().isEmpty()))
        << widget->objectName().toStdString();
  }
}

TEST_F(StartWindowTest, WhyTheLastChoiceFailedIsOnItsCard) {
  options_.problem = "a.avi: frame rate unknown; give --fps";
  options_.recording = folder_ / "a.avi";
  open();
  std::string shown;
  for (const auto* label : window_->findChildren<QLabel*>("cardProblem")) {
    if (label->isVisible()) shown += label->text().toStdString();
  }
  EXPECT_EQ(shown, "a.avi: frame rate unknown; give the frame rate");
  // It is filled in again, and looked at again.
  EXPECT_EQ(child<QLineEdit>("path").text().toStdString(), (folder_ / "a.avi").string());
  EXPECT_TRUE(pass_until([&] { return problem_at("path").find("no such file or folder") != std::string::npos; }));
}

TEST_F(StartWindowTest, ProblemsAreGermanOnAGermanPage) {
  const Translation german("de");
  options_.problem = "a.avi: frame rate unknown; give --fps (frames a second)";
  options_.recording = folder_ / "a.avi";
  open();
  std::string shown;
  for (const auto* label : window_->findChildren<QLabel*>("cardProblem")) {
    if (label->isVisible()) shown += label->text().toStdString();
  }
  EXPECT_EQ(shown, "a.avi: Bildrate unbekannt; geben Sie die Bildrate an (Bilder je Sekunde)");
  const std::string wanted =
      "a.avi: keine solche Datei und kein solcher Ordner; prüfen Sie den Pfad – wählen Sie ein Video";
  EXPECT_TRUE(pass_until([&] { return problem_at("path").find(wanted) != std::string::npos; })) << problem_at("path");
  window_.reset();
}

TEST_F(StartWindowTest, APixelIsMeasuredOnTheImage) {
  fs::create_directories(folder_ / "film");
  cv::Mat image(240, 320, CV_8UC1, cv::Scalar(90));
  // A scale bar of 200 px.
  image(cv::Rect(60, 200, 200, 6)).setTo(250);
  for (const char* name : {"f1.png", "f2.png"}) ASSERT_TRUE(cv::imwrite((folder_ / "film" / name).string(), image));
  open();
  auto& measure =
      *child<QWidget>("recordingPixel").parentWidget()->parentWidget()->findChild<QPushButton*>("measurePixel");
  click(measure);
  EXPECT_FALSE(problem_at("path").empty()) << "there is no image yet";
  drop(folder_ / "film");
  auto* path = child<QWidget>("path").parentWidget()->findChild<QLabel*>("fieldNote");
  ASSERT_TRUE(pass_until([&] { return path->text().contains("320"); }));
  measure.click();
  auto& dialog = child<QWidget>("pixelSizeDialog");
  auto& ruler = static_cast<RulerCanvas&>(child<QWidget>("ruler"));
  ASSERT_TRUE(pass_until([&] { return ruler.has_image() && dialog.isVisible(); }));
  pass(200);
  EXPECT_FALSE(child<QPushButton>("usePixelSize").isEnabled());
  const auto at = [&](double x_px, double y_px) {
    const QPoint place = ruler.mapToGlobal(ruler.to_widget(x_px, y_px).toPoint());
    input_.move(place.x(), place.y());
    pass(100);
  };
  at(60, 203);
  input_.left_button(true);
  pass(100);
  at(150, 203);
  at(260, 203);
  input_.left_button(false);
  ASSERT_TRUE(pass_until([&] { return std::abs(ruler.line().length_px() - 200.0) < 2.0; })) << ruler.line().length_px();
  keep_picture(dialog, "measure-pixel");
  child<QLineEdit>("knownLength").setText("100");
  EXPECT_TRUE(child<QLabel>("measuredPixel").text().contains("±"));
  child<QPushButton>("usePixelSize").click();
  EXPECT_NEAR(child<QLineEdit>("recordingPixel").text().toDouble(), 0.5, 0.006);
  // Keys alone do it as well.
  DrawnLine before;
  RulerCanvas canvas([] {});
  canvas.set_image(QImage(100, 80, QImage::Format_Grayscale8));
  before = canvas.line();
  QKeyEvent right(QEvent::KeyPress, Qt::Key_Right, Qt::ShiftModifier);
  QApplication::sendEvent(&canvas, &right);
  EXPECT_DOUBLE_EQ(canvas.line().length_px(), before.length_px() + 10.0);
}

TEST_F(StartWindowTest, TabComesToEveryControlAndEachHasAName) {
  open();
  const auto stops = test::tab_stops(*window_);
  ASSERT_GT(stops.size(), 8u);
  for (QWidget* missed : test::controls_without_stop(*window_, stops))
    ADD_FAILURE() << "Tab passes by " << test::widget_text(*missed);
  for (QWidget* stop : stops) EXPECT_NE(test::spoken_name(*stop), "") << test::widget_text(*stop);
}

}  // namespace
}  // namespace pellucida
