#include "pellucida/batch/RecordingList.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>

#include "pellucida/acquisition/FolderContent.h"
#include "pellucida/core/Error.h"
#include "pellucida/session/SessionSource.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

constexpr std::array kReservedNames{batch_name::kRecords,  batch_name::kSummary, batch_name::kGroups,
                                    batch_name::kOverview, batch_name::kReport,  batch_name::kUnfinished};

bool is_virtual_input(const std::string& input) {
  return input == "virtual" || input.starts_with("virtual:");
}

bool is_camera(const std::string& input) {
  return input.starts_with("v4l2:") || input.starts_with("gstreamer:") || input.starts_with("genicam:");
}

bool is_image_sequence(const FolderContent& content) {
  return content.videos.empty() && content.stacks.empty() && !content.images.empty();
}

// The last part of a path, also of "recordings/" and of ".".
std::string last_name(const fs::path& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return whole.has_filename() ? whole.filename().string() : whole.parent_path().filename().string();
}

/// A recording on its way to its name.
struct Found {
  Recording recording;  ///< its name without the ending
  std::string ending;   ///< "avi"
};

/// Searches one folder given on the command line, and all below it.
class FolderSearch {
 public:
  /// `label`: before all names and groups, where there are several folders; else empty.
  FolderSearch(RecordingList& list, std::vector<Found>& found, const fs::path& output, std::string label)
      : list_(list), found_(found), output_(fs::weakly_canonical(output)), label_(std::move(label)) {}

  /// `way`: from the folder given to this one; empty for itself.
  void search(const fs::path& folder, const fs::path& way) {
    std::error_code fault;
    const fs::path place = fs::weakly_canonical(folder, fault);
    // Results of an earlier run are no recordings, and a link may lead back.
    if (place == output_ || !seen_.insert(place).second) return;
    if (is_session(folder)) return add(folder, way, "session");
    FolderContent content;
    try {
      content = content_of(folder);
    } catch (const InputError&) {
      // Its row in the summary says why it can't be read.
      return add(folder, way, "folder");
    }
    if (is_image_sequence(content)) return add(folder, way, "images");
    for (const auto* files : {&content.videos, &content.stacks}) {
      for (const fs::path& file : *files) {
        const std::string ending = file.extension().string();
        add(file, way / file.stem(), ending.empty() ? ending : ending.substr(1));
      }
    }
    for (const fs::path& below : content.folders) search(below, way / below.filename());
    if (content.images.empty()) return;
    const std::string count = std::to_string(content.images.size());
    list_.notes.push_back(folder.string() + ": " + count + (count == "1" ? " image" : " images") +
                          " beside recordings left out; a sequence of images needs a folder of its own");
  }

 private:
  void add(const fs::path& input, const fs::path& way, const std::string& ending) {
    std::string name = label_;
    for (const fs::path& part : way) {
      if (!name.empty()) name += '_';
      name += part.string();
    }
    if (way.empty()) name = last_name(input);
    fs::path group = label_;
    if (way.has_parent_path()) group /= way.parent_path();
    if (group.empty()) group = last_name(fs::absolute(input).parent_path());
    found_.push_back({{name, input.string(), group.string()}, ending});
  }

  RecordingList& list_;
  std::vector<Found>& found_;
  fs::path output_;
  std::string label_;
  std::set<fs::path> seen_;
};

Found named_input(const std::string& input) {
  if (is_camera(input)) throw UsageError(input + ": a camera can't be part of a batch; record it first");
  const bool drawn = is_virtual_input(input);
  const auto scenario = input.find(':');
  const fs::path path = drawn && scenario != std::string::npos ? input.substr(scenario + 1) : input;
  const std::string ending = path.extension().string();
  Found found{{path.stem().string(), input, last_name(fs::absolute(path).parent_path())},
              ending.empty() ? ending : ending.substr(1)};
  if (drawn) found.recording.group = "virtual";
  return found;
}

/// Names must differ, also where capitals don't count, and leave the batch's own files alone.
void make_unique(std::vector<Found>& found) {
  const auto key = [](std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
  };
  std::map<std::string, int> count;
  for (Found& one : found) {
    // A line end in a name would break lists and messages.
    for (char& c : one.recording.name) c = static_cast<unsigned char>(c) < 0x20U ? '_' : c;
  }
  for (const char* reserved : kReservedNames) ++count[key(reserved)];
  for (const Found& one : found) ++count[key(one.recording.name)];
  std::set<std::string> taken(kReservedNames.begin(), kReservedNames.end());
  for (Found& one : found) {
    std::string& name = one.recording.name;
    if (count[key(name)] > 1 && !one.ending.empty()) name += '_' + one.ending;
    const std::string base = name;
    for (int number = 2; !taken.insert(key(name)).second; ++number) name = base + '_' + std::to_string(number);
  }
}

}  // namespace

bool is_batch_folder(const std::string& input) {
  std::error_code ignored;
  if (is_virtual_input(input) || is_camera(input) || !fs::is_directory(input, ignored) || is_session(input))
    return false;
  try {
    const FolderContent content = content_of(input);
    return !is_image_sequence(content) &&
           !(content.videos.empty() && content.stacks.empty() && content.folders.empty());
  } catch (const InputError&) {
    return false;
  }
}

RecordingList find_recordings(const std::vector<std::string>& inputs, const fs::path& output) {
  RecordingList list;
  std::vector<Found> found;
  const auto searched = std::count_if(inputs.begin(), inputs.end(), is_batch_folder);
  for (const std::string& input : inputs) {
    if (is_batch_folder(input)) {
      FolderSearch(list, found, output, searched > 1 ? last_name(input) : "").search(input, {});
    } else {
      found.push_back(named_input(input));
      std::error_code ignored;
      if (fs::is_directory(input, ignored))
        found.back() = {{last_name(input), input, found.back().recording.group}, ""};
    }
  }
  if (found.empty()) {
    throw InputError((inputs.empty() ? std::string("no input") : inputs.front()) +
                     ": no recording found; give videos, TIFFs of several pages, folders of images, sessions, or a "
                     "folder that holds them");
  }
  make_unique(found);
  for (Found& one : found) list.recordings.push_back(std::move(one.recording));
  return list;
}

}  // namespace pellucida
