#pragma once
#include <string>

#include "commands/PlaybackOption.h"
#include "pellucida/acquisition/OpenSource.h"
#include "pellucida/pipeline/PipelineOptions.h"
#include "pellucida/session/SessionSource.h"
#include "pellucida/ui/WindowOptions.h"

namespace pellucida {

/// What a run of the workstation needs to know, from the command line or from the start page.
struct WorkstationArguments {
  std::string source = "virtual";
  PipelineOptions pipeline;
  SourceOptions source_options;
  PlaybackOptions playback;
  double speed_ratio = 1.0;
  std::string mode = "guide";
  std::string lesson;
  bool large_letters = false;
  std::string hand;
  std::string session;
  std::string compare;
  std::string path;  ///< given alone: a session or a recording
  WindowOptions window;
  bool replace = false;  ///< the picture and the figures may replace files that are there
};

/// Runs the window of the mode (guide, review, teach) until it is closed; true when the person wants the start page
/// next. Guide without a display measures headless.
/// Throws UsageError, InputError, DeviceError and OutputError as the windows and sources do.
bool run_workstation(const WorkstationArguments& arguments);

/// The start page, then what is chosen there, then the page again, until it is closed. A choice that fails is an error
/// on the page. With a `path`: a session is shown at once, a recording is filled in. Throws DeviceError without a
/// display.
void run_start_mode(const WorkstationArguments& arguments);

}  // namespace pellucida
