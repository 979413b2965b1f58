#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/charts_vtk/CurveChart.h"
#include "presenters/RecordedSession.h"

namespace pellucida {

/// Which frames of two sessions belong together.
enum class Alignment {
  kTime,         ///< as long after the beginning: a session and what was computed from it
  kContact,      ///< as long after the contact of the touch with the same number
  kIndentation,  ///< as deep in that touch, on the way in or on the way out
};
inline constexpr std::array kAlignments{Alignment::kTime, Alignment::kContact, Alignment::kIndentation};
/// "same time", "time since contact", "same indentation".
std::string name_of(Alignment alignment);

/// A line of the table beside the views. `difference`: the other session's number less this one's; may be empty.
struct ComparisonRow {
  std::string name, shown, other, difference;
};

/// Two recorded sessions, frame against frame: the one shown, and another one. Both must outlive it.
class SessionComparison {
 public:
  SessionComparison(const RecordedSession& shown, const RecordedSession& other);

  const RecordedSession& shown() const noexcept { return shown_; }
  const RecordedSession& other() const noexcept { return other_; }

  /// The other session's step for a step of the one shown; nothing where it has none: it ended before, has fewer
  /// touches, or did not go as deep.
  std::optional<std::size_t> partner(std::size_t step, Alignment alignment) const;

  /// State, time, indentation, force, pressure and confidence of both. A dash without a partner.
  std::vector<ComparisonRow> rows(std::size_t step, std::optional<std::size_t> partner) const;

  /// The other session's force at the place on the time axis of the one shown where its partners are. By indentation:
  /// as by contact.
  Curve other_over_time(Alignment alignment) const;
  /// The other session's force over indentation, in the touch that `step` belongs to.
  Curve other_over_indentation(std::size_t step) const;

  /// The other session's force less this one's, over this session's time, or by indentation over the way in of the
  /// touch that `step` belongs to. The 95 % interval takes the errors of both as independent: too wide where they are
  /// shared, as those of a session and what was computed from it are.
  CurveChartData difference(std::size_t step, Alignment alignment) const;
  /// The whole of it as a table, with units in its names: time or indentation, both forces with their intervals, the
  /// difference with its own. Throws OutputError where the file can't be written.
  void write_difference(std::size_t step, Alignment alignment, const std::filesystem::path& file) const;

 private:
  struct Touch {
    std::size_t first = 0, last = 0, deepest = 0;  // steps
    double begin_s = 0.0;
    std::vector<double> reached_um;  // the greatest depth so far, from `first` to `deepest`
  };
  struct Track {
    std::vector<std::size_t> touch_of_step;  // 0: before the first one
    std::vector<Touch> touches;
  };
  struct Pair {
    double x = 0.0;
    const Measurement* shown = nullptr;
    const Measurement* other = nullptr;
  };
  static Track track_of(const RecordedSession& session);
  const Touch* touch(const Track& track, std::size_t number) const;
  std::optional<std::size_t> as_deep(std::size_t step) const;
  std::vector<Pair> pairs(std::size_t step, Alignment alignment) const;

  const RecordedSession& shown_;
  const RecordedSession& other_;
  Track shown_track_, other_track_;
  double half_step_s_ = 0.0;  // of the other session
};

}  // namespace pellucida
