#pragma once
#include <gtest/gtest.h>

#include <QApplication>

namespace pellucida::test {

/// Widgets without a display: nothing is drawn, all events are real.
class OffscreenWidgets : public ::testing::Test {
 protected:
  OffscreenWidgets() {
    static QApplication* app = [] {
      qputenv("QT_QPA_PLATFORM", "offscreen");
      static int argc = 1;
      static char name[] = "test";
      static char* argv[] = {name, nullptr};
      return new QApplication(argc, argv);
    }();
    EXPECT_TRUE(app);
  }
};

}  // namespace pellucida::test
