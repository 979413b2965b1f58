#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace pellucida {

/// One line of a list: the value behind it, what is shown, and a sentence on it. UTF-8.
struct StartEntry {
  std::string value;
  std::string title;
  std::string detail;
};

/// The shipped scenarios by name, with their description; `injection`, made for a hand, first. Throws as
/// `load_scenario`.
std::vector<StartEntry> scenario_entries();
/// What may move the needle of a virtual source, as `--hand` takes it.
std::vector<StartEntry> hand_entries();
/// How stiff the virtual cell is, as a factor on its forces.
std::vector<StartEntry> stiffness_entries();
/// The shipped profiles by name, with the kind of cell. Throws as `load_profile`.
std::vector<StartEntry> profile_entries();
/// The shipped lessons in their order. Throws as `all_lessons`.
std::vector<StartEntry> lesson_entries();
/// Objectives by magnification ("20" for 20x); the first, with an empty value, is for a pixel size that is typed.
std::vector<StartEntry> objective_entries();

/// The cameras that can be used, and what to say when there is none.
struct CameraList {
  std::vector<StartEntry> cameras;
  std::string notice;  ///< what to do; empty when there is a camera
};
/// Searches anew. `listing`: the system's folder of cameras.
CameraList camera_list(const std::filesystem::path& listing);

/// The index of `value` in `entries`; that of the first, 0, where it isn't.
int index_of(const std::vector<StartEntry>& entries, const std::string& value) noexcept;

}  // namespace pellucida
