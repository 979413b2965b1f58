#include "presenters/StepLoader.h"

#include "pellucida/core/Error.h"
#include "pellucida/core/Words.h"
#include "pellucida/core_vtk/ObservationData.h"

namespace pellucida {

expected<LoadedStep, StepFailure> StepLoader::ReadStep::process(const std::size_t& step) {
  LoadedStep loaded;
  loaded.step = step;
  try {
    loaded.scene = reader.load(step);
    // The views take tools and axis from the observation, which the files hold too.
    if (loaded.scene.membranes) {
      const auto membranes = loaded.scene.membranes.shallow_copy();
      const auto tools = loaded.scene.tools ? loaded.scene.tools.shallow_copy() : nullptr;
      if (auto observation = read_observation(membranes, tools)) {
        loaded.scene.observation = std::make_shared<const Observation>(std::move(*observation));
      }
    }
  } catch (const std::exception& error) {
    loaded.error = say_message(error.what());
    loaded.scene = Scene{};
    loaded.scene.measurement = reader.measurements().at(step);
  }
  return loaded;
}

StepLoader::StepLoader(SessionReader reader)
    : read_{std::move(reader)},
      stage_(
          read_, requests_,
          [this](LoadedStep loaded) { results_.publish(std::make_shared<const LoadedStep>(std::move(loaded))); },
          clock_) {
  stage_.start();
}

StepLoader::~StepLoader() {
  stage_.stop();
}

void StepLoader::request(std::size_t step) {
  requested_ = step;
  taken_.reset();
  requests_.publish(step);
}

std::optional<LoadedStep> StepLoader::take() {
  if (results_.sequence() == sequence_) return std::nullopt;
  sequence_ = results_.sequence();
  const auto newest = results_.peek();
  if (!newest) return std::nullopt;
  taken_ = (*newest)->step;
  return **newest;
}

}  // namespace pellucida
