// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/stage_error.h>
#include <pcl/sedr_segmentation/building.h>

#include <pcl/PointIndices.h>
#include <pcl/pcl_base.h>

#include <vector>

namespace pcl {

/** @brief Parts a thinned scan into rooms and storeys by its air (paper, section 2.3.1:
 * rooms are the connected regions of the ceiling; here of the envelope, whatever the
 * shape of the ceiling).
 *
 * Frame: z up, metres. Non-finite points are of no room. Needs no scanner positions and
 * no normals. O(n) for n points. See doc/room_segmentation.md.
 * @code
 * pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
 * segmentation.setInputCloud(thinned);
 * std::vector<pcl::PointIndices> rooms;      // points of ceilings and floors, by room
 * segmentation.segment(rooms);
 * for (const auto& room : segmentation.getBuilding().rooms)
 *   std::cout << room.id << ": storey " << room.storey << ", " << room.area << '\n';
 * @endcode */
template <typename PointT>
class RoomSegmentation : public PCLBase<PointT>, public sedr::StageError {
public:
  using Ptr = shared_ptr<RoomSegmentation<PointT>>;
  using ConstPtr = shared_ptr<const RoomSegmentation<PointT>>;

  /** @brief Edge of a grid cell, metres, > 0. Default 0.05. Air is looked for in
   * columns of twice that, or larger ones where the scan is too sparse to fill them. */
  void setGridSize(double size) { parameters_.cell_size = size; }
  double getGridSize() const { return parameters_.cell_size; }

  /** @brief Smallest room, square metres with headroom, > 0. Default 1. */
  void setMinimumArea(double area) { parameters_.minimum_area = area; }
  double getMinimumArea() const { return parameters_.minimum_area; }

  /** @brief Least height of a room, metres, > 0. Default 1.8. */
  void setHeadroom(double height) { parameters_.headroom = height; }
  double getHeadroom() const { return parameters_.headroom; }

  /** @brief Least share of a room's outline at which walls stand, 0 to 1. Default
   * 0.15; at least 0.6 of places below 5 square metres, and 0.5 of those that no door
   * leads to, is wanted whatever is set. */
  void setMinimumEnclosure(double share) { parameters_.minimum_enclosure = share; }
  double getMinimumEnclosure() const { return parameters_.minimum_enclosure; }

  /** @brief Widest opening between two rooms that a small lintel or jambs make a door,
   * metres. Default 1.6. */
  void setWidestDoor(double width) { parameters_.widest_door = width; }
  double getWidestDoor() const { return parameters_.widest_door; }

  /** @brief Widest opening between two rooms below a lintel, metres, not less than the
   * widest door. Default 4. */
  void setWidestPassage(double width) { parameters_.widest_passage = width; }
  double getWidestPassage() const { return parameters_.widest_passage; }

  /** @brief Floors that differ by less are of one storey, metres, > 0. Default 1.6. */
  void setStoreyStep(double step) { parameters_.storey_step = step; }
  double getStoreyStep() const { return parameters_.storey_step; }

  /** @brief Number of threads; 0 (default): all processors. */
  void setNumberOfThreads(unsigned threads) { parameters_.threads = threads; }
  unsigned getNumberOfThreads() const { return parameters_.threads; }

  /** @brief Rays of the scanners and, for each point of the input, 1 if it was seen
   * only through panes, see sedr::findMirroredPoints(). A hole in a slab that rays go
   * through stays open; what was seen only through panes is no room. Null and empty
   * (default): not known. */
  void setSight(const std::shared_ptr<const sedr::SightLines>& sight,
                const std::vector<std::uint8_t>& behind)
  {
    sight_ = sight;
    behind_ = behind;
  }

  /** @brief Finds the rooms.
   * @param[out] rooms the points of ceiling and floor of each, increasing; empty where
   * there is none
   * @return false, with a reason in getErrorMessage(), for bad input or parameters or
   * where there is no room */
  bool segment(std::vector<PointIndices>& rooms);

  /** @brief What the last run found: rooms, storeys, doorways, stairs, what was left
   * out, and the room of every point. */
  const sedr::Building& getBuilding() const { return building_; }

  /** @brief The points of all ceilings or of all floors of the last run, increasing:
   * what the next stage takes as its ceiling or floor. O(n).
   * @param room of one room, 0: of all rooms */
  pcl::Indices getPoints(sedr::StructureLabel label, std::uint32_t room = 0) const
  {
    pcl::Indices found;
    for (std::size_t i = 0; i < building_.label_of.size(); ++i)
      if (building_.label_of[i] == static_cast<std::uint32_t>(label) &&
          (building_.room_of[i] == room || (room == 0 && building_.room_of[i] != 0)))
        found.push_back(static_cast<index_t>(i));
    return found;
  }

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

  sedr::BuildingParameters parameters_;
  std::shared_ptr<const sedr::SightLines> sight_;
  std::vector<std::uint8_t> behind_;
  sedr::Building building_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_segmentation/impl/room_segmentation.hpp>
#endif
