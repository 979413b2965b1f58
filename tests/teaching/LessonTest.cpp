// Lessons: the shipped ones are whole, their numbers are true; a damaged file says what is wrong with it.
#include "pellucida/teaching/Lesson.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/core/Resources.h"
#include "pellucida/membrane/Indenter.h"
#include "pellucida/teaching/PokedCell.h"
#include "support/DocsPage.h"

namespace pellucida {
namespace {

TEST(Lesson, TheShippedOnesAreWhole) {
  const auto lessons = all_lessons();
  ASSERT_GE(lessons.size(), 10u);
  const std::vector<std::string> scenarios = list_resources("scenarios", ".json");
  std::set<int> orders;
  for (const Lesson& lesson : lessons) {
    EXPECT_FALSE(lesson.title.empty()) << lesson.name;
    EXPECT_FALSE(lesson.text.empty()) << lesson.name;
    EXPECT_GE(lesson.answers.size(), 2u) << lesson.name;
    for (const auto& answer : lesson.answers) EXPECT_GT(answer.explanation.size(), 20u) << lesson.name;
    EXPECT_TRUE(orders.insert(lesson.order).second) << lesson.name << ": its place is taken";
    EXPECT_EQ(load_lesson(lesson.name).title, lesson.title);
    EXPECT_FALSE(lesson.to_do.empty()) << lesson.name;
    EXPECT_FALSE(lesson.observe.empty()) << lesson.name;
    EXPECT_EQ(std::count(scenarios.begin(), scenarios.end(), lesson.scenario), 1)
        << lesson.name << ' ' << lesson.scenario;
  }
}

// German ones: the same lessons, in other words.
TEST(Lesson, TheGermanOnesAreTheSameLessons) {
  const auto english = all_lessons(), german = all_lessons("lessons/de");
  ASSERT_EQ(german.size(), english.size());
  for (std::size_t k = 0; k < english.size(); ++k) {
    const Lesson &one = english[k], &other = german[k];
    EXPECT_EQ(other.name, one.name);
    EXPECT_NE(other.title, one.title);
    EXPECT_EQ(other.scenario, one.scenario) << one.name;
    EXPECT_EQ(other.hand_depth_um, one.hand_depth_um) << one.name;
    EXPECT_EQ(other.explains_tip, one.explains_tip) << one.name;
    TeachingParameters a = one.setting, b = other.setting;
    EXPECT_EQ(markdown(fields_of(a)), markdown(fields_of(b))) << one.name;
    EXPECT_EQ(other.page, one.page) << one.name;
    SnakeSetting snake_a = one.snake, snake_b = other.snake;
    EXPECT_EQ(markdown(fields_of(snake_a)), markdown(fields_of(snake_b))) << one.name;
    ReadoutParameters read_a = one.readouts, read_b = other.readouts;
    EXPECT_EQ(markdown(fields_of(read_a)), markdown(fields_of(read_b))) << one.name;
    EXPECT_EQ(other.text.size(), one.text.size()) << one.name;
    EXPECT_EQ(other.to_do.size(), one.to_do.size()) << one.name;
    EXPECT_EQ(other.observe.size(), one.observe.size()) << one.name;
    ASSERT_EQ(other.answers.size(), one.answers.size()) << one.name;
    for (std::size_t a_k = 0; a_k < one.answers.size(); ++a_k) {
      EXPECT_EQ(other.answers[a_k].is_right, one.answers[a_k].is_right) << one.name;
      EXPECT_NE(other.answers[a_k].explanation, one.answers[a_k].explanation) << one.name;
    }
  }
}

// The setting of each lesson moves the needle to where the lesson begins, without a blow-up.
TEST(Lesson, EachSettingRuns) {
  for (const Lesson& lesson : all_lessons()) {
    if (lesson_page(lesson.page) != LessonPage::kCell) continue;
    PokedCell cell(lesson.setting);
    cell.set_hand(lesson.hand_depth_um, 0.0);
    while (cell.time_s() < 0.6 && cell.step()) {
    }
    EXPECT_FALSE(cell.blow_up()) << lesson.name;
    const double give_um = lesson.setting.hand_give_um_per_uN * cell.push_force_uN();
    EXPECT_NEAR(cell.depth_um() + give_um, lesson.hand_depth_um, 1.0) << lesson.name;
  }
}

TEST(Lesson, AnUnknownOneListsThoseThereAre) {
  try {
    load_lesson("no-such-lesson");
    FAIL() << "an unknown lesson was found";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("spring-network"), std::string::npos) << error.what();
  }
}

class DamagedLesson : public testing::Test {
 protected:
  static std::string fault_of(const std::string& from, const std::string& to) {
    std::ostringstream whole;
    whole << std::ifstream(PELLUCIDA_SOURCE_DIR "/resources/lessons/spring-network.json").rdbuf();
    std::string text = whole.str();
    const auto place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    const auto file = std::filesystem::path(testing::TempDir()) / "damaged-lesson.json";
    std::ofstream(file) << text;
    try {
      read_lesson(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(DamagedLesson, SaysWhatIsWrong) {
  EXPECT_EQ(fault_of("pellucida-lesson", "pellucida-lesson"), "");
  EXPECT_NE(fault_of("pellucida-lesson", "recipe").find("schema"), std::string::npos);
  EXPECT_NE(fault_of("\"title\"", "\"name\"").find("title"), std::string::npos);
  EXPECT_NE(fault_of("\"setting\": {", "\"setting\": {\"gravity\": 9.81,").find("setting: gravity"), std::string::npos);
  EXPECT_NE(fault_of("\"setting\": {", "\"setting\": {\"time_step_us\": -1,").find("time_step_us"), std::string::npos);
  EXPECT_NE(fault_of("\"right\": true", "\"right\": false").find("one of them must be right"), std::string::npos);
  EXPECT_NE(fault_of("\"scenario\"", "\"page\": \"film\", \"scenario\"").find("page film"), std::string::npos);
  EXPECT_NE(fault_of("\"setting\": {", "\"page\": \"snake\", \"setting\": {").find("snake must be a group"),
            std::string::npos);
  EXPECT_NE(fault_of("\"setting\": {", "\"snake\": {\"gamma\": 0}, \"setting\": {").find("gamma"), std::string::npos);
  EXPECT_NE(fault_of("\"do\": [", "\"do\": 7, \"was\": [").find("do must be a list"), std::string::npos);
}

double force_uN(TeachingParameters p, double depth_um) {
  const CellProfile profile = profile_of(p);
  return Indenter(profile, setup_of(profile, p)).advance_to(depth_um).push_force_uN;
}

// What the lessons say in numbers, computed.
TEST(Lesson, TheirNumbersAreTrue) {
  const TeachingParameters oocyte;
  ASSERT_EQ(oocyte.mesh_frequency, 9);
  EXPECT_NEAR(force_uN(oocyte, 44.0), 7.5, 0.05);
  EXPECT_NEAR(force_uN(oocyte, 40.0), 6.3, 0.05);
  EXPECT_NEAR(force_uN(oocyte, 30.0), 3.7, 0.05);
  EXPECT_NEAR(force_uN(oocyte, 10.0), 1.03, 0.005);
  EXPECT_NEAR(force_uN(oocyte, 45.0) - force_uN(oocyte, 44.0), 0.3, 0.05);
  TeachingParameters leaking = oocyte;
  leaking.keeps_volume = false;
  EXPECT_NEAR(force_uN(leaking, 44.0), 1.9, 0.05);
  EXPECT_NEAR(force_uN(leaking, 10.0), 0.89, 0.005);
  TeachingParameters embryo = oocyte;
  embryo.profile = "mouse-embryo";
  EXPECT_NEAR(force_uN(embryo, 30.0), 4.6, 0.05);
  EXPECT_NEAR(profile_of(oocyte).effective_young_modulus_kPa, 141.0, 0.5);
  EXPECT_NEAR(profile_of(embryo).effective_young_modulus_kPa, 179.0, 0.5);
  EXPECT_EQ(profile_of(oocyte).mid_radius_um, profile_of(embryo).mid_radius_um);
  TeachingParameters coarse = oocyte;
  coarse.mesh_frequency = 6;
  EXPECT_NEAR(force_uN(coarse, 44.0), 9.6, 0.05);
  coarse.mesh_frequency = 4;
  EXPECT_NEAR(force_uN(coarse, 44.0), 12.8, 0.05);
  const CellProfile profile = profile_of(leaking);
  Indenter leak(profile, setup_of(profile, leaking));
  EXPECT_NEAR(leak.advance_to(40.0).volume_um3 / leak.model().volume().rest_volume_um3(), 7.0 / 8.0, 0.005);
  const double limit_s = PokedCell(load_lesson("time-steps").setting).stability().stable_step_s;
  EXPECT_NEAR(1e6 * limit_s, 146.0, 0.5);
}

// The lessons on contours, punctures, delays and fixtures.
TEST(Lesson, TheirFurtherNumbersAreTrue) {
  const TeachingParameters oocyte;
  const CellProfile profile = profile_of(oocyte);
  // from-contour-to-3d: a radius one hundredth larger.
  CellProfile wider = profile;
  wider.mid_radius_um *= 1.01;
  const double volume_um3 = Indenter(profile, setup_of(profile, oocyte)).model().volume().rest_volume_um3();
  const double wider_um3 = Indenter(wider, setup_of(wider, oocyte)).model().volume().rest_volume_um3();
  EXPECT_NEAR(wider_um3 / volume_um3, 1.030, 0.001);
  // puncture: the work up to it, by trapezia of 1 um; latency-and-passivity: 5 um further on.
  Indenter needle(profile, setup_of(profile, oocyte));
  std::vector<double> forces_uN{0.0}, works_pJ{0.0};
  for (int depth_um = 1; depth_um <= 44; ++depth_um) {
    forces_uN.push_back(needle.advance_to(depth_um).push_force_uN);
    works_pJ.push_back(works_pJ.back() + 0.5 * (forces_uN.back() + forces_uN[forces_uN.size() - 2]));
  }
  EXPECT_NEAR(works_pJ[44], 125.0, 1.0);
  EXPECT_LT(works_pJ[44], 0.5 * 7.5 * 44.0);
  EXPECT_NEAR(works_pJ[44] - works_pJ[39], 34.0, 0.6);
  EXPECT_NEAR(forces_uN[44] - forces_uN[39], 1.5, 0.05);
  // why-fixtures-help: the cell does not hold the tip back sideways.
  EXPECT_NEAR(100.0 * std::tan(5.0 * std::numbers::pi / 180.0), 8.7, 0.05);
  const auto pushed = [](double across_um) {
    PokedCell cell(load_lesson("why-fixtures-help").setting);
    cell.set_hand(20.0, across_um);
    while (cell.time_s() < 3.0 && cell.step()) {
    }
    return std::pair(cell.potential_energy_pJ(), cell.push_force_uN());
  };
  const auto straight = pushed(0.0), beside = pushed(8.7);
  EXPECT_NEAR(beside.first - straight.first, 0.6, 0.1);
  EXPECT_NEAR(beside.second / straight.second, 0.98, 0.005);
}

// Lesson "invented-mass": the force overshoots and pulls on the way in, and still swings half a second later.
TEST(Lesson, InventedMassRings) {
  const Lesson lesson = load_lesson("invented-mass");
  const double rest_uN = force_uN(lesson.setting, lesson.hand_depth_um);
  PokedCell cell(lesson.setting);
  cell.set_hand(lesson.hand_depth_um, 0.0);
  double least_uN = 0.0, late_least_uN = rest_uN, late_most_uN = rest_uN;
  while (cell.time_s() < 0.8) {
    ASSERT_TRUE(cell.step());
    least_uN = std::min(least_uN, cell.push_force_uN());
    if (cell.time_s() < 0.5) continue;
    late_least_uN = std::min(late_least_uN, cell.push_force_uN());
    late_most_uN = std::max(late_most_uN, cell.push_force_uN());
  }
  EXPECT_LT(least_uN, -1.0);
  EXPECT_LT(late_least_uN, 0.9 * rest_uN);
  EXPECT_GT(late_most_uN, 1.1 * rest_uN);
}

// The page of the keys is printed from the tables.
TEST(Lesson, TheDocumentationNamesEveryKey) {
  Lesson lesson;
  EXPECT_TRUE(docs_section_is(
      "lessons.md", "## Keys",
      markdown(fields_of(lesson)) + "\nof `setting`:\n\n" + markdown(fields_of(lesson.setting)) + "\nof `snake`:\n\n" +
          markdown(fields_of(lesson.snake)) + "\nof `readouts`:\n\n" + markdown(fields_of(lesson.readouts))));
}

}  // namespace
}  // namespace pellucida
