// The analyst's seat: thumbnails, histograms, the model's curve, measuring on the image, cells of several sessions,
// pictures of any size, and everything by the keyboard.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QDropEvent>
#include <QImage>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QToolButton>
#include <QUrl>
#include <algorithm>
#include <set>

#include "CellsWindow.h"
#include "ModelReview.h"
#include "PictureSizeDialog.h"
#include "ReviewViews.h"
#include "WindowPicture.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/session/Annotations.h"
#include "review/ReviewWindowFixture.h"
#include "support/Files.h"
#include "widgets/CurvePanel.h"
#include "widgets/FeedPanel.h"
#include "widgets/MembranePanel.h"
#include "widgets/ThumbnailBar.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

using namespace test;

constexpr std::uint32_t kHKey = 0x68, kJKey = 0x6a, kDKey = 0x64, kTabKey = 0xff09;

class ReviewSeat : public ReviewWindowTest {
 protected:
  // A session of its own, to be written in.
  void open_own() {
    session_ = *own_ / "M";
    write_touch(session_);
    window_->open(session_);
    ASSERT_TRUE(shows(0)) << text("problem");
    ASSERT_TRUE(activate(*window_)) << "not active";
    pass(100);
  }
  ThumbnailBar& thumbnails() { return *dynamic_cast<ThumbnailBar*>(window_->findChild<QWidget*>("thumbnails")); }
  ReviewViews& views() { return const_cast<ReviewViews&>(window_->views()); }
  ViewWidget& image() { return views().feed().view(); }
  std::vector<Annotation> kept() const { return read_annotations(session_); }

  std::unique_ptr<TemporaryFolder> own_ = std::make_unique<TemporaryFolder>();
  std::filesystem::path session_;
};

TEST_F(ReviewSeat, ThumbnailsLieAlongTheTimelineAndSeek) {
  window_->resize(1400, 900);
  open();
  ASSERT_TRUE(thumbnails().isVisible());
  ASSERT_TRUE(pass_until([&] { return !thumbnails().reading() && !thumbnails().pictures().empty(); }));
  EXPECT_GE(thumbnails().pictures().size(), 15U);
  for (const QImage& picture : thumbnails().pictures()) EXPECT_FALSE(picture.isNull());
  // The same place as on the timeline.
  const QPoint place(static_cast<int>(timeline().x_of(2.0)) + 1, 20);
  click(thumbnails(), place);
  EXPECT_TRUE(shows(20));
  window_->resize(1000, 640);
  EXPECT_TRUE(pass_until([&] { return !thumbnails().isVisible(); })) << "no room";
}

TEST_F(ReviewSeat, TheHistogramTakesTurnsWithTheForceOverIndentation) {
  open();
  auto* choice = window_->findChild<QComboBox*>("touchChart");
  auto* facts = window_->findChild<QLabel*>("chartFacts");
  EXPECT_FALSE(facts->isVisible());
  input_.tap(kHKey);
  ASSERT_TRUE(pass_until([&] { return window_->views().histogram() == Quantity::kForce; }));
  EXPECT_TRUE(facts->isVisible());
  EXPECT_EQ(facts->text().left(9), "25 frames") << facts->text().toStdString();
  EXPECT_EQ(views().force_over_indentation().chart().data().x_title, "Force (µN)");
  // Of the nodes in the frame shown: it follows the frame.
  choice->setCurrentIndex(1 + static_cast<int>(Quantity::kNodeForce));
  input_.tap(kEndKey);
  ASSERT_TRUE(shows(kFrames - 1));
  const QString last = facts->text();
  EXPECT_NE(last.indexOf("nodes"), -1);
  input_.tap(kHomeKey);
  ASSERT_TRUE(shows(0));
  EXPECT_NE(facts->text(), last);
  const TemporaryFolder out;
  answer_ = out / "h.csv";
  trigger("exportTouch");
  EXPECT_EQ(text_of(answer_).rfind("node_force_uN_from,", 0), 0U);
  answer_ = out / "h.svg";
  trigger("exportTouch");
  EXPECT_NE(text_of(answer_).find("<svg"), std::string::npos);
  input_.tap(kHKey);
  ASSERT_TRUE(pass_until([&] { return !window_->views().histogram(); }));
  EXPECT_EQ(views().force_over_indentation().chart().data().x_title, "Indentation (µm)");
}

TEST_F(ReviewSeat, TheModelsCurvesComeInTheBackgroundAndCanBeHidden) {
  session_ = *own_ / "P";
  write_touch(session_, true, 0, to_json(load_profile("mouse-oocyte")));
  window_->open(session_);
  ASSERT_TRUE(shows(0)) << text("problem");
  ASSERT_TRUE(activate(*window_)) << "not active";
  input_.tap(kEndKey);
  ASSERT_TRUE(shows(kFrames - 1));
  const auto drawn = [&] { return views().force_over_indentation().chart().data().named.size(); };
  ASSERT_TRUE(pass_until([&] { return window_->views().model().shown() && drawn() == 2; }));
  EXPECT_EQ(views().force_over_indentation().chart().data().named[1].name, "Model, profile's cell");
  window_->findChild<QToolButton*>("model")->click();
  ASSERT_TRUE(pass_until([&] { return drawn() == 0; }));
}

TEST_F(ReviewSeat, ADistanceAndAnAngleAreMeasuredKeptAndTakenBack) {
  open_own();
  input_.tap(kRightKey);
  ASSERT_TRUE(shows(1));
  const QPoint a(image().width() / 4, image().height() / 2), b(image().width() / 2, image().height() / 2);
  const auto um = [&](QPoint place) { return views().image().place_um(place.x(), place.y(), image().height()); };
  const double wide_um = um(b).x() - um(a).x();
  input_.tap(kDKey);
  pass(200);
  click(image(), a);
  click(image(), b);
  ASSERT_TRUE(pass_until([&] { return kept().size() == 1; }));
  EXPECT_NEAR(kept()[0].time_s, 0.1, 1e-9);
  ASSERT_EQ(kept()[0].further_um.size(), 1U);
  EXPECT_NEAR(kept()[0].further_um[0].x_um - kept()[0].place_um->x_um, wide_um, 1.0);
  EXPECT_EQ(text("noteWhere").rfind("Distance ", 0), 0U) << text("noteWhere");
  // It has a name, and no place in the list without it.
  auto* name = window_->findChild<QLineEdit*>("noteText");
  name->setText("Zona");
  emit name->returnPressed();
  EXPECT_EQ(kept()[0].text, "Zona");
  // Another one at once; Esc ends it, and no further click is taken.
  click(image(), a);
  input_.tap(kEscapeKey);
  pass(200);
  click(image(), b);
  EXPECT_EQ(kept().size(), 1U);

  trigger("measureAngle");
  pass(100);
  click(image(), a);
  click(image(), b);
  click(image(), {image().width() / 2, image().height() / 4});
  ASSERT_TRUE(pass_until([&] { return kept().size() == 2; }));
  EXPECT_EQ(text("noteWhere").rfind("Angle ", 0), 0U) << text("noteWhere");
  EXPECT_EQ(window_->findChild<QPushButton*>("noteNext")->text().left(5), "2 / 2");
  window_->findChild<QPushButton*>("noteNext")->click();
  EXPECT_EQ(text("noteWhere").rfind("Distance ", 0), 0U) << text("noteWhere");

  const TemporaryFolder out;
  answer_ = out / "m.csv";
  trigger("measureSave");
  EXPECT_NE(text_of(answer_).find("0.1,distance,"), std::string::npos) << text_of(answer_);
  EXPECT_NE(text_of(answer_).find("Zona"), std::string::npos);
  window_->findChild<QPushButton*>("noteDelete")->click();
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_EQ(kept()[0].further_um.size(), 2U);
  trigger("noteUndo");
  EXPECT_EQ(kept().size(), 2U);
}

TEST_F(ReviewSeat, AHintAskedForMeanwhileTakesTheClick) {
  open_own();
  trigger("measureDistance");
  trigger("hintCell");
  pass(100);
  click(image(), {image().width() / 2, image().height() / 2});
  ASSERT_TRUE(pass_until([&] { return window_->findChild<QWidget*>("hintStrip")->isVisible(); }));
  click(image(), {image().width() / 3, image().height() / 3});
  EXPECT_TRUE(kept().empty());
}

TEST_F(ReviewSeat, CellsOfSeveralSessionsAreOneTable) {
  write_touch(*own_ / "control" / "a");
  write_touch(*own_ / "treated" / "b", true, 4);
  open();
  input_.tap(kJKey);
  ASSERT_TRUE(pass_until([&] { return window_->cells() && !window_->cells()->reading(); }));
  CellsWindow& cells = *window_->cells();
  ASSERT_EQ(cells.cells().rows().size(), 1U) << "the session shown";
  answer_ = own_->path();
  cells.findChild<QPushButton*>("cellsAdd")->click();
  ASSERT_TRUE(pass_until([&] { return cells.cells().rows().size() == 3; }));
  auto* table = cells.findChild<QTableWidget*>("cells");
  auto* groups = cells.findChild<QTableWidget*>("cellGroups");
  EXPECT_TRUE(groups->isVisible());
  EXPECT_EQ(groups->rowCount(), 3);
  table->sortItems(4, Qt::AscendingOrder);
  const auto peak = [&](int row) { return table->item(row, 4)->text().toDouble(); };
  EXPECT_LE(peak(0), peak(1));
  EXPECT_LE(peak(1), peak(2));
  table->sortItems(1, Qt::DescendingOrder);
  EXPECT_EQ(table->item(2, 1)->text(), "S");
  const TemporaryFolder out;
  answer_ = out / "cells.csv";
  cells.findChild<QPushButton*>("cellsSave")->click();
  EXPECT_EQ(text_of(answer_).rfind("group,session,", 0), 0U);
  // A row opens its session where it was touched.
  table->setCurrentCell(1, 1);
  const QString name = table->item(1, 1)->text();
  emit table->itemDoubleClicked(table->item(1, 1));
  ASSERT_TRUE(pass_until([&] { return window_->session()->folder.filename() == name.toStdString(); }));
  EXPECT_TRUE(pass_until([&] { return window_->shown_step() == 9U || window_->shown_step() == 5U; }));
  table->selectRow(0);
  cells.findChild<QPushButton*>("cellsRemove")->click();
  EXPECT_EQ(table->rowCount(), 2);
}

TEST_F(ReviewSeat, SeveralSessionsDroppedAreTheirCells) {
  write_touch(*own_ / "a");
  write_touch(*own_ / "b");
  open();
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QString::fromStdString((*own_ / "a").string())),
                QUrl::fromLocalFile(QString::fromStdString((*own_ / "b").string()))});
  QDragEnterEvent enter({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(200.0, 200.0), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &drop);
  ASSERT_TRUE(window_->cells());
  EXPECT_TRUE(pass_until([&] { return window_->cells()->cells().rows().size() == 3; }));
  EXPECT_EQ(window_->session()->folder.filename(), "S");
}

double share_of_edges(const QImage& picture) {
  long edges = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 1; x < picture.width(); ++x) {
      edges += std::abs(qGray(picture.pixel(x, y)) - qGray(picture.pixel(x - 1, y))) > 60 ? 1 : 0;
    }
  }
  return static_cast<double>(edges) / (picture.width() * picture.height());
}

TEST_F(ReviewSeat, AViewIsDrawnAnewAtTheSizeAskedFor) {
  open();
  const QImage seen = image().picture();
  const QImage large = image().picture(seen.size() * 2);
  ASSERT_EQ(large.size(), seen.size() * 2);
  // The same picture, but drawn: sharper than one that was made larger.
  const QImage small = large.scaled(seen.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  long apart = 0;
  for (int y = 0; y < seen.height(); y += 3) {
    for (int x = 0; x < seen.width(); x += 3)
      apart += std::abs(qGray(seen.pixel(x, y)) - qGray(small.pixel(x, y))) > 60 ? 1 : 0;
  }
  EXPECT_LT(apart, seen.width() * seen.height() / 9 / 20);
  const QImage blown_up = seen.scaled(large.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  EXPECT_GT(share_of_edges(large), 1.2 * share_of_edges(blown_up));
  // The window shows on as before.
  EXPECT_EQ(image().picture().size(), seen.size());
  const QImage window = window_picture(*window_, 2 * window_->width());
  EXPECT_EQ(window.size(), window_->size() * 2);
}

TEST_F(ReviewSeat, ThePicturesSizeIsChosen) {
  PictureSizeDialog dialog("Size", {1400, 900}, true, nullptr);
  EXPECT_EQ(dialog.chosen(), QSize(1400, 900));
  auto* choice = dialog.findChild<QComboBox*>("pictureSize");
  choice->setCurrentIndex(1);
  EXPECT_EQ(dialog.chosen(), QSize(2800, 1800));
  choice->setCurrentIndex(choice->count() - 1);
  dialog.findChild<QSpinBox*>("pictureWidth")->setValue(700);
  EXPECT_EQ(dialog.chosen(), QSize(700, 450));
  PictureSizeDialog free("Size", {4000, 3000}, false, nullptr);
  EXPECT_EQ(free.findChild<QComboBox*>("pictureSize")->count(), 3) << "four times would be too large";
}

TEST_F(ReviewSeat, WhatIsSeenIsWrittenAsTables) {
  open();
  input_.tap(kRightKey);
  ASSERT_TRUE(shows(1));
  const TemporaryFolder out;
  answer_ = out / "seen";
  trigger("exportSeen");
  EXPECT_NE(text_of(answer_ / "frame.csv").find("\n1,0.1,free"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(answer_ / "nodes.csv"));
  EXPECT_TRUE(std::filesystem::exists(answer_ / "force-indentation.csv"));
  EXPECT_EQ(questions_, 0);
  trigger("exportSeen");
  EXPECT_EQ(questions_, 1) << "nothing is replaced without a question";
}

bool takes_the_keyboard(const QWidget& widget) {
  return widget.isVisible() && widget.isEnabled() && (widget.focusPolicy() & Qt::TabFocus) != 0;
}

TEST_F(ReviewSeat, TabReachesEveryControlAndEachHasAName) {
  window_->resize(1400, 900);
  open();
  std::set<const QWidget*> controls;
  for (const auto* widget : window_->findChildren<QWidget*>()) {
    const bool is_control = qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
                            qobject_cast<const QLineEdit*>(widget);
    if (!is_control || !widget->isVisible() || !widget->isEnabled() || widget->window() != window_.get()) continue;
    const std::string what = widget->objectName().toStdString() + " " + widget->toolTip().toStdString();
    EXPECT_TRUE(takes_the_keyboard(*widget)) << "the mouse alone reaches " << what;
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    EXPECT_FALSE(widget->accessibleName().isEmpty() && (!button || button->text().isEmpty())) << "no name: " << what;
    controls.insert(widget);
  }
  ASSERT_GT(controls.size(), 25U);
  std::set<const QWidget*> reached;
  std::vector<int> bar_px;
  for (std::size_t k = 0; k < 2 * controls.size() + 20; ++k) {
    input_.tap(kTabKey);
    pass(15);
    if (const QWidget* focus = qApp->focusWidget()) {
      if (reached.insert(focus).second && focus->parentWidget()->objectName() == "topBar") bar_px.push_back(focus->x());
    }
  }
  for (const QWidget* control : controls) {
    EXPECT_TRUE(reached.contains(control))
        << control->objectName().toStdString() << " " << control->toolTip().toStdString();
  }
  // From left to right, wherever it began.
  ASSERT_GT(bar_px.size(), 5U);
  std::rotate(bar_px.begin(), std::min_element(bar_px.begin(), bar_px.end()), bar_px.end());
  EXPECT_TRUE(std::is_sorted(bar_px.begin(), bar_px.end()));
}

}  // namespace
}  // namespace pellucida
