// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Throws a ToolError, one sentence with a remedy, where no window can be
 * opened: no X server answers, or it draws nothing in three dimensions. VTK itself
 * would abort. */
void requireDisplay();

} // namespace tools
} // namespace sedr
} // namespace pcl
