#pragma once
#include <memory>
#include <string_view>

#include "pellucida/simulation/CommandedNeedle.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pellucida/teleoperation/SimulatedInjector.h"

namespace pellucida {

/// A virtual cell under a virtual microscope with an injector that a hand may move: the cell responds to the injector,
/// and the microscope shows it.
class VirtualInjectionSetup {
 public:
  /// The cell, optics and motion's start of a shipped scenario or a JSON file. Throws as load_scenario.
  explicit VirtualInjectionSetup(std::string_view scenario);

  /// The source of frames. `kWallClock` for a live run. Each call makes another microscope on the same needle.
  std::unique_ptr<VirtualMicroscope> make_microscope(Pace pace) const;

  /// Carries the needle; starts where the scenario's motion starts.
  SimulatedInjector& injector() noexcept { return *injector_; }
  CommandedNeedle& needle() noexcept { return *needle_; }
  const Scenario& scenario() const noexcept { return scenario_; }

 private:
  Scenario scenario_;
  std::shared_ptr<CommandedNeedle> needle_;
  std::unique_ptr<SimulatedInjector> injector_;
};

}  // namespace pellucida
