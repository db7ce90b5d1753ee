// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace benchmark {

struct RunRow;

/** @brief What every run of the proving ground is to reach. */
enum class Bar {
  Done,            ///< a structure, and a mesh if one was asked for, came out
  Rooms,           ///< as many rooms as there are, each on a true one
  Closed,          ///< mesh closed, manifold, oriented
  Components,      ///< one component a room
  Mean,            ///< truth to mesh, at most meanLimit()
  Within1cm,       ///< truth to mesh, at least 95 %
  Within5cm,       ///< truth to mesh, at least 99 %
  ModelBeyond5cm,  ///< of the model's area, at most 0.5 %
  DetailZone,      ///< of the zone around details, at least 97 % within 5 cm
  PointsBeyond5cm, ///< without a mesh: of the structure's points, at most 0.5 %
  Covered,         ///< without a mesh: of the truth, at least 99 % near a point
  SolidClosed,     ///< solids closed, manifold, oriented, one a room
  SolidCrossing,   ///< no two triangles of the solids go through each other
  SolidMean,       ///< truth to solid, at most solidLimits()
  SolidMax,        ///< likewise
  SolidTriangles,  ///< at most 5000 where all walls are straight
  PlanArea,        ///< of every room within 1 %
  SolidVolume,     ///< within 0.5 %
  WallArea,        ///< within 2 %
  Radius,          ///< of every arc within 1 %
  Corners          ///< as many as there are, in every room
};

constexpr std::array<Bar, 21> all_bars{
    Bar::Done,       Bar::Rooms,           Bar::Closed,      Bar::Components,
    Bar::Mean,       Bar::Within1cm,       Bar::Within5cm,   Bar::ModelBeyond5cm,
    Bar::DetailZone, Bar::PointsBeyond5cm, Bar::Covered,     Bar::SolidClosed,
    Bar::SolidMean,  Bar::SolidMax,        Bar::SolidVolume, Bar::SolidCrossing,
    Bar::WallArea,   Bar::SolidTriangles,  Bar::PlanArea,    Bar::Radius,
    Bar::Corners};

/** @brief Whether a bar is one of the plan and its solids, which have a table of their
 * own. */
constexpr bool
isOfSolid(Bar bar)
{
  return bar >= Bar::SolidClosed;
}

constexpr double least_within_1cm = 0.95;
constexpr double least_within_5cm = 0.99;
constexpr double least_detail_within_5cm = 0.97;
constexpr double most_beyond_5cm = 0.005;

/** @brief Metres that truth and mesh may lie apart on average: 0.2 cm at a noise of
 * 0.1 cm, 0.4 cm at 2 cm; in between on the straight line, beyond as at its ends.
 * @param noise metres */
double meanLimit(double noise);

constexpr double most_area_error = 0.01;
constexpr double most_volume_error = 0.005;
constexpr double most_wall_area_error = 0.02;
constexpr double most_radius_error = 0.01;
constexpr std::size_t most_straight_triangles = 5000;

/** @brief Metres that a solid may be off the truth. */
struct SolidLimits {
  double mean = 0;
  double max = 0;
};

/** @brief 0.01 cm on average and 0.1 cm at most up to a noise of 0.1 cm, 0.03 and 0.5
 * cm up to 1 cm, 0.1 and 1 cm above.
 * @param noise metres */
SolidLimits solidLimits(double noise);

/** @brief A bar that a run missed, and by what: "3 rooms of 4". */
struct Miss {
  Bar bar = Bar::Done;
  std::string text;
};

/** @brief Short name of a bar for tables: "rooms". */
std::string nameOf(Bar bar);

/** @brief The bars a run missed. Those of a mesh are looked at if the run was to make
 * one, those of points if not; those of solids in any case. Without details or arcs
 * there is no bar for them. */
std::vector<Miss> missedBars(const RunRow& row);

} // namespace benchmark
} // namespace sedr
} // namespace pcl
