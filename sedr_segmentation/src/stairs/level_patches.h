// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../air/voxel_columns.h"

#include <pcl/sedr_filters/impl/cell_grid.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/building.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace pcl::sedr {

/** @brief What is believed of stairs; metres. Building codes ask for rises of 0.14 to
 * 0.2 and goings of 0.22 to 0.37, on the line on which one walks. */
struct StairPriors {
  double min_rise = 0.12;
  double max_rise = 0.22;
  double min_going = 0.1; ///< of winders, near the newel
  double max_going = 0.45;
  double deepest = 0.55;    ///< of a tread; what is deeper is a landing
  double min_area = 0.02;   ///< square metres, of the part of a tread that was seen
  double clearance = 1.2;   ///< of the air above one
  double level = 0.025;     ///< a surface rises by less a cell or two
  double flatness = 0.02;   ///< standard deviation of its heights
  double rise_sigma = 0.02; ///< of the steps of a flight
  double going_sigma = 0.06;
  double turn_sigma = 0.6;  ///< radians a step
  double step_gain = 3;     ///< nats that the next step is worth against furniture
  double missing = 2.5;     ///< nats that a tread costs which was not seen
  int max_missing = 3;      ///< of treads that follow each other
  double floor_gain = 3;    ///< nats that the floor at an end of a chain is worth
  double chain_cost = 9;    ///< nats: a chain may begin anywhere
  double min_odds = 4;      ///< nats of a chain that is told
  double same_floor = 0.08; ///< metres between heights of one floor
  double near = 0.6;        ///< metres from the end of a flight to its floor, and from
                            ///< treads to their underside
  double level_sigma = 0.012; ///< of the height of a patch, metres
  double edge_sigma = 0.03;   ///< of its front and its back
  double oblique = 3;         ///< nats: one flight in twenty is along no wall beside it
  double around = 2.5;        ///< metres from treads to the walls that tell directions
  double wall = 1;            ///< metres of height of a surface of a wall
  int max_unseen = 20;        ///< treads from the last one that was seen to a floor
};

inline constexpr StairPriors stair_priors;

/** @brief The main floors of rooms, by place: neither treads nor platforms. */
class RoomFloors {
public:
  struct Floor {
    std::uint32_t room = 0; ///< 0: none
    double z = 0;
  };

  /** @param voxel height of the voxels, metres: floors are within those below the air
   */
  RoomFloors(const Building& building, double voxel);

  /** @brief Returns the floor at a height near a place.
   * @param same metres that it may be off
   * @param away metres that it may be from there; 0: in the place's cell */
  Floor near(const Eigen::Vector2d& place,
             double z,
             double same = stair_priors.same_floor,
             double away = stair_priors.near) const;

  /** @brief Whether a floor lies between two treads that are some steps apart. */
  bool part(const Eigen::Vector2d& from,
            double low,
            const Eigen::Vector2d& to,
            double high,
            int steps) const;

private:
  CellGrid grid_;
  std::unordered_map<CellKey, std::vector<Floor>> at_;
};

/** @brief A level patch: a tread, the upper edge of a riser above which the tread was
 * not seen, a landing, or the top of furniture. */
struct LevelPatch {
  std::vector<Eigen::Vector2d> cells; ///< means of their points
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double z = 0;
  bool is_tread = false;
  Eigen::AlignedBox2d box{};

  /** @brief The lower and the upper end of its cells along a direction. */
  std::array<double, 2> extent(const Eigen::Vector2d& way) const
  {
    std::array<double, 2> ends{way.dot(middle), way.dot(middle)};
    for (const Eigen::Vector2d& c : cells)
      ends = {std::min(ends[0], way.dot(c)), std::max(ends[1], way.dot(c))};
    return ends;
  }
};

/** @brief Finds the level patches of a scan, with air above, that are no floors of
 * rooms; from below. O(columns + points). */
std::vector<LevelPatch> levelPatches(const PointView& points,
                                     const std::vector<int>& indices,
                                     const VoxelColumns& fine,
                                     const RoomFloors& floors);

} // namespace pcl::sedr
