#pragma once
#include <optional>
#include <string>
#include <variant>

#include "pellucida/start/StartChoice.h"
#include "presenters/PathJudgement.h"

namespace pellucida {

/// The cards of the start page, from left to right.
enum class StartCardId { kVirtual, kRecording, kCamera, kLesson };
inline constexpr int kStartCardCount = 4;

/// What a person has filled in: texts as typed, values as in the lists of `StartLists.h`.
struct StartForm {
  StartCardId card = StartCardId::kVirtual;

  std::string scenario = "injection";
  std::string hand = "demonstration";
  std::string stiffness = "1";  ///< times that of the scenario's cell

  std::string path;
  std::string recording_profile = "mouse-oocyte";
  std::string recording_pixel_um;  ///< empty: from the file
  std::string frame_rate_hz;       ///< empty: from the file

  std::string camera;
  std::string camera_profile = "mouse-oocyte";
  std::string objective;        ///< magnification; empty: the pixel size is typed
  std::string camera_pixel_um;  ///< edge of the camera's own pixel
  std::string specimen_pixel_um;

  std::string lesson;
  bool large_letters = false;
};

/// The places where an error can be shown.
enum class StartField { kCard, kPath, kRecordingPixel, kFrameRate, kCamera, kCameraPixel, kSpecimenPixel };

/// What is wrong, where, and how to correct it.
struct StartProblem {
  StartField field = StartField::kCard;
  std::string text;
};

/// A choice, or the first thing that is wrong with the form's card. `judged`: what the path of the form turned out to
/// be; nothing where it is not known, which leaves the checks to the source.
std::variant<StartChoice, StartProblem> decide(const StartForm& form, const std::optional<PathJudgement>& judged);

/// A session, to be reviewed.
StartChoice review_of(const std::filesystem::path& session);

/// The pixel size by the objective, um; or why there is none (neither: nothing was typed).
struct ObjectiveSize {
  std::optional<double> pixel_size_um;
  std::string problem;
};
ObjectiveSize size_by_objective(const std::string& objective, const std::string& camera_pixel_um);

/// What the note below the path says of a recording: its caption, and a warning where a typed number replaces another
/// one in the file.
std::string recording_note(const PathJudgement& judged, const std::string& typed_pixel_um);

/// An error of the run, in the words of the page: names of options become names of fields.
std::string in_words_of_page(std::string text);

}  // namespace pellucida
