#include "commands/Commands.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <map>

#include "commands/CommandLine.h"
#include "commands/FieldOption.h"
#include "commands/GuidedSession.h"
#include "commands/MeasureSession.h"
#include "commands/Versions.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "pellucida/simulation/ModalityName.h"

namespace pellucida {
namespace {

struct InjectArguments {
  SimulatedInjectionOptions operated;
  PipelineOptions pipeline;
  std::string output;
  bool no_frames = false;
};

void inject(const InjectArguments& arguments) {
  PipelineOptions pipeline = arguments.pipeline;
  pipeline.versions = library_versions();
  const GuidedResult result = measure_guided_session(arguments.operated, pipeline, arguments.output,
                                                     {.frames = !arguments.no_frames}, command_line());
  std::cout << summary(result.measured, arguments.output) << summary(result.injection);
  require_measured(result.measured, "virtual:" + arguments.operated.scenario);
}

}  // namespace

void add_inject_command(CLI::App& app) {
  auto arguments = std::make_shared<InjectArguments>();
  CLI::App* command = app.add_subcommand(
      "inject", "a guided injection by a simulated operator on the virtual microscope, recorded as a session");
  command->add_option("--output", arguments->output, "folder of the new session")->required();
  command->add_option("--scenario", arguments->operated.scenario, "of the virtual microscope, by name or JSON file")
      ->capture_default_str();
  // The names of `trial`, and those of earlier versions.
  std::map<std::string, Modality> modalities{{"image", Modality::kFlatImage},
                                             {"3d+haptics", Modality::kSpaceAndHaptics},
                                             {"3d+haptics+guide", Modality::kSpaceAndFixture}};
  for (const Modality modality : kModalities) modalities[option_of(modality)] = modality;
  command
      ->add_option(
          "--modality", arguments->operated.simulated_operator.modality,
          "what the operator sees and feels: 2d, 3d, haptics or guide (default), as in trial; or by the earlier "
          "names image, 3d+haptics, 3d+haptics+guide")
      ->transform(CLI::CheckedTransformer(modalities).description(""));
  command->add_option("--seed", arguments->operated.seed, "of the operator")
      ->check(number_in({0.0, kMostSeed}))
      ->capture_default_str();
  command
      ->add_option("--vision-delay-s", arguments->operated.vision_delay_s,
                   "delay from a frame's exposure to its force at the hand, s")
      ->check(number_in({0.0, 1.0}))
      ->capture_default_str();
  command
      ->add_option("--max-duration-s", arguments->operated.max_duration_s, "time after which the operator gives up, s")
      ->check(number_in({1.0, 3600.0}))
      ->capture_default_str();
  command->add_option("--profile", arguments->pipeline.profile, "cell profile, by name or file")->capture_default_str();
  command->add_flag("--no-frames", arguments->no_frames, "keep no images in the session");
  command->callback([arguments] { inject(*arguments); });
}

}  // namespace pellucida
