// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_set.h"
#include "sedr_filters/src/grids/place_table.h"
#include "sedr_filters/src/plan/plan_surfaces.h"
#include "sedr_filters/src/plan/room_lookup.h"
#include "sedr_segmentation/src/openings/opening_search.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_segmentation/building.h>

#include <bitset>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace pcl::sedr {

constexpr double min_patch = 0.25; ///< of what is told, square metres
constexpr double off_wall = 0.05;  ///< metres from the model
constexpr double off_slab = 0.1;   ///< metres; columns of air end on voxels
constexpr double wall_tile = 0.1;  ///< metres
constexpr double relief = 0.15;    ///< metres; furniture is deeper
constexpr double reach = 0.9;      ///< beyond floors and ceilings, metres
constexpr double min_strip = 0.5;  ///< of what is told, metres of tiles

/** @brief A bit a step of height; 12.8 m in steps of a tile, rooms have up to 12 m. */
using HeightSteps = std::bitset<128>;

/** @brief Returns the bit of a height in steps, none beyond all of them. */
inline HeightSteps
stepAt(double height, double step)
{
  HeightSteps bit;
  if (height > 0 && height < static_cast<double>(bit.size()) * step)
    bit.set(static_cast<std::size_t>(height / step));
  return bit;
}

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double sigmas = 3; ///< of noise, off a surface

/** @brief A cell and a value that was found in it. */
using CellValue = std::pair<CellKey, double>;

/** @brief Returns the cells of some values, which must be in their order. */
CellSet cellsOf(const std::vector<CellValue>& values);

/** @brief Connected cells, of `least` square metres and more. */
struct Patches {
  std::size_t count = 0; ///< of cells
  double area = 0;
  double low = infinite; ///< of the values of the cells
  double high = -infinite;
  double mean = 0;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero(); ///< of the largest patch

  /** @param values in the order of their cells
   * @param size of a cell, metres */
  Patches(const std::vector<CellValue>& values, double size, double least = min_patch);
};

/** @brief Returns a warning about a floor or ceiling that was seen off its model. */
PlanWarning slabWarning(bool is_floor, const Patches& found, const PlanRoom& room);

/** @brief Returns the area of all surfaces of a room, square metres. */
double surfacesOf(const PlanRoom& room);

/** @brief What was seen of the surfaces of a plan and about them. */
class SeenSurfaces {
public:
  /** @param grid of the cells of floors and ceilings */
  SeenSurfaces(const Floorplan& plan, const CellGrid& grid);

  /** @brief Counts a point for the floor or ceiling that it lies on, and for what
   * stands on the floor away from walls. */
  void add(const Eigen::Vector3d& p);

  const RoomLookup& lookup(std::size_t room) const { return rooms_[room]; }

  /** @brief Returns the room in which a point lies, or a niche of which; -1: none. */
  int ownerOf(const Eigen::Vector3d& p) const;

  /** @brief Checks whether a cell shows points on the floor or ceiling of the r-th room
   * of the plan. */
  bool isOnSlab(std::size_t r, CellKey cell, bool is_floor) const
  {
    return on_slab_[2 * r + (is_floor ? 0 : 1)].count(cell) > 0;
  }

  /** @brief Appends warnings of what stands in rooms and of surfaces seen twice. */
  void tell(std::vector<PlanWarning>& warnings) const;

private:
  /** @brief A vertical surface of a room. */
  struct Vertical {
    VerticalSurface surface;
    double tolerance;                ///< of the points on it, metres
    std::vector<VerticalSpan> spans; ///< of each tile along it
    /** @brief Of each tile along it a bit each 5 cm, without those at both its ends. */
    std::vector<HeightSteps> seen{};
  };

  /** @brief Checks whether a point lies on vertical surfaces, and counts it for them.
   */
  bool isOnVertical(const Eigen::Vector3d& p);

  void addOff(const Eigen::Vector3d& p, std::size_t room);

  /** @brief Counts a point of no room below a floor or above a ceiling. */
  void addBeyond(const Eigen::Vector3d& p);

  /** @brief Warns of a ceiling in whose place much was seen above it, and of a floor
   * and a ceiling that both were seen twice, as in two scans that do not fit. */
  void tellBeyond(std::size_t room, std::vector<PlanWarning>& warnings) const;

  /** @brief Warns of parts of a ceiling that were not seen, if beside at least half of
   * their tiles something was seen that leads up, as between joists. */
  void tellCeilingGaps(std::size_t room, std::vector<PlanWarning>& warnings) const;

  /** @brief Warns of what was seen off all surfaces and meets the ceiling, once for
   * each thing. */
  void tellOff(std::size_t room, std::vector<PlanWarning>& warnings) const;

  /** @brief Warns of what stands free, is a metre long, ends below the ceiling, and has
   * the floor beside it on both sides, no farther away than a wall is thick: square
   * metres of its faces, and how high it is. */
  void tellHalfWalls(std::size_t room, std::vector<PlanWarning>& warnings) const;

  /** @brief Warns of lower parts of a ceiling, clear of the walls, of which no side up
   * to the rest was seen, if compared with the wall that was seen best. */
  void tellHanging(std::size_t room, std::vector<PlanWarning>& warnings) const;

  CellGrid grid_;
  CellGrid tiles_{wall_tile};
  std::vector<std::unordered_set<CellKey>> on_slab_; ///< floor and ceiling of each room
  std::vector<std::map<CellKey, float>> beyond_;     ///< heights seen beyond them
  struct Beyond {
    double heights = 0; ///< sum, metres
    std::size_t points = 0;
  };
  std::vector<std::map<CellKey, Beyond>> above_;        ///< the ceilings, in tiles
  std::vector<std::unordered_set<CellKey>> ceilings_;   ///< tiles that show them
  std::vector<std::map<CellKey, unsigned>> on_ceiling_; ///< points within 5 cm of them
  std::vector<std::unordered_set<CellKey>> above_ceiling_; ///< tiles with points above
  std::deque<RoomLookup> rooms_;
  PlaceTable rooms_near_;
  std::vector<Vertical> verticals_;
  PlaceTable verticals_near_;
  /** @brief What is seen off all surfaces in one tile of a room. */
  struct OffModel {
    double ceiling = 0;  ///< the lowest in and beside the tile: no step stands out
    HeightSteps heights; ///< of two points, in steps of a tile below the ceiling
    HeightSteps once;    ///< of one point and more
  };
  std::vector<std::map<CellKey, OffModel>> off_; ///< of each room
};

/** @brief Appends a warning for each wall off which much was seen, as the maps of its
 * room show: with nothing on it and something close before it, or behind it and in no
 * room; or where a ceiling goes on behind it: then a third value is for how many
 * metres, the second how far. Where an opening is, or its reveals, nothing counts, but
 * one as long as its wall, or as high with nothing seen beyond its back, may be the
 * wall. Niches as long as their wall are told of as well, and once a room lower parts
 * of its ceiling that end before their wall, if what is there instead, as behind a
 * beam, makes up 1 % of all surfaces. */
void tellOffWalls(const Floorplan& plan,
                  const OpeningSearch& maps,
                  const SeenSurfaces& rooms,
                  const Priors& priors,
                  std::vector<PlanWarning>& warnings);

/** @brief Returns what was seen and the plan does not explain, in connected places of
 * 0.25 m2 and more.
 *
 * Floors and ceilings: columns of air that end more than 10 cm off the model, and off
 * its noise; one warning a room for each if they make up 2 % of it, or as much as
 * furniture covers; and floor that was not seen if furniture cannot hide it. What may
 * be furniture by its size, see isAsFurniture(), does not count. Places within two
 * cells of a wall or column do not count, nor do those with points on the model, nor
 * those outside of the plan, which coverageOf() tells of.
 *
 * Walls and sides of columns: places with nothing on them and something seen behind,
 * not before, which is in no other room, and ceilings that go on behind, if they make
 * up 1 % of all surfaces of the room; and what lies 5 to 15 cm before them, if it makes
 * up 2 %. Openings and their reveals do not count. What lies off all surfaces and meets
 * the ceiling over half a metre, such as ribs, pilasters and curtains, if it makes up 1
 * %; lower parts of ceilings that end before their wall; and those that may hang there,
 * as no side up to the rest was seen: one warning a room for each; of what meets the
 * ceiling one for each thing.
 *
 * O(points + columns of the building + cells of the maps).
 * @param points thinned
 * @param building its rooms have the ids of those of the plan */
std::vector<PlanWarning> unexplainedSurfaces(const PointView& points,
                                             const Building& building,
                                             const Floorplan& plan,
                                             const OpeningSearch& maps,
                                             const Priors& priors = {});

} // namespace pcl::sedr
