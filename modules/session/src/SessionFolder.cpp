#include "SessionFolder.h"

#include <charconv>
#include <cstdio>

#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

// `folder/stem_00000012.vtp`
std::string numbered_file(const char* folder, const char* stem, const char* extension, long number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%08ld", number);
  return std::string(folder) + '/' + stem + '_' + digits + extension;
}

// The number in `stem_00000012.vtp`.
std::optional<long> number_of(const char* stem, std::string_view extension, std::string_view file_name) {
  const std::string start = std::string(stem) + '_';
  if (!file_name.starts_with(start) || !file_name.ends_with(extension)) return std::nullopt;
  if (file_name.size() <= start.size() + extension.size()) return std::nullopt;

  const std::string_view digits = file_name.substr(start.size(), file_name.size() - start.size() - extension.size());
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

std::string make_pvd(const std::vector<SessionStep>& steps, bool frames) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  text.reserve(text.size() + steps.size() * 4 * 110);
  for (const SessionStep& step : steps) {
    const std::string time = csv_number(step.time_s);
    for (const PartNames& names : kParts) {
      const bool image = names.part == SessionPart::kFrame;
      if (image && (!frames || !step.has(names.part))) continue;
      const std::string file = step.has(names.part) ? part_file(names.part, step.frame_index) : session_name::kEmpty;
      text += "<DataSet timestep=\"" + time + "\" part=\"" + std::to_string(static_cast<int>(names.part)) +
              "\" name=\"" + names.folder + "\" file=\"" + file + "\"/>\n";
    }
  }
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace pellucida
