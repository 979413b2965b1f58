// Ten thousand frames, as five minutes at 30 frames/s: memory stays where it was after the first thousand, and so does
// the measurement.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "pellucida/tracking/MembraneTracker.h"
#include "tracking/FrameLoop.h"

namespace pellucida {
namespace {

// Memory of this process that is in the machine's, kB.
long resident_kB() {
  long total = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return resident * (sysconf(_SC_PAGESIZE) / 1024);
}

TEST(LongRun, MemoryIsConstantAndTheCellIsNeverLost) {
  Scenario scenario = load_scenario("default");
  scenario.image.width_px = 480;
  scenario.image.height_px = 320;
  scenario.cell.center_x_um = 190.0;
  scenario.cell.center_y_um = 132.0;
  const test::FrameLoop loop(scenario);
  MembraneTracker tracker;
  long early_kB = 0;
  int lost = 0;
  for (std::size_t k = 0; k < 10000; ++k) {
    const Observation seen = tracker.process(loop.view(k), static_cast<double>(k) / 30.0, static_cast<long>(k));
    lost += seen.outer ? 0 : 1;
    if (k == 999) early_kB = resident_kB();
  }
  const long late_kB = resident_kB();
  std::printf("resident memory: %ld kB after 1,000 frames, %ld kB after 10,000\n", early_kB, late_kB);
  ASSERT_GT(early_kB, 0);
  EXPECT_LE(late_kB - early_kB, 1024);
  EXPECT_EQ(lost, 0);
}

}  // namespace
}  // namespace pellucida
