#include "presenters/StartLists.h"

#include <algorithm>
#include <regex>

#include "pellucida/core/Resources.h"
#include "pellucida/core/Words.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/simulation/Scenario.h"
#include "pellucida/teaching/Lesson.h"
#include "pellucida/teleoperation/DeviceSearch.h"

namespace pellucida {
namespace {

constexpr const char* kScenarioForHands = "injection";

// "Mouse oocyte, zona pellucida": the kind is what comes before the comma.
std::string kind_of(const CellProfile& profile) {
  const std::string description = say_message(profile.description);
  return description.substr(0, description.find(','));
}

// "44 um, 7.5 uN" as a window writes it.
std::string with_micro_signs(const std::string& text) {
  static const std::regex unit("([0-9]) u([mN])\\b");
  return std::regex_replace(text, unit, "$1 µ$2");
}

}  // namespace

std::vector<StartEntry> scenario_entries() {
  std::vector<StartEntry> entries;
  for (const auto& name : scenario_names()) {
    entries.push_back({name, name, with_micro_signs(say_message(load_scenario(name).description))});
  }
  std::stable_partition(entries.begin(), entries.end(),
                        [](const StartEntry& entry) { return entry.value == kScenarioForHands; });
  return entries;
}

std::vector<StartEntry> hand_entries() {
  return {
      {"demonstration", say("Demonstration"), say("A simulated operator injects cell after cell.")},
      {"mouse", say("Mouse and keyboard"), say("You move the needle yourself.")},
      {"none", say("The scenario's own motion"), say("The needle moves as the scenario describes, again and again.")}};
}

std::vector<StartEntry> stiffness_entries() {
  const std::string hidden =
      say(" The window measures with the usual cell's profile and does not know: Scale finds it out.");
  return {{"1", say("As usual"), say("The cell is as stiff as its profile says.")},
          {"0.5", say("Half as stiff"), say("Every push needs half the force.") + hidden},
          {"1.5", say("1.5 times as stiff"), say("Every push needs one and a half times the force.") + hidden},
          {"2", say("Twice as stiff"), say("Every push needs twice the force.") + hidden},
          {"4", say("Four times as stiff"), say("Every push needs four times the force.") + hidden}};
}

std::vector<StartEntry> profile_entries() {
  std::vector<StartEntry> entries;
  for (const auto& name : list_resources("profiles", ".json")) {
    const CellProfile profile = load_profile(name);
    entries.push_back({name, name + " (" + kind_of(profile) + ")", say_message(profile.description)});
  }
  // The oocyte is the program's default.
  const auto usual =
      std::find_if(entries.begin(), entries.end(), [](const auto& e) { return e.value == "mouse-oocyte"; });
  if (usual != entries.end()) std::rotate(entries.begin(), usual, usual + 1);
  return entries;
}

std::vector<StartEntry> lesson_entries() {
  std::vector<StartEntry> entries;
  for (const auto& lesson : all_lessons(say("lessons"))) {
    entries.push_back({lesson.name, std::to_string(entries.size() + 1) + ". " + lesson.title, lesson.title});
  }
  return entries;
}

std::vector<StartEntry> objective_entries() {
  std::vector<StartEntry> entries{{"", say("None: I type the pixel size"), ""}};
  for (const char* magnification : {"4", "10", "20", "32", "40", "60", "63", "100"}) {
    entries.push_back({magnification, std::string(magnification) + "×", ""});
  }
  return entries;
}

CameraList camera_list(const std::filesystem::path& listing) {
  CameraList list;
  std::string reasons;
  for (const auto& report : search_cameras(listing)) {
    if (report.usable) {
      list.cameras.push_back(
          {report.name, report.detail.empty() ? report.name : report.name + "  " + say_message(report.detail), ""});
    } else {
      reasons += (reasons.empty() ? "" : "\n") + say_message(report.detail);
    }
  }
  if (list.cameras.empty())
    list.notice = say("No camera can be used: ") + reasons + say(".\nConnect one, then press Search again.");
  return list;
}

int index_of(const std::vector<StartEntry>& entries, const std::string& value) noexcept {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return entry.value == value; });
  return found == entries.end() ? 0 : static_cast<int>(found - entries.begin());
}

}  // namespace pellucida
