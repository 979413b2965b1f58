#include "commands/MeasureSession.h"

#include <cmath>
#include <cstdio>

#include "commands/Interrupt.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Progress.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/pipeline/RunProvenance.h"
#include "pellucida/reconstruction/Revolve.h"
#include "pellucida/session/SessionSource.h"
#include "pellucida/session/SessionWriter.h"
#include "pellucida/session/Sha256.h"

namespace pellucida {
namespace {

template <class... Numbers>
std::string format(const char* pattern, Numbers... numbers) {
  char text[256];
  std::snprintf(text, sizeof text, pattern, numbers...);
  return text;
}

// "172 frames: 15 free, 157 contact"
std::string state_line(const BatchResult& result) {
  std::string line = std::to_string(result.rows.size()) + (result.rows.size() == 1 ? " frame" : " frames");
  const char* separator = ": ";
  for (const auto& [state, count] : result.state_count) {
    line += separator + std::to_string(count) + ' ' + std::string(to_string(state));
    separator = ", ";
  }
  return line;
}

std::string force_line(const BatchResult& result) {
  if (!result.peak || !(result.peak->measurement.contact_force_uN > 0.0)) return "no contact force measured";
  const Measurement& m = result.peak->measurement;
  return format("%.2f uN (95 %%: %.2f to %.2f; %s) at %.1f um, %.2f s", m.contact_force_uN, m.contact_force_lower_uN,
                m.contact_force_upper_uN, to_string(force_spread(m)).c_str(), m.indentation_um, m.time_s);
}

// What speaks against the peak's force, a line each; and what other models say of the same push.
std::string remark_lines(const BatchResult& result) {
  if (!result.peak) return {};
  const ForceRemarks& remarks = result.peak->remarks;
  std::string lines;
  if (!remarks.reason.empty()) lines += "         no force: " + remarks.reason + '\n';
  if (!remarks.warning.empty()) lines += "         warning: " + remarks.warning + '\n';
  std::string others;
  if (std::isfinite(remarks.point_load_uN)) others += format("point-load formula %.2f uN", remarks.point_load_uN);
  if (std::isfinite(remarks.table_uN)) {
    others += others.empty() ? "" : ", ";
    others += format("finite-element table %.2f uN", remarks.table_uN);
  }
  if (others.empty()) return lines;
  others += format("; spread of all %.0f %%, no part of the interval", result.peak->measurement.model_spread_percent);
  return lines + "others   " + others + '\n';
}

// "1.20 times the profile's, +- 7 %; puncture likely from 38 um on" where the cell's own scale was measured.
std::string scale_line(const BatchResult& result) {
  std::string line = format("%.2f times the profile's forces, +- %.0f %%", result.cell_scale.ratio,
                            100.0 * result.cell_scale.relative_sigma);
  for (const PunctureRisk& risk : result.puncture_risk) {
    if (risk.probability < 0.5) continue;
    line += format("; puncture more likely than not from %.0f um on", risk.depth_um);
    break;
  }
  return line;
}

std::string cell_line(const BatchResult& result) {
  if (!result.peak || !result.peak->observation || !result.peak->observation->outer) return "no cell seen";
  const Observation& o = *result.peak->observation;
  std::string line = format("outer radius %.1f um at rest", o.rest_outer_radius_um);
  line += o.rest_inner_radius_um > 0.0 ? format(", inner %.1f um", o.rest_inner_radius_um)
                                       : "; one membrane only: no second edge was seen beside it";
  line += format(", confidence %.2f", o.confidence);
  line += o.needle ? "" : ", no needle seen";
  line += o.holder ? "" : ", no holding pipette seen";
  return line;
}

// "expected at 12.1 uN and 47 um (its kind: 7.5 uN and 44 um)" where the sizes say so.
std::string puncture_line(const BatchResult& result) {
  if (!result.peak || !(result.peak->measurement.expected_puncture_uN > 0.0)) return {};
  const Measurement& m = result.peak->measurement;
  return format(
      "puncture expected at %.1f uN and %.0f um by the sizes of cell and needle (its kind: %.1f uN and %.0f um)\n",
      m.expected_puncture_uN, m.expected_puncture_um, result.profile.puncture_force_uN,
      result.profile.puncture_indentation_um);
}

// What was read, where it is a file; the frames' own hash is the writer's business.
RunProvenance provenance_of(const std::string& source) {
  RunProvenance provenance;
  std::error_code ignored;
  if (std::filesystem::is_regular_file(source, ignored)) provenance.input_sha256["file"] = sha256_of_file(source);
  const std::filesystem::path folder = source;
  if (is_session(folder)) provenance.input_sha256["session_json"] = sha256_of_file(folder / "session.json");
  return provenance;
}

}  // namespace

BatchResult measure_session(FrameSource& source, const PipelineOptions& pipeline, int job_count,
                            const std::filesystem::path& folder, const SessionOptions& session_options,
                            const std::string& command_line, const SessionAddition& addition) {
  // The profile first: a wrong name must not leave an empty session behind.
  const CellProfile profile = profile_of(pipeline);
  SessionInfo info;
  info.source = source.info();
  info.seeds = source.info().seeds;
  info.provenance_json = to_json(provenance_of(source.info().name), pipeline, profile);
  info.profile_name = profile.name;
  info.profile_json = to_json(profile);
  info.command_line = command_line;
  info.drop_policy = "none: every frame is measured and written";
  // A value that the chain refuses must not leave a session that blocks the corrected call.
  validate(
      RevolveOptions{.step_deg = pipeline.revolve_step_deg, .meridian_point_count = pipeline.meridian_point_count});
  const InterruptScope interrupt;
  InterruptibleSource interruptible(source);
  SessionWriter writer(folder, info, session_options);

  Progress progress("frame");
  const BatchOptions options{.pipeline = pipeline,
                             .job_count = job_count,
                             .progress = [&](long done, std::optional<long> all) { progress.update(done, all); }};
  BatchResult result = run_batch(interruptible, options, [&](const Scene& scene) {
    writer.write(scene);
    if (addition.after_frame) addition.after_frame(writer, scene);
  });
  if (addition.at_end) addition.at_end(writer);
  if (const int number = interrupted(); number != 0) {
    const double time_s = result.rows.empty() ? 0.0 : result.rows.back().time_s;
    writer.event({time_s, event_kind::kStopped, std::string("the program was stopped by ") + signal_name(number)});
  }
  if (const auto& scale = pipeline.scale_measurements; !scale.empty())
    writer.set_palpation(palpation_json(scale, result.cell_scale, result.puncture_risk));
  writer.close();
  return result;
}

std::string summary(const BatchResult& result, const std::filesystem::path& folder) {
  std::string text = "frames   " + state_line(result) + '\n' + damage_line(result);
  text += "profile  " + result.profile.name + " (" + result.profile.description + ")\n";
  text += "force    " + force_line(result) + '\n' + remark_lines(result);
  text += "cell     " + cell_line(result) + '\n' + puncture_line(result);
  if (!result.puncture_risk.empty()) text += "scale    " + scale_line(result) + '\n';
  const auto median_ms = [&](const char* step) { return 1e-3 * result.step_us.at(step).quantile(0.5); };
  text += format("speed    tracking %.1f, mechanics %.1f, surface %.1f ms per frame (median); %.0f frames/s overall\n",
                 median_ms("tracking"), median_ms("mechanics"), median_ms("surface"),
                 static_cast<double>(result.rows.size()) / result.elapsed_s);
  text += "session  " + folder.string() + '\n';
  return text;
}

void require_measured(const BatchResult& result, const std::string& input) {
  if (result.input_fault) std::rethrow_exception(result.input_fault);
  for (const Measurement& row : result.rows) {
    if (!std::isnan(row.cell_x_um)) return;
  }
  const bool is_refused = result.peak && result.peak->observation && result.peak->observation->refused_radius_um > 0.0;
  throw NothingMeasuredError(
      input + ": no cell was found in any of " + std::to_string(result.rows.size()) + " frames; " +
      (is_refused ? result.peak->remarks.reason : "check that a round cell is in view and the pixel size is right"));
}

}  // namespace pellucida
