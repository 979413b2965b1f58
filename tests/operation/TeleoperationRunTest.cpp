#include "pellucida/operation/TeleoperationRun.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <thread>

#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/haptics/DeviceCatalog.h"
#include "pellucida/operation/HapticPathBlock.h"
#include "pellucida/operation/VirtualInjectionSetup.h"
#include "pellucida/pipeline/BatchRun.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/session/SessionReader.h"
#include "pellucida/session/SessionSource.h"
#include "pellucida/teleoperation/TeleoperationMap.h"
#include "support/WaitUntil.h"

namespace pellucida {
namespace {

using test::wait_until;

// A Touch whose hand a test moves.
class TestHand final : public HapticDevice {
 public:
  const DeviceSpecification& specification() const noexcept override { return specification_; }
  bool read(double now_s, HandSample& sample) noexcept override {
    sample.time_s = now_s;
    sample.position_m.x = x_m;
    return true;
  }
  bool write(const PlainVector3& force_N) noexcept override {
    force_x_N = force_N.x;
    return true;
  }

  std::atomic<double> x_m{0.0};
  std::atomic<double> force_x_N{0.0};

 private:
  DeviceSpecification specification_ = find_device("Touch");
};

std::vector<HapticRecord> three_ticks() {
  std::vector<HapticRecord> records(3);
  for (int k = 0; k < 3; ++k) {
    records[k].time_s = 10.0 + 0.001 * k;
    records[k].wanted_um = {100.0 + k, 50.0, 0.0};
    records[k].pipette_um = {99.0 + 0.5 * k, 50.0, 1.0};
    records[k].hand_force_N = {0.5, 0.0, 0.25};
    records[k].contact_age_s = 0.02;
    records[k].energy_margin_J = 3e-6;
    records[k].limits = limit_bit(LimitKind::kDepth);
  }
  return records;
}

TEST(HapticPathBlock, HoldsBothPathsInTheSessionsTime) {
  const auto records = three_ticks();
  const auto block = make_haptic_path_block(records, 8.0).shallow_copy();
  ASSERT_EQ(block->GetNumberOfCells(), 2);
  ASSERT_EQ(block->GetNumberOfPoints(), 6);
  EXPECT_EQ(block->GetCellData()->GetArray("path")->GetComponent(1, 0), 1.0);
  double point_um[3];
  block->GetPoint(2, point_um);
  EXPECT_DOUBLE_EQ(point_um[0], 102.0);
  block->GetPoint(5, point_um);
  EXPECT_DOUBLE_EQ(point_um[0], 100.0);
  const auto value = [&](const char* name, vtkIdType point, int component = 0) {
    return block->GetPointData()->GetArray(name)->GetComponent(point, component);
  };
  EXPECT_NEAR(value("time_s", 5), 2.002, 1e-12);
  EXPECT_NEAR(value("velocity_um_per_s", 1), 1000.0, 1e-6);
  EXPECT_NEAR(value("velocity_um_per_s", 4), 500.0, 1e-6);
  EXPECT_NEAR(value("force_N", 3, 2), 0.25, 1e-6);
  EXPECT_NEAR(value("contact_age_ms", 0), 20.0, 1e-4);
  EXPECT_NEAR(value("energy_margin_uJ", 0), 3.0, 1e-5);
  EXPECT_EQ(value("limits", 0), limit_bit(LimitKind::kDepth));
}

TEST(HapticPathBlock, OfNoTicksIsNone) {
  EXPECT_FALSE(make_haptic_path_block({}, 0.0));
}

// The whole way: the hand moves the injector, the microscope shows it, the chain measures it, the hand feels it.
TEST(TeleoperationRun, TheHandFeelsTheCellAndTheSessionHoldsIt) {
  const TemporaryFolder folder;
  VirtualInjectionSetup setup("injection");
  LiveRun run(setup.make_microscope(Pace::kWallClock), {});
  ContactTap contacts(run);
  TeleoperationMap map;
  TestHand hand;
  TeleoperationRun::Options options;
  options.haptics = default_settings(hand.specification(), map.scale_um_per_m());
  TeleoperationRun rig(run, contacts, hand, map, setup.injector(), options);
  run.start_recording(folder / "s");
  run.start();
  rig.start();
  ASSERT_TRUE(wait_until([&] { return rig.status().tick.hand_state == HandState::kWorking; }));
  const double start_um = rig.status().tick.pipette_um.x;

  // The needle comes from the right: the hand goes left, softly, until 15 um of the cell are pushed in.
  const double way_um = setup.scenario().motion.gap_um + 15.0;
  double gone_um = 0.0;
  HandStatus status;
  ASSERT_TRUE(wait_until([&] {
    gone_um = std::min(gone_um + 0.5, way_um);
    hand.x_m = -gone_um / map.scale_um_per_m();
    // On a busy machine a frame may be too old for a moment: one in time will come.
    status = rig.status();
    return hand.force_x_N > 0.01 && status.tick.contact_state == ContactState::kContact;
  }));
  EXPECT_EQ(status.device, "Touch");
  EXPECT_GT(status.tick.contact_force_uN.x, 0.0);
  EXPECT_LT(status.tick.pipette_um.x, start_um - setup.scenario().motion.gap_um);
  EXPECT_FALSE(status.fault);

  rig.stop();
  EXPECT_EQ(hand.force_x_N, 0.0);
  run.stop();
  EXPECT_EQ(check_session(folder / "s", false).problem_count, 0U);
  const SessionReader session(folder / "s");
  ASSERT_GT(session.hand_block_count(), 0U);
  // Hand and frames share one time.
  const auto block = session.load_hand(session.hand_block_count() - 1).shallow_copy();
  const auto* time = block->GetPointData()->GetArray("time_s");
  const double last_s = const_cast<vtkDataArray*>(time)->GetComponent(block->GetNumberOfPoints() - 1, 0);
  EXPECT_NEAR(last_s, session.measurements().back().time_s, 5.0);

  // The rows say where the injector was at each frame's time, and what is measured by that again is the same.
  const auto& rows = session.measurements();
  const auto is_placed = [](const Measurement& row) { return std::isfinite(row.manipulator_x_um); };
  EXPECT_GT(std::count_if(rows.begin(), rows.end(), is_placed), 10);
  SessionSource source(folder / "s");
  const BatchResult again = run_batch(source, {}, [](const Scene&) {});
  ASSERT_EQ(again.rows.size(), rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(is_placed(again.rows[k]), is_placed(rows[k])) << k;
    if (!rows[k].state || !std::isfinite(rows[k].tip_x_um)) continue;
    EXPECT_NEAR(again.rows[k].tip_x_um, rows[k].tip_x_um, 1e-5) << k;
    EXPECT_NEAR(again.rows[k].indentation_um, rows[k].indentation_um, 1e-5) << k;
  }
}

TEST(TeleoperationRun, ASettingTheDeviceCannotHoldIsRefused) {
  VirtualInjectionSetup setup("injection");
  LiveRun run(setup.make_microscope(Pace::kWallClock), {});
  ContactTap contacts(run);
  TeleoperationMap map;
  TestHand hand;
  TeleoperationRun::Options options;
  options.haptics = default_settings(hand.specification(), map.scale_um_per_m());
  options.haptics.force_scale_N_per_uN *= 2.0;
  EXPECT_THROW(TeleoperationRun(run, contacts, hand, map, setup.injector(), options), UsageError);
}

}  // namespace
}  // namespace pellucida
