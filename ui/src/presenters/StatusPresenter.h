#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "pellucida/core/Measurement.h"
#include "pellucida/pipeline/LiveRun.h"
#include "pellucida/visualization/Palette.h"

namespace pellucida {

/// A text and the colour it is written in.
struct Phrase {
  std::string text;
  Color color = palette::kText;
};

/// Everything the readouts and the status line say, UTF-8.
struct StatusTexts {
  Phrase state;  ///< its colour is the pill's ground
  Phrase indentation;
  Phrase force;
  std::string force_interval;  ///< "95 %: 3.10 – 3.75 µN", or that there is none; empty without a force
  Phrase pressure;
  Phrase confidence;
  Phrase frame_age;
  Phrase frame_rate;
  Phrase lost;  ///< frames not measured, lost by the source, lost to the recorder
  Phrase recording;
  Phrase notice;  ///< one line: what went wrong, or the state of the run; may be empty
};

/// Turns a run's status and newest row into words. Knows no widgets; one thread.
class StatusPresenter {
 public:
  /// `now_s` is any monotonic clock, for the frame rate. Without a row the readouts are dashes.
  StatusTexts update(const LiveStatus& status, const std::optional<Measurement>& row, bool paused, double now_s);

 private:
  double frames_per_s(std::uint64_t measured_count, double now_s);

  std::deque<std::pair<double, std::uint64_t>> counts_;  // (time, measured frames) of the last two seconds
};

}  // namespace pellucida
