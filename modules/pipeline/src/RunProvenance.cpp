#include "pellucida/pipeline/RunProvenance.h"

#include <nlohmann/json.hpp>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldJson.h"
#include "pellucida/core/Version.h"
#include "pellucida/mechanics/ExpectedPuncture.h"
#include "pellucida/session/Sha256.h"

namespace pellucida {
namespace {

using Json = nlohmann::ordered_json;
using Tracker = TrackerOptions;

constexpr Field<Tracker> kTrackerFields[] = {
    {"min_cell_diameter_px", "px", &Tracker::min_cell_diameter_px, {}, ""},
    {"max_cell_diameter_px", "px", &Tracker::max_cell_diameter_px, {}, ""},
    {"min_detection_score", "0..1", &Tracker::min_detection_score, {}, ""},
    {"redetect_interval_frames", "", &Tracker::redetect_interval_frames, {}, ""},
    {"contour_point_count", "", &Tracker::contour_point_count, {}, ""},
    {"edge_scale_px", "px", &Tracker::edge_scale_px, {}, ""},
    {"search_px", "px", &Tracker::search_px, {}, ""},
    {"wide_search_px", "px", &Tracker::wide_search_px, {}, ""},
    {"elasticity", "", &Tracker::elasticity, {}, ""},
    {"rigidity", "", &Tracker::rigidity, {}, ""},
    {"tip_rigidity", "", &Tracker::tip_rigidity, {}, ""},
    {"snake_iterations", "", &Tracker::snake_iterations, {}, ""},
    {"min_tracking_score", "0..1", &Tracker::min_tracking_score, {}, ""},
    {"lost_after_frames", "", &Tracker::lost_after_frames, {}, ""},
    {"contact_px", "px", &Tracker::contact_px, {}, ""},
    {"puncture_drop_ratio", "", &Tracker::puncture_drop_ratio, {}, ""},
};
constexpr Field<PipelineOptions> kMeshFields[] = {
    {"revolve_step_deg", "degrees", &PipelineOptions::revolve_step_deg, {}, ""},
    {"meridian_point_count", "", &PipelineOptions::meridian_point_count, {}, ""},
};

constexpr const char* kMeasurements = "measurements";
constexpr const char* kParameters = "parameters";
constexpr const char* kQuality = "quality";
constexpr const char* kDetection = "detection";
constexpr const char* kFramesBefore = "frames_before_recording";

FieldList fields_of(PipelineOptions& options) {
  return FieldList().add("", kMeshFields, options).add("tracker", kTrackerFields, options.tracker);
}

Json parameters_of(const PipelineOptions& options) {
  PipelineOptions copy = options;
  Json json = Json::object();
  write_fields(fields_of(copy), json);
  json["tracker"][kQuality] = options.tracker.quality == Tracker::Quality::kHigh ? "high" : "live";
  json["tracker"][kDetection] = to_string(options.tracker.detection);
  return json;
}

[[noreturn]] void refuse(const std::string& what) {
  throw InputError("session.json: " + what + "; name the parameters on the command line, or mend the entry");
}

void read_parameters(const Json& provenance, PipelineOptions& options) {
  const auto found = provenance.find(kParameters);
  if (found == provenance.end()) return;
  if (!found->is_object()) refuse("provenance.parameters is no object");
  if (const auto fault = read_fields(*found, fields_of(options), UnknownKeys::kIgnored)) {
    refuse("provenance.parameters: " + *fault);
  }
  const auto tracker = found->find("tracker");
  const auto word = [&](const char* key) {
    if (tracker == found->end() || !tracker->is_object()) return std::string();
    const auto value = tracker->find(key);
    return value != tracker->end() && value->is_string() ? value->get<std::string>() : std::string();
  };
  if (word(kQuality) == "high") options.tracker.quality = Tracker::Quality::kHigh;
  // Sessions that don't say were tracked by lines.
  options.tracker.detection = detection_from_string(word(kDetection)).value_or(Tracker::Detection::kLines);
}

void read_palpation(const std::string& text, PipelineOptions& options) {
  if (text.empty()) return;
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return;
  Json list = json.value(kMeasurements, Json::array());
  // Earlier versions knew one push, and wrote its numbers here.
  if (json.contains("at_indentation_um")) {
    Json push = json;
    if (const auto sigma = json.find("known_relative_sigma"); sigma != json.end() && sigma->is_number()) {
      push["known_force_sigma_percent"] = 100.0 * sigma->get<double>();
    }
    list = Json::array({push});
  }
  if (!list.is_array()) refuse("palpation.measurements is no list");
  for (const Json& entry : list) {
    ScaleMeasurement measurement;
    if (!entry.is_object()) refuse("palpation.measurements: an entry is no object");
    if (const auto fault = read_fields(entry, fields_of(measurement), UnknownKeys::kIgnored)) {
      refuse("palpation.measurements: " + *fault);
    }
    try {
      way_of(measurement);
    } catch (const UsageError& error) {
      refuse(std::string("palpation: ") + error.what());
    }
    options.scale_measurements.push_back(measurement);
  }
}

Json provenance_of(const SessionInfo& info) {
  const Json json = Json::parse(info.provenance_json, nullptr, false);
  return json.is_object() ? json : Json::object();
}

}  // namespace

std::string to_json(const RunProvenance& provenance, const PipelineOptions& options, const CellProfile& profile) {
  Json json = Json::object();
  json["versions"] = options.versions;
  json["versions"]["Pellucida"] = kVersion;
  json[kParameters] = parameters_of(options);
  json["inputs_sha256"] = provenance.input_sha256;
  json["inputs_sha256"]["profile"] = sha256_of(to_json(profile));
  json[kFramesBefore] = provenance.frames_before_recording;
  if (!provenance.replay_json.empty()) json["replay"] = Json::parse(provenance.replay_json, nullptr, false);
  return json.dump();
}

TrackerOptions tracker_of(const PipelineOptions& options, const CellProfile& profile) {
  TrackerOptions tracker = options.tracker;
  tracker.expected_radius_um = profile.mid_radius_um + 0.5 * profile.thickness_um;
  return tracker;
}

CellProfile profile_of(const PipelineOptions& options) {
  return options.given_profile ? *options.given_profile : load_profile(options.profile);
}

PipelineOptions recorded_options(const SessionInfo& info) {
  PipelineOptions options;
  if (!info.profile_json.empty()) {
    options.given_profile =
        std::make_shared<const CellProfile>(parse_profile(info.profile_json, "session.json: profile.content"));
    options.profile = options.given_profile->name;
  }
  read_parameters(provenance_of(info), options);
  read_palpation(info.palpation_json, options);
  return options;
}

std::string palpation_json(const std::vector<ScaleMeasurement>& measurements, const CellScale& scale,
                           const std::vector<PunctureRisk>& risk) {
  Json json;
  json[kMeasurements] = Json::array();
  for (ScaleMeasurement measurement : measurements) {
    Json entry{{"way", to_string(way_of(measurement))}};
    Json numbers = Json::object();
    write_fields(fields_of(measurement), numbers);
    // What was not given is 0.
    for (const auto& [key, value] : numbers.items()) {
      if (value != 0.0) entry[key] = value;
    }
    json[kMeasurements].push_back(entry);
  }
  json["cell_scale_ratio"] = scale.ratio;
  json["cell_scale_relative_sigma"] = scale.relative_sigma;
  json["puncture_spread_ratio"] = kPunctureSpread_ratio;
  json["puncture_risk"] = Json::array();
  for (const PunctureRisk& one : risk) {
    json["puncture_risk"].push_back(
        {{"indentation_um", one.depth_um}, {"force_uN", one.force_uN}, {"probability", one.probability}});
  }
  return json.dump();
}

long frames_before_recording(const SessionInfo& info) {
  const Json provenance = provenance_of(info);
  const auto found = provenance.find(kFramesBefore);
  return found != provenance.end() && found->is_number_integer() ? found->get<long>() : 0;
}

}  // namespace pellucida
