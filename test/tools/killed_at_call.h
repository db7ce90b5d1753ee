// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace programs {

/** Lets SIGKILL end the process at the n-th call from now on that opens, writes, syncs,
 * moves or removes a file or folder, before it is done; 0: at none. A program that has
 * killed_at_call.cpp among its sources calls these functions through it, as with a
 * preloaded library. */
void killAtCall(int n);

} // namespace programs
