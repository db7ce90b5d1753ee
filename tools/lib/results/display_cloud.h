// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/impl/cell_grid.h>
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_filters/point_view.h>

#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A cloud for display: finite points without outliers, fewer than there are if
 * they are many. */
struct DisplayCloud {
  std::vector<Eigen::Vector3f> points; ///< metres, z up
  std::vector<std::uint32_t> labels;   ///< StructureLabel per point, or empty
  std::vector<std::uint32_t> rooms;    ///< 0 none; or empty
  std::size_t whole_size = 0;          ///< number of points represented
  double spacing = 0;                  ///< of thinned clouds, metres

  bool empty() const { return points.empty(); }
  std::size_t size() const { return points.size(); }
  StructureLabel label(std::size_t i) const
  {
    return static_cast<StructureLabel>(labels.empty() ? 0 : labels[i]);
  }
  std::uint32_t room(std::size_t i) const { return rooms.empty() ? 0 : rooms[i]; }
};

/** @brief Returns at most `most` points of a cloud, evenly distributed over its file,
 * with labels and rooms if present. `most` 0: all. Reads the cloud piece by piece;
 * memory is that of the result. */
DisplayCloud displayCloudOf(const RowSource& scan, std::size_t most);

/** @brief Returns one point per voxel, of edge `voxel_size` metres or more if there
 * were more than `most` points. Without labels and rooms. */
DisplayCloud thinnedCloudOf(const RowSource& scan, double voxel_size, std::size_t most);

/** @brief What a view leaves out: ceilings, other storeys. Decided by labels and rooms
 * where a part has them, by the plan where it has none, as points of a scan. */
class PlanRules {
public:
  PlanRules() = default;

  /** @param plan may have no rooms: then unlabelled parts belong to no ceiling and to
   * every storey */
  explicit PlanRules(const Floorplan& plan);

  /** @brief Returns whether a place belongs to a ceiling or what is above it. Details
   * in the upper half of their room do; unlabelled places do from 15 cm below the
   * ceiling up to the floor of the next storey.
   * @param room of the place; 0: unknown */
  bool isCeiling(StructureLabel label,
                 std::uint32_t room,
                 const Eigen::Vector3d& place) const;

  /** @brief Returns whether a place belongs to a storey: by its room or, if that is not
   * known, by its height with 15 cm more at both ends. Always true for storey 0. */
  bool isInStorey(std::uint32_t storey, std::uint32_t room, double z) const;

  /** @brief Returns whether a place belongs to a room: by its own room or, if that is
   * not known, by the box around the wanted one. Always true for wanted room 0. */
  bool isInRoom(std::uint32_t wanted,
                std::uint32_t room,
                const Eigen::Vector3d& place) const;

  /** @brief Returns the box around a room, floor to ceiling; empty for others. */
  Eigen::AlignedBox3d boxOf(std::uint32_t room) const;

  /** @brief Returns the storeys, from the lowest up. */
  const std::vector<PlanStorey>& storeys() const { return storeys_; }

private:
  /** @brief Lowest ceiling by cell, of a storey. */
  using Ceilings = std::unordered_map<CellKey, double>;

  void addRoom(const PlanRoom& room, Ceilings& ceilings);

  CellGrid grid_{0.1};
  std::vector<PlanStorey> storeys_;
  std::vector<Ceilings> ceilings_;                      ///< of each storey
  std::map<std::uint32_t, std::uint32_t> storey_of_;    ///< by room
  std::map<std::uint32_t, Eigen::AlignedBox3d> box_of_; ///< of rooms, floor to ceiling
};

} // namespace pcl::sedr::tools
