#include "HandDeposits.h"
#include "MembraneHistory.h"
#include "pellucida/report/CellPassport.h"
#include "pellucida/session/FramesUsed.h"

namespace pellucida {

PassportInput passport_input(const SessionReader& session, const SessionProgress& progress) {
  PassportInput input;
  const auto folder = std::filesystem::absolute(session.folder()).lexically_normal();
  input.session = (folder.has_filename() ? folder : folder.parent_path()).filename().string();
  input.profile = session.info().profile_name;
  input.rows = session.measurements();
  input.events = session.events();
  if (const auto used = frames_used_of(session.info())) input.run_starts = used->run_starts;
  input.membrane = membrane_history(session, progress, input.unread);
  input.is_hand_recorded = session.hand_block_count() > 0;
  input.deposits = hand_deposits(session, input.unread);
  return input;
}

std::vector<CellPassport> cell_passports(const SessionReader& session) {
  return cell_passports(passport_input(session));
}

}  // namespace pellucida
