// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::sedr::benchmark {

struct RunRow;

/** @brief The requirements for every run of the benchmark. */
enum class Bar {
  Done,            ///< a structure exists, and a mesh if requested
  Rooms,           ///< the true number of rooms, each matched to a true one
  Closed,          ///< mesh closed, manifold, oriented
  Components,      ///< one component per room
  Mean,            ///< truth to mesh, at most meanLimit()
  Within1cm,       ///< truth to mesh, at least 95 %
  Within5cm,       ///< truth to mesh, at least 99 %
  ModelBeyond5cm,  ///< at most 0.5 % of the model's area
  DetailZone,      ///< at least 97 % of the zone around details within 5 cm
  PointsBeyond5cm, ///< without a mesh: at most 0.5 % of the structure's points
  Covered,         ///< without a mesh: at least 99 % of the truth near a point
  SolidClosed,     ///< solids closed, manifold, oriented, one per room
  SolidCrossing,   ///< no two triangles of the solids intersect
  SolidMean,       ///< truth to solid, at most solidLimits()
  SolidMax,        ///< likewise
  SolidTriangles,  ///< at most 5000 if all walls are straight
  PlanArea,        ///< of every room within 1 %
  SolidVolume,     ///< within 0.5 %
  WallArea,        ///< within 2 %
  Radius,          ///< of every arc within 1 %
  Corners          ///< the true number in every room
};

constexpr double min_within_1cm = 0.95;
constexpr double min_within_5cm = 0.99;
constexpr double min_detail_within_5cm = 0.97;
constexpr double max_beyond_5cm = 0.005;

/** @brief Returns the maximum mean distance from truth to mesh in metres: 0.2 cm up to
 * a noise of 0.1 cm, 0.4 cm from 2 cm on, linear in between.
 * @param noise metres */
double meanLimit(double noise);

constexpr double max_area_error = 0.01;
constexpr double max_volume_error = 0.005;
constexpr double max_wall_area_error = 0.02;
constexpr double max_radius_error = 0.01;
constexpr std::size_t max_straight_triangles = 5000;

/** @brief Maximum distances from truth to solid, metres. */
struct SolidLimits {
  double mean = 0;
  double max = 0;
};

/** @brief Returns the limits for a noise: up to 0.1 cm mean 0.01 and maximum 0.1 cm, up
 * to 1 cm 0.03 and 0.5 cm, above 0.1 and 1 cm.
 * @param noise metres */
SolidLimits solidLimits(double noise);

/** @brief A bar that a run missed and its figure: "3 rooms of 4". */
struct Miss {
  Bar bar = Bar::Done;
  std::string text;
};

/** @brief Returns the short name of a bar for tables: "rooms". */
std::string nameOf(Bar bar);

/** @brief Returns the bars that a run missed. The bars of a mesh apply if one was
 * requested, otherwise those of points; those of solids always apply. Without details
 * or arcs, their bars do not apply. */
std::vector<Miss> missedBars(const RunRow& row);

} // namespace pcl::sedr::benchmark
