#include "commands/Versions.h"

#include <ceres/version.h>
#include <itkVersion.h>
#include <tiffio.h>
#include <vtkVersion.h>

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <QtGlobal>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>
#include <sstream>
#include <utility>
#include <vector>

#include "pellucida/core/Version.h"
#include "pellucida/teleoperation/GamepadHand.h"
#include "pellucida/teleoperation/SerialPort.h"
#include "pellucida/teleoperation/SpaceMouseHand.h"

namespace pellucida {
namespace {

std::string dotted(int major, int minor, int patch) {
  return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
}

/// "LIBTIFF, Version 4.5.0" and a line about its authors.
std::string tiff_version() {
  const std::string text = TIFFGetVersion();
  const std::string line = text.substr(0, text.find('\n'));
  return line.substr(line.rfind(' ') + 1);
}

// In the order in which they are printed.
std::vector<std::pair<const char*, std::string>> libraries() {
  return {
      {"VTK", vtkVersion::GetVTKVersion()},
      {"Qt", qVersion()},
      {"OpenCV", cv::getVersionString()},
      {"ITK", itk::Version::GetITKVersion()},
      {"libtiff", tiff_version()},
      {"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"Ceres Solver", CERES_VERSION_STRING},
      {"nlohmann JSON", dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
      {"CLI11", CLI11_VERSION}};
}

void add(std::ostream& text, const char* library, const std::string& version) {
  text << '\n' << std::left << std::setw(15) << library << version;
}

void add_device(std::ostream& text, const char* library, const std::string& version, const char* devices) {
  add(text, library, version.empty() ? std::string("not in this build: no ") + devices : version);
}

}  // namespace

std::map<std::string, std::string> library_versions() {
  std::map<std::string, std::string> versions;
  for (const auto& [library, version] : libraries()) versions[library] = version;
  return versions;
}

std::string version_text() {
  std::ostringstream text;
  text << "Pellucida " << kVersion;
  for (const auto& [library, version] : libraries()) add(text, library, version);
  add_device(text, "SDL", gamepad_library_version(), "gamepads");
  add_device(text, "libspnav", space_mouse_library_version(), "SpaceMouse");
  add_device(text, "libserialport", serial_port_library_version(), "manipulators on a serial port");
  return text.str();
}

}  // namespace pellucida
