// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl::sedr {

/** @brief Returns a clause with numbers if the system started fewer threads than were
 * requested by parallelBlocks(), else an empty one. Results do not depend on it. */
std::string refusedThreads();

} // namespace pcl::sedr
