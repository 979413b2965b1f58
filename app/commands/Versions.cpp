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

void add(std::ostream& text, const char* library, const std::string& version) {
  text << '\n' << std::left << std::setw(15) << library << version;
}

void add_device(std::ostream& text, const char* library, const std::string& version, const char* devices) {
  add(text, library, version.empty() ? std::string("not in this build: no ") + devices : version);
}

}  // namespace

std::string version_text() {
  std::ostringstream text;
  text << "Pellucida " << kVersion;
  add(text, "VTK", vtkVersion::GetVTKVersion());
  add(text, "Qt", qVersion());
  add(text, "OpenCV", cv::getVersionString());
  add(text, "ITK", itk::Version::GetITKVersion());
  add(text, "libtiff", tiff_version());
  add(text, "Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION));
  add(text, "Ceres Solver", CERES_VERSION_STRING);
  add(text, "nlohmann JSON",
      dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH));
  add(text, "CLI11", CLI11_VERSION);
  add_device(text, "SDL", gamepad_library_version(), "gamepads");
  add_device(text, "libspnav", space_mouse_library_version(), "SpaceMouse");
  add_device(text, "libserialport", serial_port_library_version(), "manipulators on a serial port");
  return text.str();
}

}  // namespace pellucida
