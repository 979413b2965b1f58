// Histograms, tables of what is seen, cells of several sessions, the model's curve of a touch: without a window.
#include <gtest/gtest.h>

#include <cmath>

#include "Measured.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/membrane/CellProfile.h"
#include "presenters/CellTable.h"
#include "presenters/ChartForPrint.h"
#include "presenters/Histogram.h"
#include "presenters/SeenTables.h"
#include "presenters/SessionCurves.h"
#include "presenters/TouchModel.h"
#include "review/TouchSession.h"
#include "support/Files.h"

namespace pellucida {
namespace {

using namespace test;

// A push of a micrometre a frame, and back where `back`.
RecordedSession pushed(int deepest_um, bool back) {
  RecordedSession session;
  const auto add = [&](CellState state, double depth_um) {
    Measurement row;
    row.frame = static_cast<long>(session.rows.size());
    row.time_s = 0.1 * static_cast<double>(session.rows.size());
    row.state = state;
    row.contact_force_uN = state == CellState::kContact ? 0.1 * depth_um : 0.0;
    row.contact_force_lower_uN = 0.08 * depth_um;
    row.contact_force_upper_uN = 0.12 * depth_um;
    row.indentation_um = depth_um;
    row.confidence = 0.9;
    session.rows.push_back(row);
    session.times_s.push_back(row.time_s);
  };
  add(CellState::kFree, 0.0);
  for (int k = 1; k <= deepest_um; ++k) add(CellState::kContact, k);
  for (int k = deepest_um - 1; back && k > 0; --k) add(CellState::kContact, k);
  add(CellState::kFree, 0.0);
  return session;
}

TEST(SessionCurves, TheWayBackIsACurveOfItsOwn) {
  const RecordedSession session = pushed(10, true);
  EXPECT_EQ(turning_step(session, 1), 10U);
  const CurveChartData drawn = force_over_indentation(session, 5);
  EXPECT_EQ(drawn.curve.size(), 10U);
  EXPECT_EQ(drawn.curve_name, "Loading");
  ASSERT_EQ(drawn.named.size(), 1U);
  EXPECT_EQ(drawn.named[0].name, "Unloading");
  EXPECT_EQ(drawn.named[0].role, CurveRole::kBack);
  EXPECT_EQ(drawn.named[0].curve.x.front(), 10.0);
  EXPECT_EQ(drawn.named[0].curve.x.back(), 1.0);
  // Dashed in print too, and named.
  const ChartPanel panel = chart_for_print(drawn, "t");
  int dashed = 0;
  for (const ChartSeries& series : panel.series) dashed += series.style == ChartStyle::kDashedLine ? 1 : 0;
  EXPECT_EQ(dashed, 1);
  // A needle that stays where it is has no way back.
  EXPECT_TRUE(force_over_indentation(pushed(10, false), 5).named.empty());
}

TEST(Histogram, CountsEveryNumberOnceInRoundIntervals) {
  const Sample sample = sample_of(pushed(40, true), Quantity::kForce);
  ASSERT_EQ(sample.values.size(), 79U);
  EXPECT_TRUE(std::is_sorted(sample.values.begin(), sample.values.end()));
  const Histogram histogram = histogram_of(sample);
  std::size_t all = 0;
  for (const std::size_t count : histogram.counts) all += count;
  EXPECT_EQ(all, 79U);
  EXPECT_GE(histogram.counts.size(), 4U);
  EXPECT_LE(histogram.begin, sample.values.front());
  EXPECT_GT(histogram.begin + histogram.width * static_cast<double>(histogram.counts.size()), sample.values.back());
  const double power = std::pow(10.0, std::floor(std::log10(histogram.width) + 1e-9));
  const double first = std::round(histogram.width / power);
  EXPECT_TRUE(first == 1.0 || first == 2.0 || first == 5.0) << histogram.width;
}

TEST(Histogram, TheChartIsItsStepsWithMedianAndQuartiles) {
  const Sample sample = sample_of(pushed(40, true), Quantity::kIndentation);
  const CurveChartData drawn = histogram_chart(sample);
  EXPECT_EQ(drawn.x_title, "Indentation (µm)");
  EXPECT_EQ(drawn.y_title, "Frames");
  ASSERT_EQ(drawn.marks.size(), 3U);
  EXPECT_EQ(drawn.marks[1].name, "median");
  EXPECT_DOUBLE_EQ(drawn.marks[1].x, 20.0);
  EXPECT_EQ(histogram_facts(sample), "79 frames · median 20 µm · quartiles 10.5 to 30 · 5 to 95 %: 2.9 to 38");
  const TemporaryFolder out;
  write_histogram(sample, out / "h.csv");
  EXPECT_EQ(text_of(out / "h.csv").rfind("indentation_um_from,indentation_um_to,count\n0,", 0), 0U);
}

TEST(Histogram, OneNumberOrNoneIsNoError) {
  EXPECT_TRUE(histogram_of({Quantity::kForce, {}}).counts.empty());
  EXPECT_EQ(histogram_facts({Quantity::kForce, {}}), "No frame has this number");
  EXPECT_TRUE(histogram_chart({Quantity::kNodeForce, {}}).curve.empty());
  EXPECT_EQ(histogram_of({Quantity::kForce, {2.5}}).counts.size(), 1U);
  EXPECT_TRUE(sample_of(nullptr, Quantity::kNodeForce).values.empty());
}

TEST(SeenTables, HoldTheRowTheNodesAndTheCurves) {
  const TemporaryFolder out;
  write_touch(out / "S");
  const SessionReader reader(out / "S");
  const RecordedSession session = recorded_session(reader);
  const Scene scene = reader.load(20);
  const auto surface = scene.surface.shallow_copy();
  SeenFrame frame{session.rows[20], surface, 7, {{"force-time", force_over_time(session)}}};
  write_seen(frame, out / "seen");
  for (const auto& file : seen_files(frame, out / "seen")) EXPECT_TRUE(std::filesystem::exists(file)) << file;
  EXPECT_NE(text_of(out / "seen" / "frame.csv").find("\n20,2,contact"), std::string::npos);
  const std::string nodes = text_of(out / "seen" / "nodes.csv");
  EXPECT_NE(nodes.find("\n7,1,"), std::string::npos);
  EXPECT_EQ(std::count(nodes.begin(), nodes.end(), '\n'), surface->GetNumberOfPoints() + 1);
  EXPECT_EQ(text_of(out / "seen" / "force-time.csv").rfind("curve,Time (s),Force (µN),lower,upper\n", 0), 0U);
}

TEST(CellTable, JoinsSessionsWithTheirGroups) {
  const TemporaryFolder out;
  write_touch(out / "control" / "a");
  write_touch(out / "control" / "b");
  write_touch(out / "treated" / "c");
  const auto sessions = sessions_in(out.path());
  ASSERT_EQ(sessions.size(), 3U);
  EXPECT_EQ(sessions[0].group, "control");
  EXPECT_EQ(sessions[2].group, "treated");
  CellTable table;
  for (const auto& session : sessions) table.add(cells_of(session));
  ASSERT_EQ(table.rows().size(), 3U);
  // A session that is added again is there once.
  table.add(cells_of(sessions[1]));
  ASSERT_EQ(table.rows().size(), 3U);
  const std::size_t peak = 4;
  EXPECT_EQ(CellTable::column_title(peak), "Peak force (µN)");
  EXPECT_NEAR(table.entry(0, peak).number, table.rows()[0].passport.main_contact().peak_force_uN, 1e-12);
  EXPECT_EQ(table.entry(0, 8).text, "–") << "never punctured";
  const auto groups = table.groups(peak);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].count, 2);
  EXPECT_DOUBLE_EQ(groups[0].median, table.entry(0, peak).number);
  EXPECT_TRUE(table.groups(0).empty()) << "no quantity";
  table.write(out / "all.csv");
  const std::string text = text_of(out / "all.csv");
  EXPECT_EQ(text.rfind("group,session,profile,cell,", 0), 0U);
  EXPECT_NE(text.find("\ntreated,c,mouse-oocyte,1,"), std::string::npos) << text;
  table.remove(0);
  EXPECT_EQ(table.rows().size(), 2U);
  EXPECT_THROW(sessions_in(out / "nowhere"), InputError);
}

TEST(TouchModel, ASessionWithoutItsProfileHasNoModel) {
  const TemporaryFolder out;
  write_touch(out / "S");
  const RecordedSession session = recorded_session(SessionReader(out / "S"));
  EXPECT_TRUE(touch_model(session, 1, [] { return true; }).curves.empty());
}

TEST(TouchModel, ReachesAsDeepAsTheTouch) {
  const TemporaryFolder out;
  write_touch(out / "S");
  RecordedSession session = recorded_session(SessionReader(out / "S"));
  session.profile = load_profile("mouse-oocyte");
  const TouchModel model = touch_model(session, 1, [] { return true; });
  ASSERT_FALSE(model.curves.empty());
  for (const NamedCurve& curve : model.curves) {
    EXPECT_EQ(curve.curve.x.back(), 20.0) << curve.name;
    EXPECT_GT(curve.curve.y.back(), 0.5);
    EXPECT_EQ(curve.curve.y.front(), 0.0);
  }
  EXPECT_TRUE(touch_model(session, 0, [] { return true; }).curves.empty()) << "before the first touch";
}

Annotation places(std::initializer_list<Annotation::Place> all) {
  Annotation note;
  note.place_um = *all.begin();
  note.further_um.assign(all.begin() + 1, all.end());
  return note;
}

TEST(Measured, DistancesAndAnglesHaveTheClicksInterval) {
  const auto distance = measured(places({{10.0, 10.0}, {13.0, 14.0}}), 0.8);
  ASSERT_TRUE(distance);
  EXPECT_DOUBLE_EQ(distance->value, 5.0);
  EXPECT_NEAR(distance->half_width, 1.959964 * std::sqrt(2.0) * 0.4, 1e-6);
  EXPECT_EQ(words_of(*distance), "Distance 5.0 ± 1.1 µm");
  const auto angle = measured(places({{100.0, 0.0}, {0.0, 0.0}, {0.0, 50.0}}), 0.8);
  ASSERT_TRUE(angle && angle->is_angle);
  EXPECT_DOUBLE_EQ(angle->value, 90.0);
  // Each end turns its leg; the vertex turns both.
  const double sigma_rad = 0.4 * std::sqrt(1e-4 + 4e-4 + 12500.0 / 25e6);
  EXPECT_NEAR(angle->half_width, 1.959964 * sigma_rad * 180.0 / M_PI, 1e-6);
  EXPECT_EQ(measured(places({{0.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}}), 0.8)->half_width, 180.0) << "no angle at all";
  EXPECT_FALSE(measured(Annotation{}, 0.8));
}

TEST(Measured, IsKeptInTheSessionAndReadBack) {
  const TemporaryFolder out;
  Annotation angle = places({{1.5, 2.0}, {3.0, 4.0}, {5.0, 6.0}});
  angle.time_s = 2.0;
  Annotation note;
  note.time_s = 1.0;
  note.text = "a, b";
  write_annotations(out.path(), {angle, note});
  const auto read = read_annotations(out.path());
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].text, "a, b");
  EXPECT_TRUE(read[0].further_um.empty());
  ASSERT_EQ(read[1].further_um.size(), 2U);
  EXPECT_EQ(read[1].further_um[1].y_um, 6.0);
  // Without a measurement the file is as earlier versions know it.
  write_annotations(out.path(), {note});
  EXPECT_EQ(text_of(out / kAnnotationsFile).rfind("time_s,x_um,y_um,node,text\n", 0), 0U);
  write_measured({angle, note}, 0.8, out / "m.csv");
  EXPECT_NE(text_of(out / "m.csv").find("\n2,angle,,"), std::string::npos);
}

}  // namespace
}  // namespace pellucida
