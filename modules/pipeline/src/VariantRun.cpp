#include "VariantRun.h"

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "Chain.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/core/Version.h"
#include "pellucida/pipeline/RunProvenance.h"

namespace pellucida {
namespace {

constexpr double kVariantRiskStep_um = 5.0;

SessionInfo info_of_variant(const ReplayVariant& variant, const CounterfactualOptions& options,
                            const SessionReader& session, const std::string& session_json_sha256) {
  SessionInfo info = session.info();
  info.software_version = kVersion;
  info.source.name = session.folder().string();
  info.source.live = false;
  if (options.playback.pixel_size_um) {
    info.source.pixel_size_um = *options.playback.pixel_size_um;
    info.source.pixel_size_origin = "option";
  }
  info.profile_name = variant.profile.name;
  info.profile_json = to_json(variant.profile);
  info.command_line = options.command_line;
  info.drop_policy = "none of its own; frames the recorded run had no time for stay without numbers";
  if (options.pipeline.scale_measurements.empty()) info.palpation_json.clear();

  const auto recorded = nlohmann::ordered_json::parse(session.info().provenance_json, nullptr, false);
  nlohmann::ordered_json replay{{"session", session.folder().string()},
                                {"source", session.info().source.name},
                                {"rerun", options.rerun == Rerun::kTracking ? "tracking" : "mechanics"},
                                {"changes", nlohmann::ordered_json::object()}};
  for (const PersonHint& hint : options.pipeline.hints) {
    replay["hints"].push_back({{"time_s", hint.since_s}, {"hint", describe(hint)}});
  }
  if (!variant.changes_json.empty()) replay["changes"] = nlohmann::ordered_json::parse(variant.changes_json);
  const PlaybackOptions& playback = options.playback;
  if (playback.from_s) replay["from_s"] = *playback.from_s;
  if (playback.to_s) replay["to_s"] = *playback.to_s;
  if (playback.every > 1) replay["every"] = playback.every;
  if (playback.all_frames) replay["all_frames"] = true;
  replay["recorded"] = recorded.is_object() ? recorded : nlohmann::ordered_json(nullptr);
  RunProvenance provenance;
  provenance.input_sha256["session_json"] = session_json_sha256;
  provenance.replay_json = replay.dump();
  info.provenance_json = to_json(provenance, options.pipeline, variant.profile);
  return info;
}

/// Events that no measurement of the same frames gives again.
bool is_of_the_recording(const Event& event) {
  if (event.kind == event_kind::kNote) return !event.detail.starts_with(kNoForceNote);
  constexpr std::array kKinds{event_kind::kLimit,   event_kind::kUnmeasured, event_kind::kDropped,
                              event_kind::kGap,     event_kind::kPaused,     event_kind::kResumed,
                              event_kind::kStarted, event_kind::kStopped,    event_kind::kDamaged};
  return std::any_of(kKinds.begin(), kKinds.end(), [&](const char* kind) { return event.kind == kind; });
}

}  // namespace

bool has_same_shape(const CellProfile& one, const CellProfile& other) {
  const auto shape_of = [](CellProfile profile) {
    const CellProfile none;
    profile.effective_young_modulus_kPa = 1.0;
    // Numbers that say something of the force, and nothing of the shape.
    profile.force_scale_relative_sigma = none.force_scale_relative_sigma;
    profile.young_modulus_kPa = none.young_modulus_kPa;
    profile.puncture_force_uN = none.puncture_force_uN;
    profile.puncture_indentation_um = none.puncture_indentation_um;
    profile.description.clear();
    profile.sources.clear();
    profile.references.clear();
    profile.errors.clear();
    return to_json(profile);
  };
  return shape_of(one) == shape_of(other);
}

VariantRun::VariantRun(const ReplayVariant& variant, const CounterfactualOptions& options, const SessionReader& session,
                       const std::string& session_json_sha256, const Clock& clock)
    : variant_(variant),
      options_(options),
      clock_(clock),
      mechanics_(variant.profile),
      has_recorded_shape_(has_same_shape(variant.profile, profile_of(options.pipeline))),
      writer_(variant.folder, info_of_variant(variant, options, session, session_json_sha256),
              {.frames = options.keep_frames, .sync = SessionSync::kAtEnd}) {
  mechanics_.set_scale_measurements(options.pipeline.scale_measurements);
}

void VariantRun::take(const RecordedFrame& frame) {
  Scene scene = frame.scene;
  scene.arrival_s = clock_.now_s();
  // What is not written need not be computed either; the row has the surface's volume already.
  if (options_.tables_only) scene.surface = {};
  SurfaceForces forces;
  if (scene.use == FrameUse::kMeasure && scene.observation) {
    if (auto measured = mechanics_.process(scene, has_recorded_shape_ ? frame.shape.get() : nullptr)) {
      scene = std::move(measured->scene);
      forces = nodal_forces_.forces_on(scene.surface, measured->estimate);
    }
    stamp_age(scene, clock_);
  }
  log_.add(frame.recorded.measurement, scene.measurement);
  StepParts parts;
  if (options_.tables_only) {
    scene.membranes = {};
    scene.tools = {};
  } else {
    FieldDifferences largest = frame.common.largest;
    parts.surface = variant_surface(frame.common, forces, largest);
    parts.surface_arrays = frame.common.surface_arrays;
    parts.membranes = frame.common.membranes;
    parts.tools = frame.common.tools;
    log_.add_fields(largest.contour_um, largest.displacement_um, largest.node_force_uN);
  }
  writer_.write(scene, parts);
  last_time_s_ = scene.measurement.time_s;
}

VariantResult VariantRun::finish(const SessionReader& session) {
  replace_file(variant_.folder / "differences.csv", ChangeLog::table_header() + '\n' + log_.table());
  constexpr double kEver_s = std::numeric_limits<double>::infinity();
  const double from_s = options_.playback.from_s.value_or(-kEver_s);
  const double to_s = options_.playback.to_s.value_or(kEver_s);
  for (const Event& event : session.events()) {
    // Where the tracking runs again it reports the hints itself.
    const bool is_hint = event.kind == event_kind::kHint && options_.rerun == Rerun::kMechanics;
    if ((is_of_the_recording(event) || is_hint) && event.time_s >= from_s && event.time_s <= to_s) writer_.event(event);
  }
  if (options_.stopped && options_.stopped()) {
    writer_.event({last_time_s_, event_kind::kStopped, "the replay was stopped before its end"});
  }
  if (!options_.pipeline.scale_measurements.empty()) {
    writer_.set_palpation(palpation_json(options_.pipeline.scale_measurements, mechanics_.scale(),
                                         mechanics_.puncture_risk(kVariantRiskStep_um)));
  }
  writer_.close();
  return {variant_.name, variant_.folder, variant_.profile, log_.figures()};
}

}  // namespace pellucida
