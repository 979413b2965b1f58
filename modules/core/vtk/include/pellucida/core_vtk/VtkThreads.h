#pragma once

namespace pellucida {

/// From here on VTK's loops over arrays run on the thread that calls them. Ours are short: handing one to other threads
/// costs more than it takes, and asks the system for the number of processors each time. Call it before any other
/// thread uses VTK.
void keep_vtk_loops_on_their_thread();

}  // namespace pellucida
