// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop.h"

#include <vector>

namespace pcl::sedr::sim {

/** @brief Metres along an element every few centimetres, both ends included. */
std::vector<double> stepsAlong(const Element& element);

/** @brief Points along a loop every few centimetres, @p inwards metres to its left. */
std::vector<Vec2> samplesAlong(const Loop& loop, double inwards = 0.0);

} // namespace pcl::sedr::sim
