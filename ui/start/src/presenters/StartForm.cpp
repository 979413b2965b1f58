#include "presenters/StartForm.h"

#include <cmath>
#include <utility>

#include "pellucida/core/Words.h"
#include "pellucida/session/SessionSource.h"
#include "pellucida/visualization/Readout.h"
#include "presenters/NumberField.h"

namespace pellucida {
namespace {

using Decision = std::variant<StartChoice, StartProblem>;

constexpr double kSameSize_ratio = 1e-3;

Decision decide_virtual(const StartForm& form) {
  StartChoice choice;
  choice.source = "virtual:" + form.scenario;
  if (form.stiffness != "1") choice.source += ",cell.stiffness_ratio=" + form.stiffness;
  choice.hand = form.hand;
  return choice;
}

Decision decide_recording(const StartForm& form, const std::optional<PathJudgement>& judged) {
  if (form.path.empty()) {
    return StartProblem{StartField::kPath, say("Choose a file or a folder first, or drop one on this window.")};
  }
  if (judged && judged->kind == PathKind::kNeither) return StartProblem{StartField::kPath, judged->problem};
  if (judged && judged->kind == PathKind::kSession) return review_of(judged->path);
  if (is_session(form.path)) return review_of(form.path);
  const TypedNumber size = read_number(form.recording_pixel_um, kPixelSizeNumber);
  if (!size.problem.empty()) return StartProblem{StartField::kRecordingPixel, size.problem};
  if (judged && !size.value && !judged->pixel_size_um) {
    return StartProblem{StartField::kRecordingPixel,
                        say("The file does not state the size of a pixel: type it in µm, such as 0.825.")};
  }
  const TypedNumber rate = read_number(form.frame_rate_hz, kFrameRateNumber);
  if (!rate.problem.empty()) return StartProblem{StartField::kFrameRate, rate.problem};
  if (judged && !rate.value && !judged->frame_rate_hz) {
    return StartProblem{StartField::kFrameRate, say("The file does not state its frame rate: type it, such as 30.")};
  }
  StartChoice choice;
  choice.source = judged ? judged->path.string() : form.path;
  choice.profile = form.recording_profile;
  choice.pixel_size_um = size.value;
  choice.frame_rate_hz = rate.value;
  return choice;
}

Decision decide_camera(const StartForm& form) {
  if (form.camera.empty()) {
    return StartProblem{StartField::kCamera, say("There is no camera to start: connect one, then press Search again.")};
  }
  StartChoice choice;
  choice.source = form.camera;
  choice.profile = form.camera_profile;
  if (form.objective.empty()) {
    const TypedNumber size = read_number(form.specimen_pixel_um, kPixelSizeNumber);
    if (!size.problem.empty()) return StartProblem{StartField::kSpecimenPixel, size.problem};
    if (!size.value) {
      return StartProblem{StartField::kSpecimenPixel, say("Type the size of a pixel in µm, or choose the objective.")};
    }
    choice.pixel_size_um = size.value;
    return choice;
  }
  const ObjectiveSize size = size_by_objective(form.objective, form.camera_pixel_um);
  if (!size.problem.empty()) return StartProblem{StartField::kCameraPixel, size.problem};
  if (!size.pixel_size_um) {
    return StartProblem{StartField::kCameraPixel,
                        say("Type the edge of the camera's own pixel in µm; its data sheet states it.")};
  }
  choice.pixel_size_um = size.pixel_size_um;
  return choice;
}

Decision decide_lesson(const StartForm& form) {
  StartChoice choice;
  choice.mode = StartMode::kTeach;
  choice.lesson = form.lesson;
  choice.large_letters = form.large_letters;
  return choice;
}

}  // namespace

Decision decide(const StartForm& form, const std::optional<PathJudgement>& judged) {
  switch (form.card) {
    case StartCardId::kVirtual:
      return decide_virtual(form);
    case StartCardId::kRecording:
      return decide_recording(form, judged);
    case StartCardId::kCamera:
      return decide_camera(form);
    case StartCardId::kLesson:
      return decide_lesson(form);
  }
  return StartProblem{};
}

StartChoice review_of(const std::filesystem::path& session) {
  StartChoice choice;
  choice.mode = StartMode::kReview;
  choice.session = session.string();
  return choice;
}

ObjectiveSize size_by_objective(const std::string& objective, const std::string& camera_pixel_um) {
  const TypedNumber pixel = read_number(camera_pixel_um, kCameraPixelNumber);
  if (!pixel.value) return {{}, pixel.problem};
  constexpr NumberKind kMagnification{PELLUCIDA_WORDS("magnification"), PELLUCIDA_WORDS("times"), {0.1, 1000.0}, "20"};
  const TypedNumber magnification = read_number(objective, kMagnification);
  if (!magnification.value) return {{}, magnification.problem};
  return {specimen_pixel_um(*pixel.value, *magnification.value), {}};
}

std::string recording_note(const PathJudgement& judged, const std::string& typed_pixel_um) {
  std::string note = judged.caption;
  const TypedNumber typed = read_number(typed_pixel_um, kPixelSizeNumber);
  if (typed.value && judged.pixel_size_um && std::abs(*typed.value / *judged.pixel_size_um - 1.0) > kSameSize_ratio) {
    note += say("\nThe file states ") + readout::plain(*judged.pixel_size_um) + say(" µm a pixel; the typed ") +
            readout::plain(*typed.value) + say(" µm replaces it.");
  }
  return note;
}

std::string in_words_of_page(std::string text) {
  for (const auto& [option, field] :
       {std::pair("--pixel-size-um", say("the pixel size")), std::pair("--fps", say("the frame rate")),
        std::pair("--profile", say("the profile")), std::pair("--hand", say("the hand"))}) {
    for (auto at = text.find(option); at != std::string::npos; at = text.find(option)) {
      text.replace(at, std::string(option).size(), field);
    }
  }
  return text;
}

}  // namespace pellucida
