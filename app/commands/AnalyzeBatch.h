#pragma once
#include <string>
#include <vector>

namespace pellucida {

/// The arguments of `analyze` for a batch of recordings.
struct BatchArguments {
  std::vector<std::string> inputs;
  std::string output;
  std::vector<std::string> options;  ///< of each recording, as its own call takes them
  std::string profile_sha256;        ///< of the cell profile's content
  int job_count = 1;
  bool again = false;             ///< also what is finished
  bool list = false;              ///< say what there is to do, and do nothing
  bool collect = false;           ///< analyse nothing, write the tables and the page
  std::vector<std::string> only;  ///< names of the recordings to do, without tables and page; empty: all, with them
  std::string group_by;           ///< `folder`, or a table of conditions; empty: no groups
};

/// Analyses all recordings of the inputs, each in a process of its own, into `output/NAME`; then writes `summary.csv`,
/// the overview page and, with groups, `groups.csv`. Throws SomeFailedError when some weren't measured to their end,
/// UsageError, InputError, OutputError.
void analyze_batch(const BatchArguments& arguments);

}  // namespace pellucida
