// Lessons: the shipped ones are whole, their numbers are true; a damaged file says what is wrong with it.
#include "pellucida/teaching/Lesson.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "pellucida/core/Error.h"
#include "support/DocsPage.h"

namespace pellucida {
namespace {

TEST(Lesson, TheShippedOnesAreWhole) {
  const auto lessons = all_lessons();
  ASSERT_GE(lessons.size(), 4u);
  std::set<int> orders;
  for (const Lesson& lesson : lessons) {
    EXPECT_FALSE(lesson.title.empty()) << lesson.name;
    EXPECT_FALSE(lesson.text.empty()) << lesson.name;
    EXPECT_GE(lesson.answers.size(), 2u) << lesson.name;
    for (const auto& answer : lesson.answers) EXPECT_GT(answer.explanation.size(), 20u) << lesson.name;
    EXPECT_TRUE(orders.insert(lesson.order).second) << lesson.name << ": its place is taken";
    EXPECT_EQ(load_lesson(lesson.name).title, lesson.title);
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
  EXPECT_NE(fault_of("\"do\": [", "\"do\": 7, \"was\": [").find("do must be a list"), std::string::npos);
}

// The page of the keys is printed from the tables.
TEST(Lesson, TheDocumentationNamesEveryKey) {
  Lesson lesson;
  EXPECT_TRUE(docs_section_is("lessons.md", "## Keys",
                              markdown(fields_of(lesson)) + "\nof `setting`:\n\n" + markdown(fields_of(lesson.setting))));
}

}  // namespace
}  // namespace pellucida
