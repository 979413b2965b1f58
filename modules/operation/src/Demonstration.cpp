#include "Demonstration.h"

#include "pellucida/simulation/OperatorPlan.h"

namespace pellucida {
namespace {

constexpr double kLearntLag_s = 0.05;  // the pipette's report behind the hand: injector, its turns, the window's tick

// Slow enough to be followed with the eye.
constexpr double kInsertionSpeed_um_per_s = 14.0;
constexpr double kInject_s = 1.5;

}  // namespace

std::unique_ptr<SimulatedHand> Demonstration::next_operator(const InjectionPlan& plan, double scale_um_per_m,
                                                            Modality modality) {
  OperatorOptions options;
  options.modality = modality;
  OperatorPlan way = operator_plan(plan, scale_um_per_m, kLearntLag_s);
  way.inject_s = kInject_s;
  way.insertion_speed_um_per_s = kInsertionSpeed_um_per_s;
  return std::make_unique<SimulatedHand>(options, way, ArmOptions{}, seed_++);
}

bool Demonstration::rested(OperatorPhase phase, double now_s) noexcept {
  if (phase != OperatorPhase::kDone) {
    ended_s_.reset();
    return false;
  }
  if (!ended_s_) ended_s_ = now_s;
  return now_s - *ended_s_ >= rest_s_;
}

const char* doing_words(OperatorPhase phase) noexcept {
  switch (phase) {
    case OperatorPhase::kLook:
      return "Looking";
    case OperatorPhase::kApproach:
      return "Approaching";
    case OperatorPhase::kInsert:
      return "Inserting";
    case OperatorPhase::kDeposit:
      return "Depositing";
    case OperatorPhase::kRemove:
      return "Taking the needle out";
    case OperatorPhase::kDone:
      return "Done; a new cell follows";
  }
  return "";
}

}  // namespace pellucida
