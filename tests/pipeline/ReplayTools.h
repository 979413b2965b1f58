#pragma once
#include <gtest/gtest.h>

#include <filesystem>

#include "pellucida/pipeline/Counterfactual.h"
#include "pellucida/pipeline/RunProvenance.h"
#include "pellucida/session/SessionReader.h"
#include "pellucida/simulation/Scenario.h"

namespace pellucida {

/// What a row read back may differ by from the number it was written from: forces are below 10 uN.
inline constexpr double kNineDigits = 1e-8;

/// A push of a second and a half: the shipped scenario, quicker.
inline Scenario quick_scenario(const char* name) {
  Scenario scenario = load_scenario(name);
  scenario.motion.approach_speed_um_per_s = 120.0;
  scenario.motion.indentation_speed_um_per_s = 60.0;
  scenario.motion.hold_s = 0.1;
  return scenario;
}

inline CounterfactualOptions again(const std::filesystem::path& session, Rerun rerun) {
  CounterfactualOptions options;
  options.rerun = rerun;
  options.pipeline = recorded_options(SessionReader(session).info());
  return options;
}

inline ReplayVariant same(const std::filesystem::path& session, const std::filesystem::path& folder) {
  return {.name = "same",
          .profile = profile_of(recorded_options(SessionReader(session).info())),
          .changes_json = {},
          .folder = folder};
}

inline void expect_equal_rows(const std::filesystem::path& session, const std::filesystem::path& replay) {
  const SessionReader recorded(session), replayed(replay);
  ASSERT_EQ(recorded.measurements().size(), replayed.measurements().size());
  for (std::size_t i = 0; i < recorded.measurements().size(); ++i) {
    Measurement one = recorded.measurements()[i], other = replayed.measurements()[i];
    one.frame_age_ms = other.frame_age_ms = Measurement::kNotMeasured;
    EXPECT_EQ(to_csv(one), to_csv(other));
  }
}

}  // namespace pellucida
