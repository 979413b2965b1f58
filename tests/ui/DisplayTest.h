#pragma once
#include <gtest/gtest.h>

#include <QApplication>

#include "pellucida/visualization/VirtualDisplay.h"

namespace pellucida::test {

/// Tests of shown windows: a Qt application, on a display of its own where there is none. One for the whole program.
class DisplayTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    static VirtualDisplay display;
    static int argc = 1;
    static char name[] = "test";
    static char* argv[] = {name, nullptr};
    if (!qApp) new QApplication(argc, argv);
  }
};

}  // namespace pellucida::test
