#include "SessionFolder.h"

#include <algorithm>
#include <charconv>
#include <cstdio>

#include "pellucida/core/OutputFile.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

constexpr std::size_t kNumberDigits = 8;

// `folder/stem_00000012.vtp`
std::string numbered_file(const char* folder, const char* stem, const char* extension, long number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%08ld", number);
  return std::string(folder) + '/' + stem + '_' + digits + extension;
}

// The number in `stem_00000012.vtp`.
std::optional<long> number_of(const char* stem, std::string_view extension, std::string_view file_name) {
  const std::size_t start = std::string_view(stem).size();
  if (!file_name.starts_with(stem) || !file_name.ends_with(extension)) return std::nullopt;
  if (file_name.size() <= start + 1 + extension.size() || file_name[start] != '_') return std::nullopt;

  const std::string_view digits = file_name.substr(start + 1, file_name.size() - start - 1 - extension.size());
  // One name for one number: neither more zeros nor fewer.
  if (digits.size() < kNumberDigits || (digits.size() > kNumberDigits && digits[0] == '0')) return std::nullopt;
  long number = 0;
  const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (code != std::errc() || end != digits.data() + digits.size() || number < 0) return std::nullopt;
  return number;
}

}  // namespace

std::string part_file(SessionPart part, long frame_index) {
  const PartNames& names = names_of(part);
  return numbered_file(names.folder, names.stem, names.extension, frame_index);
}

std::optional<long> frame_index_of(SessionPart part, std::string_view file_name) {
  const PartNames& names = names_of(part);
  return number_of(names.stem, names.extension, file_name);
}

std::string hand_file(long block) {
  return numbered_file(session_name::kHaptics, session_name::kHaptics, ".vtp", block);
}

std::optional<long> hand_block_of(std::string_view file_name) {
  return number_of(session_name::kHaptics, ".vtp", file_name);
}

std::string data_file(const DataName& name) {
  return name.kind == kHandKind ? hand_file(name.number) : part_file(static_cast<SessionPart>(name.kind), name.number);
}

std::optional<DataName> data_name_of(std::string_view relative_file) {
  const auto slash = relative_file.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const std::string_view folder = relative_file.substr(0, slash);
  const std::string_view file = relative_file.substr(slash + 1);
  for (const PartNames& names : kParts) {
    if (folder != names.folder) continue;
    if (const auto index = frame_index_of(names.part, file)) return data_name(names.part, *index);
  }
  if (folder == session_name::kHaptics) {
    if (const auto block = hand_block_of(file)) return DataName{kHandKind, *block};
  }
  return std::nullopt;
}

bool is_own_temporary(std::string_view relative_file) {
  if (!relative_file.ends_with(kTemporarySuffix)) return false;
  relative_file.remove_suffix(std::string_view(kTemporarySuffix).size());
  const auto is_own = [](std::string_view name) {
    return std::find(kOwnFiles.begin(), kOwnFiles.end(), name) != kOwnFiles.end() || data_name_of(name).has_value();
  };
  if (is_own(relative_file)) return true;
  const auto dot = relative_file.rfind('.');
  if (dot == std::string_view::npos) return false;
  const std::string_view number = relative_file.substr(dot + 1);
  const bool digits =
      !number.empty() && std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
  return digits && is_own(relative_file.substr(0, dot));
}

const char* const kPvdStart =
    "<?xml version=\"1.0\"?>\n"
    "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
    "<Collection>\n";
const char* const kPvdEnd = "</Collection>\n</VTKFile>\n";

void append_pvd(const SessionStep& step, bool frames, std::string& text) {
  const std::string time = csv_number(step.time_s);
  for (const PartNames& names : kParts) {
    const bool image = names.part == SessionPart::kFrame;
    if (image && (!frames || !step.has(names.part))) continue;
    const std::string file = step.has(names.part) ? part_file(names.part, step.frame_index) : session_name::kEmpty;
    text += "<DataSet timestep=\"" + time + "\" part=\"" + std::to_string(static_cast<int>(names.part)) + "\" name=\"" +
            names.folder + "\" file=\"" + file + "\"/>\n";
  }
}

std::string make_pvd(const std::vector<SessionStep>& steps, bool frames) {
  std::string text = kPvdStart;
  text.reserve(text.size() + steps.size() * 4 * 110);
  for (const SessionStep& step : steps) append_pvd(step, frames, text);
  return text + kPvdEnd;
}

}  // namespace pellucida
