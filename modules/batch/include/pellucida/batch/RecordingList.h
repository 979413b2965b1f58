#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace pellucida {

/// One recording of a batch.
struct Recording {
  std::string name;   ///< of its result; unique in the batch, and usable as a folder's name
  std::string input;  ///< as on the command line: a file, a folder of images, a session, `virtual:SCENARIO`
  std::string group;  ///< the folder that holds it, relative to the folder given; that one's own name at its top
};

struct RecordingList {
  std::vector<Recording> recordings;  ///< in the order of the inputs, each folder's in the natural order of its names
  std::vector<std::string> notes;     ///< what was passed over, and why; a line each
};

/// True where one input is a batch: a folder that is neither a session nor a sequence of images, because it holds
/// videos, TIFFs of several pages, sessions or folders.
bool is_batch_folder(const std::string& input);

/// The recordings that the inputs name. A folder is searched with all folders below it, hidden ones and `output` left
/// out: videos (by their names), TIFFs of several pages, sessions, and folders of images as sequences. Where a folder
/// holds other recordings, single images beside them are passed over, with a note. A file that is named is taken,
/// whatever it is called.
///
/// A result is named after its recording, without the ending, with the folders on the way before it: `day2/cell4.avi`
/// becomes `day2_cell4`. Where two would have one name, the ending is added (`cell4_avi`, `cell4_mp4`), then a number.
///
/// Throws InputError where nothing is found, UsageError for a camera. An input that isn't there, or can't be read, is a
/// recording all the same: its failure is one row of the summary.
RecordingList find_recordings(const std::vector<std::string>& inputs, const std::filesystem::path& output);

/// Names in a batch's output that belong to the batch, not to a recording.
namespace batch_name {
inline constexpr const char* kRecords = "records";
inline constexpr const char* kSummary = "summary.csv";
inline constexpr const char* kGroups = "groups.csv";
inline constexpr const char* kOverview = "index.html";
inline constexpr const char* kReport = "report.html";  ///< the overview, under the name that scripts know
inline constexpr const char* kUnfinished = ".unfinished";
}  // namespace batch_name

}  // namespace pellucida
