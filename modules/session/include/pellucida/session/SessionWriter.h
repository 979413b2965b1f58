#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "pellucida/core/Event.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/session/SessionInfo.h"
#include "pellucida/session/StepParts.h"

namespace pellucida {

/// Writes a session folder (docs/file-format.md) as the session proceeds.
///
/// A file appears under its name only when it is complete; a row of a table is passed to the system as soon as it is
/// known, after the files it refers to; a thread of the writer's own flushes everything to disk every half second. So a
/// power cut loses at most the last second, and a crash of the program only the step being written; `check_session`
/// repairs the rest.
///
/// One thread at a time. Each call writes before it returns.
class SessionWriter {
 public:
  /// Creates the folder (with its parents) and its heads. Throws
  /// - UsageError when the folder already holds a session or part of one: nothing is ever overwritten;
  /// - UsageError when `info.profile_json` isn't JSON;
  /// - OutputError when the folder can't be made or written.
  SessionWriter(const std::filesystem::path& folder, const SessionInfo& info, SessionOptions options = {});
  /// Without a `close` before it, the session stays marked as interrupted (as after a crash); everything written
  /// remains valid.
  ~SessionWriter();
  SessionWriter(const SessionWriter&) = delete;
  SessionWriter& operator=(const SessionWriter&) = delete;

  /// Adds one step: the parts the scene has, its events, and always its row. `scene.measurement.frame` numbers the
  /// files and must rise from step to step. Parts are stamped with `measurement.time_s` and `frame` where they aren't
  /// already. Throws OutputError when the disk refuses; the step is then incomplete, all before it valid, and the
  /// writer may be used again (to close it, for example).
  void write(const Scene& scene, Packing packing = Packing::kSmall);
  /// The same with parts that were made ready elsewhere.
  void write(const Scene& scene, const StepParts& ready);
  /// What the last `write` cost.
  const WriteCost& last_cost() const noexcept;

  /// Adds one event, at any time: `close` puts the table into the order of time. An event of kind `dropped` or
  /// `thinned` also counts as many frames as its detail begins with (1 where it begins with no number). Throws
  /// OutputError.
  void event(const Event& event);

  /// Adds the next block of the recording of the hand (`haptics/`, docs/file-format.md): covering the time since the
  /// last one, starting at `time_s`. Throws OutputError; the blocks before it stay valid.
  void write_hand(const Frozen<vtkPolyData>& block, double time_s);

  /// The injection plan, JSON text: in `session.json` from its next writing on. The last one counts.
  void set_plan(std::string plan_json);

  /// How the clocks ran against each other, JSON text: in `session.json` from its next writing on.
  void set_clocks(std::string clocks_json);

  /// The result of a palpation, JSON text: in `session.json` from its next writing on.
  void set_palpation(std::string palpation_json);

  /// Replaces `SessionInfo::provenance_json`, for what is known at the end only; in `session.json` from its next
  /// writing.
  void set_provenance(std::string provenance_json);

  /// Writes what is still to be written, puts the events into the order of time and marks the session complete. Safe to
  /// call twice. Throws OutputError.
  void close();

  const SessionCounts& counts() const noexcept;
  const std::filesystem::path& folder() const noexcept;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
