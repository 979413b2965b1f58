#include "presenters/PathJudgement.h"

#include <vector>

#include "pellucida/acquisition/FolderContent.h"
#include "pellucida/acquisition/OpenSource.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Words.h"
#include "pellucida/session/SessionSource.h"
#include "presenters/SourcePresenter.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

// An error's text without its words for the command line.
PathJudgement neither(const fs::path& path, const std::string& reason) {
  PathJudgement judgement;
  judgement.path = path;
  judgement.problem = say_message(reason) + say(" - give a video, a folder of images, or the folder of a session");
  return judgement;
}

PathJudgement session_in(const fs::path& folder) {
  PathJudgement judgement;
  judgement.kind = PathKind::kSession;
  judgement.path = folder;
  return judgement;
}

// The part of a caption that states a number which isn't in the files would be that of the stand-in.
std::string caption_of(const SourceInfo& info, bool has_size, bool has_rate) {
  SourceInfo known = info;
  std::string caption = source_caption(known);
  if (has_size && has_rate) return caption;
  return caption.substr(0, caption.find(" px") + 3) + (has_size ? "" : say(" · pixel size not in the file")) +
         (has_rate ? "" : say(" · frame rate not in the file"));
}

// Opens it with what its files state; what they leave open gets a stand-in, so that the rest is known.
PathJudgement open_recording(const fs::path& path) {
  constexpr double kStandIn = 1.0;
  for (const bool states_size : {false, true}) {
    for (const bool states_rate : {false, true}) {
      SourceOptions options;
      if (states_size) options.pixel_size_um = kStandIn;
      if (states_rate) options.frame_rate_hz = kStandIn;
      try {
        const SourceInfo info = open_source(path.string(), options)->info();
        PathJudgement judgement;
        judgement.kind = PathKind::kRecording;
        judgement.path = path;
        if (!states_size) judgement.pixel_size_um = info.pixel_size_um;
        if (!states_rate) judgement.frame_rate_hz = info.frame_rate_hz;
        judgement.caption = caption_of(info, !states_size, !states_rate);
        return judgement;
      } catch (const UsageError&) {
        // Pixel size or frame rate is in neither metadata nor options.
      }
    }
  }
  return neither(path, path.filename().string() + say(": pixel size and frame rate can't be settled"));
}

// The recording that a folder without images of its own stands for.
PathJudgement recording_below(const fs::path& folder) {
  const FolderContent content = content_of(folder);
  std::vector<fs::path> files = content.videos;
  files.insert(files.end(), content.stacks.begin(), content.stacks.end());
  if (!content.images.empty()) return open_recording(folder);
  if (files.size() == 1) return open_recording(files.front());
  const std::string name = folder.filename().string();
  if (files.empty()) return neither(folder, name + say(": no image, no video and no session in this folder"));
  return neither(folder,
                 name + ": " + std::to_string(files.size()) + say(" recordings in this folder; choose one of them"));
}

}  // namespace

PathJudgement judge_path(const fs::path& path) {
  try {
    if (is_session(path)) return session_in(path);
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) return recording_below(path);
    // One of a session's files means its session.
    if (fs::is_regular_file(path, ignored) && is_session(path.parent_path())) return session_in(path.parent_path());
    return open_recording(path);
  } catch (const std::exception& error) {
    return neither(path, error.what());
  }
}

}  // namespace pellucida
