#pragma once
#include "pellucida/report/CellPassport.h"

class vtkPolyData;

namespace pellucida {

/// Joins the ticks of a recording of the hand in which it deposited into stretches of time.
class DepositFinder {
 public:
  /// The next block of the recording (arrays `time_s`, `buttons`, `hand_state`); without them nothing is added.
  void add(vtkPolyData* paths);
  const std::vector<Deposit>& deposits() const noexcept { return deposits_; }

 private:
  std::vector<Deposit> deposits_;
};

/// All of a session's; a block that can't be read is left out and counted in `unread`.
std::vector<Deposit> hand_deposits(const SessionReader& session, std::vector<std::string>& unread);

}  // namespace pellucida
