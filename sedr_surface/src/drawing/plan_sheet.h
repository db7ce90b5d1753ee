// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheet/sheet.h"

#include <pcl/sedr_surface/floorplan_drawing.h>

namespace pcl::sedr {

/** @brief Draws a plan, or one of its storeys, on a sheet; used by floorplanToSvg() and
 * floorplanToPdf(). */
Sheet planSheet(const Floorplan& plan, const DrawingSettings& settings);

} // namespace pcl::sedr
