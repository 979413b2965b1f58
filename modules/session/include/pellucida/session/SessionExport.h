#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "pellucida/session/SessionCheck.h"
#include "pellucida/session/SessionReader.h"

namespace pellucida {

struct ExportOptions {
  /// Frames whose surface nodes go to `nodes.csv`: any of `first`, `last`, `peak` (largest contact force) and frame
  /// numbers, comma separated. `first`, `last` and `peak` are those with a surface; the report names the peak, and
  /// warns when a frame without a surface had more force.
  std::string frames = "peak";
  SessionProgress progress;
};

/// Result of an export.
struct ExportReport {
  std::vector<std::filesystem::path> files;  ///< in the order they were written
  std::vector<std::string> notes;            ///< what was chosen, what was not there to write, and why; a line each
  std::vector<long> node_frames;             ///< frames in `nodes.csv`
  std::size_t contour_point_count = 0;       ///< rows of `contours.csv`
  std::size_t hand_row_count = 0;            ///< rows of `haptics.csv`
  std::size_t node_count = 0;                ///< rows of `nodes.csv`
};

/// The files that an export into `output` may write; the last ones only where a session has what belongs in them.
std::vector<std::filesystem::path> export_names(const std::filesystem::path& output);

/// Writes a session as flat files for other tools: `measurements.csv`, `events.csv`, `contours.csv`
/// (`frame,membrane,point,x_um,y_um`), `nodes.csv`
/// (`frame,node,membrane,x_um,y_um,z_um,fx_uN,fy_uN,fz_uN,force_sigma_uN`); if a hand was recorded, `haptics.csv`
/// (`path,x_um,y_um,z_um` and every array of the recording's points); if there are annotations, `annotations.csv`. An
/// earlier export in `output` is replaced, file by file. Throws InputError when the session can't be read, UsageError
/// when `options.frames` names no frame of the session or `output` is the session itself, OutputError when a file can't
/// be written.
ExportReport export_session(const std::filesystem::path& session, const std::filesystem::path& output,
                            const ExportOptions& options = {});

/// The step that shows most of a session: of the largest contact force; without one, the step seen best. 0 for a
/// session without a step.
std::size_t telling_step(const SessionReader& session);

}  // namespace pellucida
