// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/impl/cell_grid.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief A profile of a room: the ends of its gap below and above, metres. */
struct RoomColumn {
  Cell cell; ///< of the grid of BuildingRooms
  float floor = 0;
  float ceiling = 0;
  bool floor_seen = true;   ///< false: hidden, taken from those beside it
  bool ceiling_seen = true; ///< likewise
};

/** @brief A room: a connected part of the free space of a building, as a height field.
 */
struct BuildingRoom {
  std::uint32_t id = 0;            ///< from 1, largest first
  std::uint32_t storey = 0;        ///< PlanStorey::number
  std::vector<RoomColumn> columns; ///< by the keys of their cells
  double floor = 0;          ///< lowest floor height with at least a fifth of the area
  double ceiling = 0;        ///< most frequent ceiling height
  double area = 0;           ///< square metres
  double enclosure = 0;      ///< share of its outline with walls, without doors
  double inferred = 0;       ///< of its area: neither floor nor ceiling was seen
  double unseen_outline = 0; ///< length of its outline along which neither a wall nor
                             ///< an opening was seen, metres
};

/** @brief Reason why a seen region is no room. */
enum class LeftOutKind {
  Low,     ///< no sufficient area with headroom
  Open,    ///< no walls around it: outdoors, or seen through an opening
  Partial, ///< a room of which an opening shows a part
  Landing, ///< small and not on the floor of a storey
  Mirror,  ///< a reflection in a floor, or seen only through panes
  Void     ///< within slabs or below furniture
};

/** @brief A region that was seen and is no room. */
struct LeftOut {
  LeftOutKind kind = LeftOutKind::Low;
  std::string reason; ///< readable, e.g. "no walls around it"
  double area = 0;    ///< in plan, square metres
  double floor = 0;   ///< metres
  double ceiling = 0;
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< a position in it
};

/** @brief A link of two rooms of a storey: where one walks from one to the other. */
struct RoomLink {
  std::array<std::uint32_t, 2> rooms{};            ///< ids, increasing
  Eigen::Vector2d start = Eigen::Vector2d::Zero(); ///< at one jamb
  Eigen::Vector2d end = Eigen::Vector2d::Zero();   ///< at the other
  double bottom = 0;                               ///< metres
  double top = 0;                                  ///< metres

  double width() const { return (end - start).norm(); }
  double height() const { return top - bottom; }
};

/** @brief Two rooms that may be one, or a part of a room that may be one of its own. */
struct RoomDoubt {
  std::array<std::uint32_t, 2> rooms{}; ///< ids, increasing; the same: parts of a room
  Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< where they meet
  double area = 0;                              ///< of the smaller, square metres
  double chance = 0;                            ///< probability that they are so
};

/** @brief The owner of a point: the room whose air the surface there bounds. */
struct PointOwner {
  std::uint32_t room = 0; ///< number of the room, 0: none
  bool beyond = false;    ///< farther away than walls are: seen behind one
};

/** @brief A building: rooms, storeys, links and stairs of a scan, see RoomSegmentation.
 */
struct Building {
  CellGrid grid{0};    ///< of the profiles of its rooms; of size 0 where there are none
  BuildingFrame frame; ///< from the scan to that of the grid
  std::vector<BuildingRoom> rooms;
  std::vector<PlanStorey> storeys; ///< from the lowest up
  std::vector<RoomLink> links;     ///< on a storey; between two there are stairs
  std::vector<PlanStair> stairs;
  std::vector<LeftOut> left_out; ///< largest first
  std::vector<RoomDoubt> doubts; ///< of a chance of a quarter at least, and as
                                 ///< large as a room may be
  double seen_area = 0;          ///< area of all free space that was seen, in plan, m2

  /** @brief Room of every point of the scan, 0 for none, and its label: ceiling (1),
   * floor (2) or neither (0), see StructureLabel. */
  std::vector<std::uint32_t> room_of;
  std::vector<std::uint32_t> label_of;

  /** @brief Owner of every point of the scan: that of the gap nearest in space with no
   * other between. */
  std::vector<PointOwner> owner_of;
};

/** @brief Adds to a plan the storeys and stairs of a building, for the rooms in the
 * plan. Rooms are matched by their ids. */
void giveStoreys(const Building& building, Floorplan& plan);

/** @brief Returns a warning about each link of two rooms of a plan that no opening
 * between them is at, see isAt(): the plan has a wall there, or an opening that leads
 * elsewhere. O(links times openings). */
std::vector<PlanWarning> linksWithoutOpening(const Building& building,
                                             const Floorplan& plan);

/** @brief Returns a warning about each doubt of a building about rooms of a plan. */
std::vector<PlanWarning> doubtsOfRooms(const Building& building, const Floorplan& plan);

/** @brief Finds the frame of a building, in which what is found on grids does not
 * depend on where and how its scan lies.
 *
 * The direction that most wall has (modulo 90 degrees, to a hundredth of a degree) and
 * the side to which the building extends most give its direction; the largest walls in
 * both directions and the largest level surface give its origin. Its axes lie half a
 * radian aside of the walls: these then cross the cells of a grid at all places, so
 * that what cells do to a wall averages out along it, while along an axis a whole wall
 * would depend on where in its cells it lies. Walls are told by what stands out from
 * the points around it, each voxel counting once. If no direction stands out, as in a
 * round room, the frame is that of the weak maximum; without walls, that of the scan.
 *
 * @code
 * const pcl::sedr::BuildingFrame frame =
 *     pcl::sedr::findBuildingFrame(pcl::sedr::PointView(*thinned), indices);
 * for (auto& p : *thinned)
 *   p.getVector3fMap() =
 *       frame.toBuilding(p.getVector3fMap().cast<double>()).cast<float>();
 * @endcode
 * O(n log n) for n points; the same for any number of threads.
 * @param points thinned, metres
 * @param indices the points to use; empty: all
 * @param level rotation that makes the scan level, see Levelling
 * @param cell edge of the cells of the stages that follow, metres
 * @param threads 0: all processors */
BuildingFrame
findBuildingFrame(const PointView& points,
                  const std::vector<int>& indices = {},
                  unsigned threads = 0,
                  const Eigen::Matrix3d& level = Eigen::Matrix3d::Identity(),
                  double cell = 0.05);

} // namespace pcl::sedr
