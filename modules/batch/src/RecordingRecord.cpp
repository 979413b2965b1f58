#include "pellucida/batch/RecordingRecord.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "pellucida/core/Error.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/session/SessionReader.h"
#include "pellucida/session/SessionSource.h"
#include "pellucida/session/Sha256.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kRecordVersion = 1;

void add_file(const fs::path& file, InputStamp& stamp) {
  std::error_code fault;
  const auto size = fs::file_size(file, fault);
  if (fault) return;
  const auto time = fs::last_write_time(file, fault);
  if (fault) return;
  stamp.byte_count += size;
  stamp.modified_ns = std::max<std::int64_t>(
      stamp.modified_ns, std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count());
}

}  // namespace

InputStamp stamp_of(const std::string& input) {
  InputStamp stamp;
  const auto scenario = input.find(':');
  const fs::path path = input.starts_with("virtual:") ? fs::path(input.substr(scenario + 1)) : fs::path(input);
  std::error_code fault;
  stamp.path = fs::absolute(path, fault).lexically_normal().string();
  stamp.modified_ns = std::numeric_limits<std::int64_t>::min();
  if (is_session(path)) {
    add_file(path / "session.json", stamp);
    add_file(path / "measurements.csv", stamp);
  } else if (fs::is_directory(path, fault)) {
    for (const auto& entry : fs::directory_iterator(path, fault)) {
      if (entry.is_regular_file(fault)) add_file(entry.path(), stamp);
    }
  } else if (fs::is_regular_file(path, fault)) {
    add_file(path, stamp);
  }
  if (stamp.byte_count == 0) stamp.modified_ns = 0;
  return stamp;
}

bool same_content(const InputStamp& then, const InputStamp& now) {
  if (then.byte_count != now.byte_count) return false;
  if (then.modified_ns == now.modified_ns && then.path == now.path) return true;
  std::error_code ignored;
  if (then.sha256.empty() || !fs::is_regular_file(now.path, ignored)) return false;
  try {
    return sha256_of_file(now.path) == then.sha256;
  } catch (const InputError&) {
    return false;
  }
}

std::optional<RecordingRecord> read_record(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) return std::nullopt;
  try {
    const Json json = Json::parse(stream);
    if (json.at("record_version") != kRecordVersion) return std::nullopt;
    RecordingRecord record;
    const Json& input = json.at("input");
    record.input = {input.at("path"), input.at("bytes"), input.at("modified_ns"), input.at("sha256")};
    const Json& recipe = json.at("recipe");
    record.recipe = {recipe.at("options"), recipe.at("profile_sha256"), recipe.at("version")};
    record.exit_code = json.at("exit_code");
    record.error = json.at("error");
    record.wall_time_s = json.at("wall_time_s");
    record.session_sha256 = json.at("session_sha256");
    return record;
  } catch (const Json::exception&) {
    // Written by hand, or by another version: what it is about is done again.
    return std::nullopt;
  }
}

void write_record(const fs::path& file, const RecordingRecord& record) {
  const Json json{{"record_version", kRecordVersion},
                  {"input",
                   {{"path", record.input.path},
                    {"bytes", record.input.byte_count},
                    {"modified_ns", record.input.modified_ns},
                    {"sha256", record.input.sha256}}},
                  {"recipe",
                   {{"options", record.recipe.options},
                    {"profile_sha256", record.recipe.profile_sha256},
                    {"version", record.recipe.version}}},
                  {"exit_code", record.exit_code},
                  {"error", record.error},
                  {"wall_time_s", record.wall_time_s},
                  {"session_sha256", record.session_sha256}};
  // A name in a text may be in any coding.
  replace_file(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

bool holds_result(const fs::path& session, const RecordingRecord& record) {
  if (record.session_sha256.empty() || !is_session(session)) return false;
  try {
    return sha256_of_file(session / "session.json") == record.session_sha256 && SessionReader(session).complete();
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace pellucida
