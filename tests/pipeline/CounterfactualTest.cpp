#include "pellucida/pipeline/Counterfactual.h"

#include <gtest/gtest.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "ReplayTools.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/core_vtk/ObservationData.h"
#include "pellucida/pipeline/BatchRun.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/session/SessionSource.h"
#include "pellucida/session/SessionWriter.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "support/DocsPage.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

/// Every frame measured.
void record_batch(const Scenario& scenario, const fs::path& folder, bool frames = true) {
  VirtualMicroscope microscope(scenario);
  SessionInfo info;
  info.source = microscope.info();
  const CellProfile profile = load_profile("mouse-oocyte");
  info.profile_name = profile.name;
  info.profile_json = to_json(profile);
  info.provenance_json = to_json(RunProvenance{}, PipelineOptions{}, profile);
  SessionWriter writer(folder, info, {.frames = frames});
  run_batch(microscope, {}, [&](const Scene& scene) { writer.write(scene); });
  writer.close();
}

// One recording for the tests below.
class Counterfactual : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    Scenario scenario = quick_scenario("default");
    scenario.image.frame_rate_hz = 10.0;
    record_batch(scenario, recorded());
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static fs::path recorded() { return *folder_ / "recorded"; }
  static fs::path at(const std::string& name) { return *folder_ / name; }

  static ReplayVariant with_modulus(double ratio, const std::string& name) {
    ReplayVariant variant = same(recorded(), at(name));
    variant.name = name;
    variant.profile.effective_young_modulus_kPa *= ratio;
    variant.changes_json = R"({"material.effective_young_modulus_kPa":{}})";
    return variant;
  }

 private:
  static std::unique_ptr<TemporaryFolder> folder_;
};
std::unique_ptr<TemporaryFolder> Counterfactual::folder_;

// The modulus is the only scale of the forces: twice the modulus, twice the force on the same shape.
TEST_F(Counterfactual, TheForceGoesWithTheModulus) {
  const auto result = run_counterfactual(recorded(), again(recorded(), Rerun::kMechanics),
                                         {with_modulus(0.5, "half"), with_modulus(2.0, "double")});
  ASSERT_EQ(result.variants.size(), 2U);
  EXPECT_EQ(result.variants[0].name, "half");
  EXPECT_NEAR(result.variants[0].changes.force_ratio, 0.5, 1e-4);
  EXPECT_NEAR(result.variants[1].changes.force_ratio, 2.0, 1e-4);
  EXPECT_NEAR(result.variants[1].changes.peak_force_uN / result.variants[1].changes.recorded_peak_force_uN, 2.0, 1e-4);
  EXPECT_EQ(result.variants[1].changes.largest_contour_um, 0.0);
  EXPECT_LT(result.variants[1].changes.indentation_rms_um, 10.0 * kNineDigits);
}

std::vector<Event> hints_in(const SessionReader& session) {
  std::vector<Event> hints = session.events();
  std::erase_if(hints, [](const Event& event) { return event.kind != event_kind::kHint; });
  return hints;
}

// A hint counts from its frame on; before it every number stays, and a replay of the result knows it too.
TEST_F(Counterfactual, AHintChangesTheTrackingFromItsFrameOn) {
  const SessionReader before(recorded());
  const std::size_t from = before.steps().size() / 2;
  auto options = again(recorded(), Rerun::kTracking);
  options.keep_frames = true;
  const Measurement& there = before.measurements()[from];
  options.pipeline.hints = {{.kind = PersonHint::Kind::kNoCell,
                             .x_um = there.cell_x_um,
                             .y_um = there.cell_y_um,
                             .since_s = before.steps()[from].time_s}};
  run_counterfactual(recorded(), options, {same(recorded(), at("hinted"))});
  const SessionReader now(at("hinted"));
  ASSERT_EQ(now.steps().size(), before.steps().size());
  for (std::size_t i = 0; i < from; ++i) {
    EXPECT_TRUE(equal_as_written(before.measurements()[i], now.measurements()[i])) << i;
  }
  for (std::size_t i = from; i < now.steps().size(); ++i) {
    EXPECT_EQ(now.measurements()[i].state, CellState::kNoCell) << i;
  }
  ASSERT_EQ(hints_in(now).size(), 1U);
  EXPECT_NEAR(hints_in(now)[0].time_s, before.steps()[from].time_s, 1e-6);
  EXPECT_NE(now.info().provenance_json.find("no cell at"), std::string::npos);

  run_counterfactual(at("hinted"), again(at("hinted"), Rerun::kTracking), {same(at("hinted"), at("hinted-again"))});
  expect_equal_rows(at("hinted"), at("hinted-again"));
  EXPECT_EQ(hints_in(SessionReader(at("hinted-again"))).size(), 1U);
  run_counterfactual(at("hinted"), again(at("hinted"), Rerun::kMechanics), {same(at("hinted"), at("hinted-forces"))});
  EXPECT_EQ(hints_in(SessionReader(at("hinted-forces"))).size(), 1U);

  options.rerun = Rerun::kMechanics;
  EXPECT_THROW(run_counterfactual(recorded(), options, {same(recorded(), at("refused"))}), UsageError);
}

// Several variants at once give what each gives alone.
TEST_F(Counterfactual, VariantsDoNotDisturbEachOther) {
  auto options = again(recorded(), Rerun::kMechanics);
  run_counterfactual(recorded(), options, {with_modulus(1.3, "alone")});
  options.job_count = 3;
  run_counterfactual(recorded(), options,
                     {with_modulus(0.7, "first"), with_modulus(1.3, "beside"), with_modulus(2.1, "third")});
  expect_equal_rows(at("alone"), at("beside"));
}

TEST_F(Counterfactual, AStopClosesTheSessionsWhole) {
  auto options = again(recorded(), Rerun::kMechanics);
  int asked_count = 0;
  options.stopped = [&] { return ++asked_count > 5; };
  run_counterfactual(recorded(), options, {with_modulus(1.3, "stopped")});
  const SessionReader session(at("stopped"));
  EXPECT_EQ(session.steps().size(), 5U);
  EXPECT_EQ(check_session(at("stopped"), false).problem_count, 0U);
  const auto& events = session.events();
  EXPECT_TRUE(
      std::any_of(events.begin(), events.end(), [](const Event& event) { return event.kind == event_kind::kStopped; }));
}

TEST_F(Counterfactual, TheFieldsAreThoseOfBothAndTheirDifference) {
  const auto result =
      run_counterfactual(recorded(), again(recorded(), Rerun::kMechanics), {with_modulus(1.5, "fields")});
  const SessionReader before(recorded()), now(at("fields"));
  const auto step = static_cast<std::size_t>(
      std::max_element(before.measurements().begin(), before.measurements().end(),
                       [](const auto& a, const auto& b) { return !(b.contact_force_uN <= a.contact_force_uN); }) -
      before.measurements().begin());
  auto was = before.load(step, SessionPart::kSurface).shallow_copy();
  auto is = now.load(step, SessionPart::kSurface).shallow_copy();
  ASSERT_TRUE(was && is);
  auto* force = is->GetPointData()->GetArray("force_uN");
  auto* recorded_force = is->GetPointData()->GetArray("recorded_force_uN");
  auto* difference = is->GetPointData()->GetArray("force_difference_uN");
  auto* original = was->GetPointData()->GetArray("force_uN");
  ASSERT_TRUE(force && recorded_force && difference && original);
  double largest_uN = 0.0;
  for (vtkIdType node = 0; node < is->GetNumberOfPoints(); ++node) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(recorded_force->GetComponent(node, i), original->GetComponent(node, i));
      EXPECT_NEAR(difference->GetComponent(node, i), force->GetComponent(node, i) - original->GetComponent(node, i),
                  1e-6);
      largest_uN = std::max(largest_uN, std::abs(difference->GetComponent(node, i)));
    }
  }
  EXPECT_GT(largest_uN, 1e-3);
  EXPECT_GE(result.variants.front().changes.largest_node_force_uN, largest_uN);
  EXPECT_TRUE(is->GetPointData()->HasArray("recorded_displacement_um"));
  EXPECT_TRUE(is->GetPointData()->HasArray("displacement_difference_um"));
  auto contours = now.load(step, SessionPart::kMembranes).shallow_copy();
  ASSERT_TRUE(contours->GetPointData()->HasArray("difference_um"));
  EXPECT_EQ(contours->GetPointData()->GetArray("difference_um")->GetRange()[1], 0.0);
  EXPECT_TRUE(fs::exists(at("fields") / "differences.csv"));
}

TEST_F(Counterfactual, TablesAloneHaveTheSameNumbers) {
  auto options = again(recorded(), Rerun::kMechanics);
  run_counterfactual(recorded(), options, {with_modulus(1.2, "whole")});
  options.tables_only = true;
  run_counterfactual(recorded(), options, {with_modulus(1.2, "tables")});
  expect_equal_rows(at("whole"), at("tables"));
  EXPECT_EQ(SessionReader(at("tables")).stated_counts().files(SessionPart::kSurface), 0U);
  EXPECT_EQ(check_session(at("tables"), false).problem_count, 0U);
}

TEST_F(Counterfactual, TheHeadTellsWhatWasReplayedAndWhatIsDifferent) {
  run_counterfactual(recorded(), again(recorded(), Rerun::kTracking), {with_modulus(1.5, "told")});
  const SessionInfo info = SessionReader(at("told")).info();
  const auto provenance = nlohmann::json::parse(info.provenance_json);
  EXPECT_EQ(provenance.at("replay").at("session"), recorded().string());
  EXPECT_EQ(provenance.at("replay").at("rerun"), "tracking");
  EXPECT_TRUE(provenance.at("replay").at("changes").contains("material.effective_young_modulus_kPa"));
  EXPECT_EQ(provenance.at("inputs_sha256").at("session_json").get<std::string>().size(), 64U);
  EXPECT_TRUE(provenance.at("versions").contains("Pellucida"));
  EXPECT_EQ(provenance.at("parameters").at("revolve_step_deg"), 10.0);
  // The same pixels went in.
  const auto before = nlohmann::json::parse(SessionReader(recorded()).info().provenance_json);
  EXPECT_EQ(provenance.at("frames_sha256"), before.at("frames_sha256"));
  EXPECT_EQ(provenance.at("frames_used").at("measured"), before.at("frames_used").at("measured"));
}

TEST_F(Counterfactual, AWholeSessionAsASourceIsMeasuredLikeTheOriginal) {
  SessionSource source(recorded(), {.all_frames = true});
  const auto result = run_batch(source, {.pipeline = recorded_options(source.session().info())}, {});
  const auto& rows = source.session().measurements();
  ASSERT_EQ(result.rows.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_TRUE(equal_as_written(rows[i], result.rows[i])) << i;
}

TEST_F(Counterfactual, APartWithoutItsPastIsAnotherMeasurement) {
  auto options = again(recorded(), Rerun::kMechanics);
  options.playback.from_s = 0.45;
  options.playback.every = 2;
  const auto result = run_counterfactual(recorded(), options, {same(recorded(), at("part"))});
  const SessionReader part(at("part"));
  EXPECT_GE(part.steps().front().time_s, 0.45);
  EXPECT_EQ(part.steps()[1].frame_index, part.steps()[0].frame_index + 2);
  EXPECT_EQ(result.variants.front().changes.frame_count, static_cast<int>(part.steps().size()));
}

TEST_F(Counterfactual, WhatIsMissingIsSaidAndKeepsItsRow) {
  fs::copy(recorded(), at("holes"), fs::copy_options::recursive);
  fs::remove(at("holes") / "membranes" / "membranes_00000003.vtp");
  const auto result =
      run_counterfactual(at("holes"), again(at("holes"), Rerun::kMechanics), {same(at("holes"), at("holes_again"))});
  EXPECT_EQ(result.absent_count, 1);
  EXPECT_NE(result.first_absence.find("frame 3"), std::string::npos) << result.first_absence;
  const SessionReader holes(at("holes_again"));
  ASSERT_EQ(holes.measurements().size(), SessionReader(recorded()).measurements().size());
  EXPECT_FALSE(holes.measurements()[3].state);
}

TEST_F(Counterfactual, RefusesWhatItCannotDo) {
  auto options = again(recorded(), Rerun::kMechanics);
  EXPECT_THROW(run_counterfactual(recorded(), options, {}), UsageError);
  options.playback.backwards = true;
  EXPECT_THROW(run_counterfactual(recorded(), options, {same(recorded(), at("never"))}), UsageError);
  options = again(recorded(), Rerun::kMechanics);
  EXPECT_THROW(run_counterfactual(recorded(), options, {same(recorded(), recorded())}), UsageError);
  options.playback.pixel_size_um = 0.5;
  EXPECT_THROW(run_counterfactual(recorded(), options, {same(recorded(), at("never"))}), UsageError);
  EXPECT_FALSE(fs::exists(at("never") / "session.json"));
}

TEST(ChangeFigures, TheirColumnsAreThoseOfThePage) {
  const std::string page = docs_section("file-format.md", "## A replayed session");
  for (const auto& column : change_columns()) {
    const std::string unit = column.unit.empty() ? "|" : "| " + std::string(column.unit) + " |";
    const std::string row = "| `" + std::string(column.name) + "` " + unit + (column.unit.empty() ? " | " : " ") +
                            std::string(column.doc) + " |";
    EXPECT_NE(page.find(row), std::string::npos) << row;
  }
  EXPECT_NE(page.find(ChangeLog::table_header().substr(0, 33)), std::string::npos);
}

TEST(RunProvenance, TheRecordedOptionsComeBack) {
  PipelineOptions options;
  options.revolve_step_deg = 15.0;
  options.tracker.quality = TrackerOptions::Quality::kHigh;
  options.tracker.contour_point_count = 128;
  SessionInfo info;
  CellProfile profile = load_profile("mouse-embryo");
  profile.effective_young_modulus_kPa /= 3.0;
  info.profile_json = to_json(profile);
  info.provenance_json = to_json(RunProvenance{}, options, profile);
  const ScaleMeasurement push{.known_force_uN = 1.5, .at_indentation_um = 12.0, .known_force_sigma_percent = 10.0};
  const ScaleMeasurement drawn{.suction_kPa = 2.0,
                               .tongue_um = 8.5,
                               .mouth_radius_um = 10.0,
                               .modulus_kPa = 31.0,
                               .modulus_sigma_percent = 14.0,
                               .modulus_of_profile_ratio = 1.28,
                               .since_s = 2.5};
  info.palpation_json = palpation_json({push, drawn}, {}, {});
  const PipelineOptions read = recorded_options(info);
  EXPECT_EQ(read.revolve_step_deg, 15.0);
  EXPECT_EQ(read.tracker.quality, TrackerOptions::Quality::kHigh);
  EXPECT_EQ(read.tracker.contour_point_count, 128);
  ASSERT_TRUE(read.given_profile);
  EXPECT_EQ(to_json(*read.given_profile), to_json(profile));
  ASSERT_EQ(read.scale_measurements.size(), 2U);
  EXPECT_EQ(read.scale_measurements[0].known_force_uN, 1.5);
  EXPECT_EQ(read.scale_measurements[0].at_indentation_um, 12.0);
  EXPECT_EQ(read.scale_measurements[0].known_force_sigma_percent, 10.0);
  EXPECT_EQ(way_of(read.scale_measurements[1]), ScaleWay::kAspiration);
  EXPECT_EQ(read.scale_measurements[1].modulus_kPa, 31.0);
  EXPECT_EQ(read.scale_measurements[1].since_s, 2.5);
  EXPECT_EQ(palpation_json(read.scale_measurements, {}, {}), info.palpation_json);
}

// A session may be anybody's.
TEST(RunProvenance, WordsOfAWrongTypeAreNoWords) {
  for (const char* tracker : {R"({"detection":5})", R"({"quality":[],"detection":{}})", "{}"}) {
    SessionInfo info;
    info.provenance_json = std::string(R"({"parameters":{"tracker":)") + tracker + "}}";
    const PipelineOptions read = recorded_options(info);
    EXPECT_EQ(read.tracker.detection, TrackerOptions::Detection::kLines) << tracker;
    EXPECT_EQ(read.tracker.quality, TrackerOptions::Quality::kLive) << tracker;
  }
}

// Earlier versions knew one push.
TEST(RunProvenance, APalpationOfAnEarlierVersionComesBack) {
  SessionInfo info;
  info.palpation_json =
      R"({"known_force_uN":0.7,"at_indentation_um":5.0,"known_relative_sigma":0.1,"cell_scale_ratio":1.2})";
  const PipelineOptions read = recorded_options(info);
  ASSERT_EQ(read.scale_measurements.size(), 1U);
  EXPECT_EQ(read.scale_measurements[0].known_force_uN, 0.7);
  EXPECT_EQ(read.scale_measurements[0].at_indentation_um, 5.0);
  EXPECT_NEAR(read.scale_measurements[0].known_force_sigma_percent, 10.0, 1e-9);
  info.palpation_json = R"({"measurements":[{"known_force_uN":0.7}]})";
  EXPECT_THROW(recorded_options(info), InputError);
}

}  // namespace
}  // namespace pellucida
