// libFuzzer's entry: any bytes as what a replay takes from a stranger's session: measurements of the scale, parameters,
// profile; and hints among its events.
#include <cstddef>
#include <cstdint>
#include <string>

#include "pellucida/core/Error.h"
#include "pellucida/core/PersonHint.h"
#include "pellucida/pipeline/RunProvenance.h"
#include "pellucida/session/FramesUsed.h"

namespace {

template <class Read>
void read_or_refuse(Read read) {
  try {
    read();
  } catch (const pellucida::Error&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pellucida;
  const std::string text(reinterpret_cast<const char*>(data), size);
  SessionInfo palpation, provenance, profile;
  palpation.palpation_json = text;
  provenance.provenance_json = text;
  profile.profile_json = text;
  for (const SessionInfo* info : {&palpation, &provenance, &profile}) read_or_refuse([&] { recorded_options(*info); });
  read_or_refuse([&] { frames_used_of(provenance); });
  read_or_refuse([&] { frames_before_recording(provenance); });
  read_or_refuse([&] { hint_of(Event{0.0, event_kind::kHint, text}); });
  return 0;
}
