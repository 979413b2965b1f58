#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/core/Event.h"
#include "pellucida/core/ForceRemarks.h"
#include "pellucida/core/Measurement.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/session/SessionReader.h"

namespace pellucida {

/// What the window keeps of a session at hand: head and tables, none of the data files. Steps are numbered from 0.
struct RecordedSession {
  std::filesystem::path folder;
  SessionInfo info;
  std::string created;  ///< UTC; may be empty
  bool complete = false;
  bool head_changed = false;
  std::size_t skipped_row_count = 0;
  std::vector<Measurement> rows;         ///< one a step
  std::vector<double> times_s;           ///< of the steps, never falling, whatever the file says
  std::vector<std::size_t> image_steps;  ///< those with an image, ascending
  std::vector<Event> events;             ///< in the order of time
  double scale_ratio = 1.0;              ///< this cell's stiffness over its kind's, if it was measured
  CellProfile profile;                   ///< the forces' own; of a session that holds none, only the name

  std::size_t step_count() const noexcept { return rows.size(); }
  double begin_s() const noexcept { return times_s.empty() ? 0.0 : times_s.front(); }
  double end_s() const noexcept { return times_s.empty() ? 0.0 : times_s.back(); }
  /// The last step that isn't later than `time_s`; the first for an earlier time, 0 without steps.
  std::size_t step_at(double time_s) const noexcept;
  /// The step with an image that is nearest to `time_s` in time; nothing where no step has one.
  std::optional<std::size_t> image_step_at(double time_s) const noexcept;
  /// The part of the image round the cell, whatever the frame: x, y, width, height, um; nothing where no cell was seen.
  std::optional<std::array<double, 4>> cell_region_um() const;
  /// Half the steps are no further from the next one, s; 0 for fewer than two.
  double usual_step_s() const;
};

/// Takes over head and tables. Throws InputError for a session without a row.
RecordedSession recorded_session(const SessionReader& reader);

/// What is known of the scale in a row's frame, into its remarks.
void add_scale(const RecordedSession& session, const Measurement& row, ForceRemarks& remarks);

/// The line of facts: "2026-11-20 20:15 UTC · mouse-oocyte · 0.825 µm/px · 312 frames · complete".
std::string session_facts(const RecordedSession& session);
/// What a person should know before trusting it, in one line: interrupted, changed, rows skipped; empty for nothing.
std::string session_caution(const RecordedSession& session);
/// The folder's name without its path.
std::string session_name_of(const std::filesystem::path& folder);

}  // namespace pellucida
