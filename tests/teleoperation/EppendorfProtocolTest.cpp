#include "pellucida/teleoperation/EppendorfProtocol.h"

#include <gtest/gtest.h>

#include <random>

namespace pellucida {
namespace {

TEST(EppendorfProtocol, WritesCommandsAsTheManualDoes) {
  EXPECT_EQ(eppendorf_command(EppendorfCode::kVersion), "C001\r");
  EXPECT_EQ(eppendorf_command(EppendorfCode::kPositionMicrometres), "C010\r");
  EXPECT_EQ(eppendorf_go_to(EppendorfCode::kGoToMicrometres, {100, -200, 300}, {1000, 0, 50}),
            "C012 100 -200 300 1000 0 50\r");
}

TEST(EppendorfProtocol, ReadsNumbersPartedBySpacesOrSigns) {
  for (const char* line :
       {"A010 100 -200 300 0", "A010 100-200+300 0", "A010+100-200+300+0", " A010  100  -200  +300  0 "}) {
    const auto answer = eppendorf_answer(line);
    ASSERT_TRUE(answer) << line;
    EXPECT_EQ(answer->code, 10);
    const auto position = eppendorf_position(*answer);
    ASSERT_TRUE(position) << line;
    EXPECT_EQ(position->coordinates, (std::array<long, 3>{100, -200, 300}));
    EXPECT_EQ(position->limit_switches, 0);
  }
}

TEST(EppendorfProtocol, KeepsTextThatIsNoNumber) {
  const auto answer = eppendorf_answer("A001 5181 V1.08");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->text, "5181 V1.08");
  EXPECT_EQ(answer->number_count, 0u);
}

TEST(EppendorfProtocol, RefusesWhatIsNoAnswer) {
  for (const char* line : {"", "A", "A01", "C010", "B010 1 2 3 4", "A0101", "A01x", "A-01", "hello"}) {
    EXPECT_FALSE(eppendorf_answer(line)) << line;
  }
  for (const char* line : {"A010", "A010 1 2 3", "A010 1 2 3 4 5", "A010 1 2 3 x", "A010 1,2,3,4", "A010 1 2 3 -",
                           "A010 99999999999999999999 2 3 4", "A010 1.5 2 3 4"}) {
    const auto answer = eppendorf_answer(line);
    ASSERT_TRUE(answer) << line;
    EXPECT_FALSE(eppendorf_position(*answer)) << line;
  }
}

TEST(LineSplitter, TakesAnyLineEndAndBytesOneByOne) {
  LineSplitter lines;
  for (const char c : std::string("A012\r\nA010 1 2 3 0\nA0")) lines.push({&c, 1});
  EXPECT_EQ(lines.next(), "A012");
  EXPECT_EQ(lines.next(), "A010 1 2 3 0");
  EXPECT_FALSE(lines.next());
  lines.push("08\r");
  EXPECT_EQ(lines.next(), "A008");
}

TEST(LineSplitter, DropsEndlessNoiseAndFindsTheNextLine) {
  LineSplitter lines;
  lines.push(std::string(100000, 'x'));
  EXPECT_FALSE(lines.next());
  lines.push("\rA008\r");
  EXPECT_EQ(lines.next(), "A008");
  EXPECT_EQ(lines.dropped_count(), 1u);
}

TEST(EppendorfProtocol, AnyBytesAreReadWithoutHarmAndWhatIsReadIsInRange) {
  std::mt19937 random(7);
  // Bytes a noisy line would give, rich in those that mean something.
  const std::string alphabet = "A0123456789 +-\r\nCx\xff";
  std::size_t answer_count = 0;
  LineSplitter lines;
  for (int i = 0; i < 200000; ++i) {
    const char byte = i % 7 == 0 ? 'A' : i % 7 == 4 ? '\r' : alphabet[random() % alphabet.size()];
    lines.push({&byte, 1});
    while (const auto line = lines.next()) {
      ASSERT_LE(line->size(), LineSplitter::kMaxLength);
      const auto answer = eppendorf_answer(*line);
      if (!answer) continue;
      ++answer_count;
      ASSERT_GE(answer->code, 0);
      ASSERT_LE(answer->code, 999);
      ASSERT_LE(answer->number_count, EppendorfAnswer::kMaxNumbers);
      for (const long number : answer->numbers) ASSERT_LE(std::abs(number), 1'000'000'000);
    }
  }
  EXPECT_GT(answer_count, 100u);
}

}  // namespace
}  // namespace pellucida
