// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop.h"

#include <vector>

namespace pcl::sedr::sim {

/** @brief Returns metres along an element every few centimetres, both ends included. */
std::vector<double> stepsAlong(const Element& element);

/** @brief Returns points every few centimetres, @p inwards metres left of a loop. */
std::vector<Vec2> samplesAlong(const Loop& loop, double inwards = 0.0);

} // namespace pcl::sedr::sim
