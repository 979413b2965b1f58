#include "pellucida/operation/VirtualInjectionSetup.h"

namespace pellucida {

VirtualInjectionSetup::VirtualInjectionSetup(std::string_view scenario)
    : scenario_(load_scenario(scenario)), needle_(std::make_shared<CommandedNeedle>(scenario_)) {
  SimulatedInjectorOptions options;
  options.start_um = needle_->start_um();
  injector_ = std::make_unique<SimulatedInjector>(options, [needle = needle_](const InjectorPose& pose) {
    needle->move(pose.time_s, pose.tip_um, {}, pose.deposited_pl);
  });
}

std::unique_ptr<VirtualMicroscope> VirtualInjectionSetup::make_microscope(Pace pace) const {
  return std::make_unique<VirtualMicroscope>(scenario_, needle_, pace);
}

}  // namespace pellucida
