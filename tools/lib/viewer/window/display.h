// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl::sedr::tools {

/** @brief Throws ToolError with a remedy if no window can be opened: no X server
 * answers, or it cannot draw in 3D. VTK itself would abort. */
void requireDisplay();

} // namespace pcl::sedr::tools
