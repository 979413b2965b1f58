#pragma once

namespace pellucida {

/// From now on the calling thread takes the core from no other when it wakes; it has its fair share all the same. For
/// what others will want soon, not now. Without effect where the system refuses.
void work_in_background() noexcept;

}  // namespace pellucida
