#include "presenters/SoundCue.h"

#include <gtest/gtest.h>

#include <vector>

namespace pellucida {
namespace {

std::vector<Gauge> gauges(GaugeLevel level) {
  std::vector<Gauge> two(2);
  two[1].level = level;
  return two;
}

TEST(SoundCue, ContactAndPunctureSoundAsTheyHappen) {
  CueFinder cues;
  const auto calm = gauges(GaugeLevel::kCalm);
  EXPECT_FALSE(cues.take({}, calm, 0.0));
  const std::vector<Event> touch{{1.0, event_kind::kContact, ""}}, hole{{2.0, event_kind::kPuncture, ""}},
      note{{2.0, event_kind::kNote, "puncture"}};
  EXPECT_EQ(cues.take(touch, calm, 1.0), SoundCue::kContact);
  EXPECT_EQ(cues.take(hole, calm, 2.0), SoundCue::kPuncture);
  EXPECT_FALSE(cues.take(note, calm, 3.0));
}

TEST(SoundCue, AnAlarmSoundsWhenItBeginsAndNotTooOften) {
  CueFinder cues;
  EXPECT_FALSE(cues.take({}, gauges(GaugeLevel::kNone), 0.0)) << "nothing is known yet at the start";
  EXPECT_FALSE(cues.take({}, gauges(GaugeLevel::kNear), 1.0));
  EXPECT_EQ(cues.take({}, gauges(GaugeLevel::kOver), 2.0), SoundCue::kAlarm);
  EXPECT_FALSE(cues.take({}, gauges(GaugeLevel::kOver), 2.1)) << "it goes on";
  EXPECT_FALSE(cues.take({}, gauges(GaugeLevel::kCalm), 2.2));
  EXPECT_FALSE(cues.take({}, gauges(GaugeLevel::kNone), 2.3)) << "too soon";
  EXPECT_FALSE(cues.take({}, gauges(GaugeLevel::kCalm), 5.0));
  const std::vector<Event> hole{{6.0, event_kind::kPuncture, ""}};
  EXPECT_EQ(cues.take(hole, gauges(GaugeLevel::kNone), 6.0), SoundCue::kAlarm) << "the graver one";
}

}  // namespace
}  // namespace pellucida
