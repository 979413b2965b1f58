#include "SessionJson.h"

#include <nlohmann/json.hpp>

#include "Checksum.h"
#include "DiskFile.h"
#include "SessionFolder.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/session/SessionClocks.h"
#include "pellucida/vtk_files/SurfacePrecision.h"

namespace pellucida {
namespace {

using Json = nlohmann::ordered_json;

Json parse_profile(const std::string& text) {
  if (text.empty()) return nullptr;
  const Json parsed = Json::parse(text, nullptr, false);
  if (parsed.is_discarded()) throw UsageError("the cell profile's content is not JSON; check the profile's file");
  return parsed;
}

// Each value goes to its place only when it is there and not null.
template <class T>
void take(const Json& object, const char* key, T& value) {
  if (const auto found = object.find(key); found != object.end() && !found->is_null()) value = found->template get<T>();
}

// The object under `key`, empty when it isn't there; throws the library's type error for anything else than an object.
Json object_at(const Json& parent, const char* key) {
  Json object = Json::object();
  if (const auto found = parent.find(key); found != parent.end()) object = found->get_ref<const Json::object_t&>();
  return object;
}

Json source_json(const SourceInfo& source) {
  return {{"name", source.name},
          {"width_px", source.width_px},
          {"height_px", source.height_px},
          {"bit_depth", source.bit_depth},
          {"frame_rate_hz", source.frame_rate_hz},
          {"frame_rate_origin", source.frame_rate_origin},
          {"frame_count", source.frame_count ? Json(*source.frame_count) : Json(nullptr)},
          {"live", source.live}};
}

SourceInfo source_from(const Json& head) {
  SourceInfo source;
  const Json object = object_at(head, "source");
  take(object, "name", source.name);
  take(object, "width_px", source.width_px);
  take(object, "height_px", source.height_px);
  take(object, "bit_depth", source.bit_depth);
  take(object, "frame_rate_hz", source.frame_rate_hz);
  take(object, "frame_rate_origin", source.frame_rate_origin);
  take(object, "live", source.live);
  long frame_count = -1;
  take(object, "frame_count", frame_count);
  if (frame_count >= 0) source.frame_count = frame_count;

  const Json calibration = object_at(head, "calibration");
  take(calibration, "pixel_size_um", source.pixel_size_um);
  take(calibration, "pixel_size_origin", source.pixel_size_origin);
  return source;
}

Json counts_json(const SessionCounts& counts) {
  Json object{{"steps", counts.step_count}};
  for (const PartNames& names : kParts) object[names.folder] = counts.files(names.part);
  object[session_name::kHaptics] = counts.hand_block_count;
  object["unmeasured"] = counts.unmeasured_count;
  object["events"] = counts.event_count;
  object["dropped"] = counts.dropped_count;
  object["thinned"] = counts.thinned_count;
  object["bytes"] = counts.byte_count;
  return object;
}

SessionCounts counts_from(const Json& head) {
  SessionCounts counts;
  const Json object = object_at(head, "counts");
  take(object, "steps", counts.step_count);
  for (const PartNames& names : kParts)
    take(object, names.folder, counts.file_count[static_cast<std::size_t>(names.part)]);
  take(object, session_name::kHaptics, counts.hand_block_count);
  take(object, "unmeasured", counts.unmeasured_count);
  take(object, "events", counts.event_count);
  take(object, "dropped", counts.dropped_count);
  take(object, "thinned", counts.thinned_count);
  take(object, "bytes", counts.byte_count);
  return counts;
}

// How finely the surfaces are kept; sessions without it hold them as they came from the model.
Json surface_precision_json() {
  return {{"place_step_um", surface_precision::kPlaceStep_um},
          {"direction_step", surface_precision::kDirectionStep},
          {"force_step_per_sigma", surface_precision::kForceStepShare},
          {"relative_bits", surface_precision::kRelativeBits}};
}

// The last key is the checksum of the text before it.
constexpr const char* kChecksum = "crc32";
const std::string kBeforeChecksum = std::string(",\n  \"") + kChecksum + "\": \"";
const std::string kBehindChecksum = "\"\n}\n";

std::string checked_text(const Json& json) {
  // File names may hold any bytes; what isn't UTF-8 is replaced rather than refused.
  std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace);
  text.resize(text.size() - std::string_view("\n}").size());
  return text + kBeforeChecksum + crc32_text(crc32_of(text)) + kBehindChecksum;
}

bool is_checksum_right(std::string_view text) {
  const std::size_t at = text.rfind(kBeforeChecksum);
  if (at == std::string_view::npos || !text.ends_with(kBehindChecksum)) return false;
  const std::size_t start = at + kBeforeChecksum.size();
  if (start + kBehindChecksum.size() > text.size()) return false;
  const auto checksum = crc32_from(text.substr(start, text.size() - kBehindChecksum.size() - start));
  return checksum && *checksum == crc32_of(text.substr(0, at));
}

// Nothing in a head is nested deeper than a profile's constants.
constexpr int kDeepest = 64;
constexpr std::uint64_t kMostHeadBytes = std::uint64_t{1} << 24U;

bool is_deep(std::string_view text) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\') {
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && (c == '{' || c == '[')) {
      if (++depth > kDeepest) return true;
    } else if (!quoted && (c == '}' || c == ']')) {
      --depth;
    }
  }
  return false;
}

Json parse_head(const std::filesystem::path& file, const std::string& text) {
  const std::string help = "; run pellucida check --repair on the session";
  if (is_deep(text)) throw InputError(file.string() + ": nested too deep for the head of a session" + help);
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) throw InputError(file.string() + ": not JSON" + help);
  return json;
}

// Which schema it is, before anything else is believed.
void require_schema(const std::filesystem::path& file, const Json& json, bool changed) {
  const auto version = json.find("schema_version");
  if (version == json.end() || !version->is_number_integer()) {
    throw InputError(file.string() + ": no head of a session (it has no schema_version)");
  }
  const auto number = version->get<std::int64_t>();
  if (number == kSchemaVersion) return;
  const std::string text =
      "schema_version is " + std::to_string(number) + "; this program reads " + std::to_string(kSchemaVersion);
  // A digit that was changed is damage, a later version is not.
  if (changed || number < 1) throw InputError(file.string() + ": " + text);
  throw LaterSchemaError(file.string() + ": " + text + "; use the version of Pellucida that wrote it, or a later one");
}

void require_possible(const std::filesystem::path& file, const SessionHead& head) {
  const SourceInfo& source = head.info.source;
  const auto require = [&](bool possible, const std::string& what, double value) {
    if (!possible) throw InputError(file.string() + ": " + what + " is " + csv_number(value) + ", which can't be");
  };
  constexpr int kMostPixels = 1 << 20;
  // 0 where it isn't known, as after a repair.
  require(source.pixel_size_um >= 0.0 && source.pixel_size_um <= 1e4, "pixel_size_um", source.pixel_size_um);
  require(source.frame_rate_hz >= 0.0 && source.frame_rate_hz <= 1e9, "frame_rate_hz", source.frame_rate_hz);
  require(source.width_px >= 0 && source.width_px <= kMostPixels, "width_px", source.width_px);
  require(source.height_px >= 0 && source.height_px <= kMostPixels, "height_px", source.height_px);
  require(source.bit_depth == 8 || source.bit_depth == 16, "bit_depth", source.bit_depth);
}

}  // namespace

std::string to_json(const SessionHead& head) {
  const SessionInfo& info = head.info;
  Json json{{"schema_version", kSchemaVersion},
            {"software", {{"name", "Pellucida"}, {"version", info.software_version}}},
            {"created", head.created},
            {"complete", head.complete}};
  if (head.recovered) json["recovered"] = true;
  json["source"] = source_json(info.source);
  json["calibration"] = {{"pixel_size_um", info.source.pixel_size_um},
                         {"pixel_size_origin", info.source.pixel_size_origin}};
  json["profile"] = {{"name", info.profile_name}, {"content", parse_profile(info.profile_json)}};
  if (!info.palpation_json.empty()) json["palpation"] = Json::parse(info.palpation_json, nullptr, false);
  if (!info.plan_json.empty()) json["plan"] = Json::parse(info.plan_json, nullptr, false);
  if (!info.provenance_json.empty()) json["provenance"] = Json::parse(info.provenance_json, nullptr, false);
  json["command_line"] = info.command_line;
  json["seeds"] = info.seeds;
  json["clock_offsets_s"] = info.clock_offsets_s;
  if (!info.clocks_json.empty()) json["clocks"] = Json::parse(info.clocks_json, nullptr, false);
  json["drop_policy"] = info.drop_policy;
  json["frames_kept"] = head.options.frames;
  if (head.options.layout == SessionLayout::kCompact) json["surface_precision"] = surface_precision_json();
  json["counts"] = counts_json(head.counts);
  return checked_text(json);
}

SessionHead read_session_json(const std::filesystem::path& file) {
  const std::string text = read_whole_file(file, kMostHeadBytes);
  const Json json = parse_head(file, text);
  const bool checked = json.contains(kChecksum);
  const bool changed = checked && !is_checksum_right(text);
  require_schema(file, json, changed);
  try {
    SessionHead head{.checked = checked, .changed = changed};
    SessionInfo& info = head.info;
    take(json, "created", head.created);
    take(json, "complete", head.complete);
    take(json, "recovered", head.recovered);
    take(json, "frames_kept", head.options.frames);
    head.options.layout = json.contains("surface_precision") ? SessionLayout::kCompact : SessionLayout::kWide;
    take(object_at(json, "software"), "version", info.software_version);
    info.source = source_from(json);
    const Json profile = object_at(json, "profile");
    take(profile, "name", info.profile_name);
    if (profile.contains("content") && !profile["content"].is_null()) info.profile_json = profile["content"].dump();
    if (json.contains("palpation")) info.palpation_json = json["palpation"].dump();
    if (json.contains("plan")) info.plan_json = json["plan"].dump();
    if (json.contains("provenance")) info.provenance_json = json["provenance"].dump();
    take(json, "command_line", info.command_line);
    take(json, "seeds", info.seeds);
    take(json, "clock_offsets_s", info.clock_offsets_s);
    if (json.contains("clocks")) info.clocks_json = json["clocks"].dump();
    take(json, "drop_policy", info.drop_policy);
    head.counts = counts_from(json);
    require_possible(file, head);
    return head;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file.string() + ": a value of a wrong type (" + error.what() +
                     "); run pellucida check --repair on the session");
  }
}

std::string repaired_json(const std::filesystem::path& file, const SessionCounts& counts) {
  Json json = parse_head(file, read_whole_file(file, kMostHeadBytes));
  json.erase(kChecksum);
  json["recovered"] = true;
  json["counts"] = counts_json(counts);
  return checked_text(json);
}

std::optional<ClockFit> clock_fit_of(const SessionInfo& info) {
  const Json json = Json::parse(info.clocks_json, nullptr, false);
  const auto found = json.is_object() ? json.find("source_to_run") : json.end();
  if (found == json.end() || !found->is_object() || found->empty()) return std::nullopt;
  const Json& line = *found;
  ClockFit fit;
  try {
    take(line, "offset_s", fit.offset_s);
    take(line, "drift_ppm", fit.drift_ppm);
    take(line, "drift_sigma_ppm", fit.drift_sigma_ppm);
    take(line, "scatter_s", fit.scatter_s);
    take(line, "pair_count", fit.pair_count);
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
  return fit;
}

}  // namespace pellucida
