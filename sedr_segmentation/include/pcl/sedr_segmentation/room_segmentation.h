// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/stage_error.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_segmentation/impl/find_building.h>

#include <pcl/PointIndices.h>
#include <pcl/pcl_base.h>

#include <vector>

namespace pcl {

/** @brief Divides a thinned scan into rooms and storeys by its free space. In the paper
 * (section 2.3.1) rooms are connected regions of the ceiling; here they are regions of
 * the envelope, for any shape of ceiling.
 *
 * Frame: z up, metres. Non-finite points belong to no room. Scanner positions and
 * normals are not required. O(n) for n points. See doc/room_segmentation.md.
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

  /** @brief Sets the edge of a grid cell, metres, > 0. Default 0.05. Gaps are found in
   * profiles of twice that edge, or larger if the scan is too sparse to fill them. */
  void setGridSize(double size) { parameters_.cell_size = size; }
  double getGridSize() const { return parameters_.cell_size; }

  /** @brief Sets the minimum area with headroom of a room, square metres. Default 1. */
  void setMinimumArea(double area) { parameters_.minimum_area = area; }
  double getMinimumArea() const { return parameters_.minimum_area; }

  /** @brief Sets the minimum height of a room, metres, > 0. Default 1.8. */
  void setHeadroom(double height) { parameters_.headroom = height; }
  double getHeadroom() const { return parameters_.headroom; }

  /** @brief Sets the minimum share of a room's outline with walls, 0 to 1. Default
   * 0.15. Rooms below 5 square metres always need 0.6, and rooms without a door 0.5. */
  void setMinimumEnclosure(double share) { parameters_.minimum_enclosure = share; }
  double getMinimumEnclosure() const { return parameters_.minimum_enclosure; }

  /** @brief Sets the minimum height difference between floors of two storeys, metres, >
   * 0. Default 1.6. */
  void setStoreyStep(double step) { parameters_.storey_step = step; }
  double getStoreyStep() const { return parameters_.storey_step; }

  /** @brief Sets whether the grid lies in the frame of the building, so that rooms do
   * not depend on how the scan lies, see sedr::findBuildingFrame(); all but the grid is
   * turned back. Only for points thinned in that frame, as others leave holes in its
   * cells. Default false. */
  void setInBuildingFrame(bool is_in_frame) { parameters_.own_frame = is_in_frame; }
  bool getInBuildingFrame() const { return parameters_.own_frame; }

  /** @brief Sets the priors, for the reach within which a room owns points. */
  void setPriors(const sedr::Priors& priors) { parameters_.priors = priors; }
  const sedr::Priors& getPriors() const { return parameters_.priors; }

  /** @brief Sets the number of threads; 0 (default): all processors. */
  void setNumberOfThreads(unsigned threads) { parameters_.threads = threads; }
  unsigned getNumberOfThreads() const { return parameters_.threads; }

  /** @brief Sets for each input point 1 if it was seen only through panes, see
   * sedr::findMirroredPoints(): space behind panes is no room. Empty (default): not
   * known. */
  void setSeenThroughPanes(const std::vector<std::uint8_t>& behind)
  {
    behind_ = behind;
  }

  /** @brief Finds the rooms.
   * @param[out] rooms the ceiling and floor points of each room, increasing; empty if
   * there are none
   * @return false, with a reason in getErrorMessage(), for bad input or parameters or
   * if there is no room */
  bool segment(std::vector<PointIndices>& rooms);

  /** @brief Returns the building of the last run: rooms, storeys, links, stairs,
   * regions left out, and the room of every point. */
  const sedr::Building& getBuilding() const { return building_; }

  /** @brief Returns the points of all ceilings or all floors of the last run,
   * increasing: the ceiling or floor input of the next stage. O(n).
   * @param room the room, 0: all rooms */
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
  std::vector<std::uint8_t> behind_;
  sedr::Building building_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_segmentation/impl/room_segmentation.hpp>
#endif
