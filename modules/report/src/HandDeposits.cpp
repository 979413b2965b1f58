#include "HandDeposits.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cstdint>
#include <limits>

#include "pellucida/core/Error.h"
#include "pellucida/haptics/HapticDevice.h"
#include "pellucida/haptics/HapticRecord.h"

namespace pellucida {
namespace {

/// Ticks come every millisecond; some may be missing where a block is.
constexpr double kSameDeposit_s = 0.05;

}  // namespace

void DepositFinder::add(vtkPolyData* paths) {
  vtkDataArray* time = paths->GetPointData()->GetArray("time_s");
  vtkDataArray* buttons = paths->GetPointData()->GetArray("buttons");
  vtkDataArray* state = paths->GetPointData()->GetArray("hand_state");
  if (!time || !buttons || !state || paths->GetNumberOfCells() == 0) return;
  // Both paths have the same ticks.
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  paths->GetCellPoints(0, count, points);
  for (vtkIdType k = 0; k < count; ++k) {
    // A file may hold any number here.
    const double mask = buttons->GetComponent(points[k], 0);
    if (!(mask >= 0.0 && mask <= std::numeric_limits<std::uint32_t>::max())) continue;
    if (state->GetComponent(points[k], 0) != static_cast<double>(HandState::kWorking)) continue;
    if ((static_cast<std::uint32_t>(mask) & kInject) == 0U) continue;
    const double now_s = time->GetComponent(points[k], 0);
    if (deposits_.empty() || now_s - deposits_.back().end_s > kSameDeposit_s) deposits_.push_back({now_s, now_s});
    deposits_.back().end_s = now_s;
  }
}

std::vector<Deposit> hand_deposits(const SessionReader& session, std::vector<std::string>& unread) {
  DepositFinder finder;
  std::size_t bad_count = 0;
  std::string first;
  for (std::size_t block = 0; block < session.hand_block_count(); ++block) {
    try {
      finder.add(session.load_hand(block).shallow_copy());
    } catch (const InputError& error) {
      if (++bad_count == 1) first = error.what();
    }
  }
  if (bad_count > 0) {
    unread.push_back(std::to_string(bad_count) +
                     " block(s) of the hand's recording can't be read, the first: " + first);
  }
  return finder.deposits();
}

}  // namespace pellucida
