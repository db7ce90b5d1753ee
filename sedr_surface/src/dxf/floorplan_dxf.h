// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../drawing/plan_drawing.h"

#include <string>

namespace pcl::sedr {

/** @brief Returns a drawing without a plan, such as a section, as DXF. */
std::string dxfOf(const Drawing& drawing, const DrawingSettings& settings);

} // namespace pcl::sedr
