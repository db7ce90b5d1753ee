// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "two_storeys.h"

#include "sedr_surface/src/drawing/plan_drawing.h"

#include <string>

namespace sedr_test {

using namespace pcl::sedr;

inline Floorplan
planOf(const PlanLoop& boundary)
{
  return {{roomOf(boundary, 2.5)}};
}

inline bool
holds(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/** Settings with the given scale. */
inline DrawingSettings
scaled(double scale)
{
  DrawingSettings settings;
  settings.scale = scale;
  return settings;
}

inline DrawingSettings
sheetOf(const PlanStorey& storey)
{
  DrawingSettings settings;
  settings.storey = &storey;
  return settings;
}

} // namespace sedr_test
