#pragma once
#include <cstdint>
#include <type_traits>

#include "pellucida/core/PlainVector.h"

namespace pellucida {

/// The basis of the contact force in a tick.
enum class ContactState : std::uint8_t {
  kNone,      ///< no frame yet
  kFree,      ///< the needle is out of contact
  kContact,   ///< the force of the newest frame, extrapolated with its stiffness
  kStale,     ///< the newest usable frame is too old: damped to zero
  kInvalid,   ///< the newest frame gave no usable numbers: damped to zero
  kPunctured  ///< the membrane gave way: released
};

/// State of the hand in a tick.
enum class HandState : std::uint8_t {
  kWaiting,   ///< no reading of the hand or the pipette yet: no force, pipette held
  kWorking,   ///< engaged: the pipette follows the hand
  kClutched,  ///< disengaged: pipette held, no force
  kHeld,      ///< hand or pipette lost: pipette held, no force
  kStopped    ///< emergency stop
};

/// One tick, for display and session. Trivially copyable: it goes through `SpscRing`. Hand in frame H (m, N), tip in
/// frame W (um, uN).
struct HapticRecord {
  double time_s = 0.0;  ///< on the run's clock
  PlainVector3 hand_m;
  PlainVector3 hand_velocity_m_per_s;
  PlainVector3 wanted_um;         ///< where the hand wants the tip, without smoothing
  PlainVector3 tip_um;            ///< commanded position of the tip
  PlainVector3 pipette_um;        ///< position reported by the manipulator
  PlainVector3 hand_force_N;      ///< written to the device
  PlainVector3 contact_force_uN;  ///< of the cell on the needle, as felt in this tick
  PlainVector3 guide_force_N;     ///< part of `hand_force_N`: the fixtures
  double depth_um = 0.0;          ///< indentation extrapolated to this tick
  double contact_age_s = 0.0;     ///< of the frame behind the contact force
  long contact_frame_index = -1;
  double energy_margin_J = 0.0;         ///< of the passivity observer: energy the hand put in and has not got back
  double hand_stiffness_N_per_m = 0.0;  ///< of the contact, at the hand
  double scale_um_per_m = 0.0;
  std::uint32_t limits = 0;    ///< mask of `limit_bit(LimitKind)` that acted
  std::uint32_t fixtures = 0;  ///< mask of `FixtureBit` that acted
  std::uint32_t buttons = 0;   ///< mask of `HandButton`
  ContactState contact_state = ContactState::kNone;
  HandState hand_state = HandState::kWaiting;
};
static_assert(std::is_trivially_copyable_v<HapticRecord>);

}  // namespace pellucida
