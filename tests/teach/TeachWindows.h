#pragma once
#include <gtest/gtest.h>

#include <QApplication>
#include <memory>

#include "CellPage.h"
#include "TeachWindow.h"
#include "pellucida/visualization_vtk/MessageLog.h"
#include "ui/DisplayTest.h"
#include "ui/XInput.h"
#include "widgets/ViewWidget.h"

namespace pellucida::test {

/// The real window of Teach mode, driven by mouse and keys. Fails on any VTK error or warning.
class TeachWindows : public DisplayTest {
 protected:
  TeachWindows() : log_(MessageLog::install()), problems_(log_->problem_count()) {}
  ~TeachWindows() override { EXPECT_EQ(log_->problem_count(), problems_) << log_->last_problem(); }

  // At the lesson named, shown and active, its first drawings done.
  void open(const std::string& lesson) {
    window_ = std::make_unique<TeachWindow>(choose_lessons(lesson), TeachOptions{});
    ASSERT_TRUE(activate(*window_)) << "not active";
    if (window_->cell().view_widget().isVisible()) {
      ASSERT_TRUE(pass_until([&] { return newest() && newest()->run > 0 && newest()->time_s > 0.05; }));
    }
    pass(300);
  }

  CellSnapshotPtr newest() { return window_->cell().runner().newest(); }

  QPoint on_screen(const Eigen::Vector2d& device_px) {
    ViewWidget& widget = window_->cell().view_widget();
    const double ratio = widget.devicePixelRatioF();
    return widget.mapToGlobal(
        QPoint(qRound(device_px.x() / ratio), widget.height() - 1 - qRound(device_px.y() / ratio)));
  }

  // The node on the near side that is furthest on screen from all others: a click on it can mean no other.
  int node_by_itself() {
    const PokedCellView& view = window_->cell().view();
    const int count = static_cast<int>(newest()->x_um.cols());
    int best = 0;
    double furthest_px = 0.0;
    for (int node = 0; node < count; ++node) {
      const Eigen::Vector2d at_px = view.node_on_screen_px(node);
      if (view.node_at(at_px.x(), at_px.y()) != node) continue;
      double nearest_px = 1e9;
      for (int other = 0; other < count; ++other)
        if (other != node) nearest_px = std::min(nearest_px, (view.node_on_screen_px(other) - at_px).norm());
      if (nearest_px > furthest_px) best = node;
      furthest_px = std::max(furthest_px, nearest_px);
    }
    return best;
  }

  // The one that is seen, where pages have widgets of the same name.
  template <class Widget>
  Widget& child(const char* name) {
    const auto all = window_->findChildren<Widget*>(name);
    EXPECT_FALSE(all.isEmpty()) << name;
    for (Widget* one : all)
      if (one->isVisible()) return *one;
    return *all.front();
  }

  MessageLog* log_;
  std::uint64_t problems_;
  XInput input_;
  std::unique_ptr<TeachWindow> window_;
};

}  // namespace pellucida::test
