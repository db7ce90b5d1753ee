// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results/result_folder.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>

namespace pcl::sedr::tools {

/** @brief Returns the points of the page: the scan, thinned to some hundred thousand
 * points as far as it lies within a metre of the model, or the refined structure if
 * there is no scan. Null without points.
 *
 * `places` are three 16-bit numbers a point, from `low` to `high`; `distances` of the
 * points from the mesh (absent without a mesh) one byte each in fiftieths of `range`,
 * 255 for more than half a metre; both are base64. The first `below` points lie below
 * the ceilings. `points` is the size of the whole scan.
 * @param path of the scan; empty: none
 * @param range distance that has the last colour, metres */
ResultFolder::Json pagePoints(const ResultFolder& folder,
                              const std::string& path,
                              const Floorplan& plan,
                              const TriangleMesh& mesh,
                              const TriangleMesh& solid,
                              double range);

/** @brief Number of steps in which colours of distances change. */
constexpr int distance_steps = 50;

/** @brief Returns bytes in base64. */
std::string base64(const void* bytes, std::size_t size);

} // namespace pcl::sedr::tools
