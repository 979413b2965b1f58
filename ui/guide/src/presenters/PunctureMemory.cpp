#include "presenters/PunctureMemory.h"

#include <cstdio>

#include "pellucida/core/NewCellNote.h"
#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {

void PunctureMemory::take(std::span<const Event> events) {
  for (const Event& event : events) {
    if (event.kind == event_kind::kPuncture) {
      Puncture now{.time_s = event.time_s};
      // uN um are pJ.
      if (std::sscanf(event.detail.c_str(), "at %lf uN and %lf um, work %lf", &now.force_uN, &now.depth_um,
                      &now.work_pJ) == 3) {
        last_ = now;
        found_anew_ = false;
      }
    } else if (begins_new_cell(event) || event.kind == event_kind::kRevoked ||
               (event.kind == event_kind::kContact && found_anew_)) {
      last_.reset();
      found_anew_ = false;
    } else if (event.kind == event_kind::kFound) {
      found_anew_ = last_.has_value();
    }
  }
}

std::string PunctureMemory::text() const {
  if (!last_) return {};
  return readout::number(last_->force_uN, 2) + " µN · " + readout::number(last_->depth_um, 1) + " µm · " +
         readout::number(last_->work_pJ, 1) + " pJ";
}

}  // namespace pellucida
