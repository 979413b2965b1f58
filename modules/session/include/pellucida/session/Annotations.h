#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pellucida {

/// What a person wrote about a recorded session afterwards: at a time, and optionally at a place of the image or on a
/// node of the surface.
struct Annotation {
  struct Place {
    double x_um = 0.0;  ///< frame W, image plane
    double y_um = 0.0;
  };
  double time_s = 0.0;  ///< of the session
  std::optional<Place> place_um;
  /// One more place: a distance from `place_um` to it was measured. Two: the angle at the first of them.
  std::vector<Place> further_um;
  std::optional<long> node;  ///< of the frame's surface, from 0
  std::string text;          ///< UTF-8, one line
};

/// The file of a session folder that holds them (docs/file-format.md).
inline constexpr const char* kAnnotationsFile = "annotations.csv";

/// The annotations of a session, in the order of time; none where it has no such file. Throws InputError, with file and
/// line, when it can't be read.
std::vector<Annotation> read_annotations(const std::filesystem::path& session);

/// Replaces the annotations in `folder`, in the order of time; without any the file goes. It is whole or as it was.
/// Throws OutputError when it can't be written.
void write_annotations(const std::filesystem::path& folder, std::vector<Annotation> annotations);

}  // namespace pellucida
