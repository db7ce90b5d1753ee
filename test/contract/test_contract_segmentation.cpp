// SPDX-License-Identifier: BSD-3-Clause
#include "contract_suite.h"

#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>
#include <pcl/sedr_segmentation/grid_slice_detail.h>
#include <pcl/sedr_segmentation/horizontal_plane_detection.h>
#include <pcl/sedr_segmentation/room_segmentation.h>

namespace contract {

/** A stage that takes the ceiling and floor of the sample room, restricted to the
 * indices if set. */
template <typename StageT>
class SlabAdaptor : public Adaptor<StageT> {
public:
  static constexpr bool finds_in_one_point = false;

  void setInput(const Cloud::ConstPtr& cloud)
  {
    this->stage_.setInputCloud(cloud);
    setSlabs(*between(*cloud, -10.f, 10.f));
  }

  void setIndices(const pcl::IndicesPtr& indices)
  {
    this->stage_.setIndices(indices);
    setSlabs(*indices);
  }

private:
  void setSlabs(const pcl::Indices& indices)
  {
    const Cloud& cloud = *this->stage_.getInputCloud();
    this->stage_.setCeilingIndices(among(cloud, indices, 2.49f, 2.51f));
    this->stage_.setFloorIndices(among(cloud, indices, -0.01f, 0.01f));
  }
};

class WallGrowingAdaptor
    : public SlabAdaptor<pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ>> {
public:
  WallGrowingAdaptor()
  {
    parameter([this](double v) { stage_.setNumberOfNeighbors(static_cast<int>(v)); },
              200, {2});
    parameter([this](double v) { stage_.setAngleThreshold(static_cast<float>(v)); },
              M_PI / 3, {0, -1, 7, nan});
    parameter([this](double v) { stage_.setDistanceThreshold(v); }, 0.1, {0, -1, nan});
  }

  Outcome run()
  {
    pcl::PointIndices walls;
    walls.indices = {1, 2, 3};
    stage_.segment(walls);
    Outcome result = outcome(walls.indices.size(), "");
    for (const pcl::Indices* indices :
         {&std::as_const(walls.indices), &stage_.getBoundaryIndices(),
          &stage_.getScopeBoundaryIndices(), &stage_.getFloorBoundaryIndices()}) {
      append(result.all, *indices);
      append(result.geometry, pointsOf(*indices));
    }
    result.kept = walls.indices;
    return result;
  }
};

/** With slice height. */
class SlicedWallGrowingAdaptor : public WallGrowingAdaptor {
public:
  SlicedWallGrowingAdaptor() { stage_.setSliceHeight(1.25); }
};

/** The size is the number of inliers of all planes. */
class PlaneDetectionAdaptor
    : public Adaptor<pcl::HorizontalPlaneDetection<pcl::PointXYZ>> {
public:
  static constexpr bool finds_in_one_point = false;

  PlaneDetectionAdaptor()
  {
    parameter([this](double v) { stage_.setDistanceThreshold(v); }, 0.07, {0, nan});
    parameter([this](double v) { stage_.setGridSize(v); }, 0.05, {-0.05, inf});
    parameter([this](double v) { stage_.setMaximumTilt(v); }, 0.0524, {-0.1, 1.6});
    parameter([this](double v) { stage_.setMinimumArea(v); }, 1, {0, inf});
    parameter([this](double v) { stage_.setMinimumRoomHeight(v); }, 1.8, {0, nan});
  }

  Outcome run()
  {
    std::vector<pcl::HorizontalPlane> planes(3);
    stage_.segment(planes);
    std::size_t size = 0;
    std::string geometry;
    std::string indices;
    for (const auto& plane : planes) {
      size += plane.inliers.indices.size();
      geometry +=
          bytesOf(plane.coefficients.values, static_cast<int>(plane.kind), plane.cells,
                  plane.area, plane.residual, pointsOf(plane.inliers.indices));
      append(indices, plane.inliers.indices);
    }
    return outcome(size, geometry, indices);
  }
};

/** The size is the number of points of all ceilings and floors. */
class RoomSegmentationAdaptor : public Adaptor<pcl::RoomSegmentation<pcl::PointXYZ>> {
public:
  static constexpr bool finds_in_one_point = false;

  RoomSegmentationAdaptor()
  {
    parameter([this](double v) { stage_.setGridSize(v); }, 0.05, {0, nan});
    parameter([this](double v) { stage_.setMinimumArea(v); }, 1, {-1, inf});
    parameter([this](double v) { stage_.setHeadroom(v); }, 1.8, {0, nan});
    parameter([this](double v) { stage_.setMinimumEnclosure(v); }, 0.4, {-0.1, 1.01});
    parameter([this](double v) { stage_.setStoreyStep(v); }, 1.6, {0, -1.6});
  }

  Outcome run()
  {
    std::vector<pcl::PointIndices> rooms(3);
    stage_.segment(rooms);
    const pcl::sedr::Building& building = stage_.getBuilding();
    std::size_t size = 0;
    std::string geometry = bytesOf(building.storeys.size());
    std::string rest = bytesOf(building.room_of, building.label_of);
    for (const auto& room : rooms) {
      size += room.indices.size();
      append(rest, room.indices);
      append(geometry, pointsOf(room.indices));
    }
    for (const auto& room : building.rooms)
      geometry += bytesOf(room.floor, room.ceiling, room.area, room.enclosure, room.id,
                          room.storey, room.columns.size());
    return outcome(size, geometry, rest);
  }
};

/** Adds a soffit to the sample room point by point: the ceiling beyond y = 0.9 is
 * lowered by 0.4 m, and the wall above it becomes the riser. */
class SliceDetailAdaptor : public Adaptor<pcl::GridSliceDetail<pcl::PointXYZ>> {
public:
  static constexpr bool finds_in_one_point = false;
  static constexpr bool takes_one_room = true;

  SliceDetailAdaptor()
  {
    parameter([this](double v) { stage_.setGridSize(v); }, 0.05, {0, nan});
    parameter([this](double v) { stage_.setDistanceThreshold(v); }, 0.07, {-1, inf});
    parameter([this](double v) { stage_.setSliceThickness(v); }, 0.1, {0, -0.1});
    parameter([this](double v) { stage_.setTrials(static_cast<int>(v)); }, 3, {0, 4});
    stage_.setFloorHeight(0);
  }

  void setInput(const Cloud::ConstPtr& cloud)
  {
    const auto built = std::make_shared<Cloud>(*cloud);
    for (auto& p : *built)
      buildSoffit(p);
    stage_.setInputCloud(built);
    stage_.setCeilingIndices(between(*built, 2.45f, 2.55f));
  }

  void setIndices(const pcl::IndicesPtr& indices)
  {
    stage_.setIndices(indices);
    stage_.setCeilingIndices(among(*stage_.getInputCloud(), *indices, 2.45f, 2.55f));
  }

  Outcome run()
  {
    pcl::PointIndices details;
    details.indices = {1, 2, 3};
    stage_.segment(details);
    const bool is_found = !details.indices.empty();
    return outcome(details.indices.size(),
                   bytesOf(stage_.getRegionLabels(), stage_.getRegionSizes(),
                           stage_.getTrial(), is_found ? stage_.getSliceHeight() : 0,
                           pointsOf(details.indices)),
                   bytesOf(details.indices));
  }

private:
  static void buildSoffit(pcl::PointXYZ& p)
  {
    if (!(p.y > 0.9f) || !(p.z > 2.1f))
      return;
    if (p.y > 1.45f && p.z < 2.45f)
      p.y -= 0.6f;
    else
      p.z -= 0.4f;
  }
};

/** A room far away is room 2. The size is the number of elements of all loops. */
class FloorplanAdaptor : public SlabAdaptor<pcl::FloorplanFitting<pcl::PointXYZ>> {
public:
  FloorplanAdaptor()
  {
    parameter([this](double v) { stage_.setDistanceThreshold(v); }, 0.05, {0, nan});
    parameter([this](double v) { stage_.setGridSize(v); }, 0.05, {-0.05, inf});
    parameter([this](double v) { stage_.setRadiusLimits(v, 25); }, 0.15, {0, 26});
    parameter(
        [this](double v) {
          stage_.setRooms(v > 0 ? std::vector<std::uint32_t>{1, 2, 3} : rooms_);
        },
        0, {1});
  }

  void setInput(const Cloud::ConstPtr& cloud)
  {
    SlabAdaptor::setInput(cloud);
    rooms_.clear();
    for (const auto& p : *cloud)
      rooms_.push_back(p.x > 4096.f ? 2 : 1);
    mend();
  }

  Outcome run()
  {
    pcl::sedr::Floorplan plan;
    plan.rooms.resize(2);
    stage_.segment(plan);
    std::size_t size = 0;
    std::string geometry;
    for (const auto& room : plan.rooms) {
      append(geometry, room.id);
      for (const auto* slab : {&room.floor, &room.ceiling})
        geometry += bytesOf(slab->plane[0], slab->plane[1], slab->plane[2],
                            slab->plane[3], slab->inliers);
      size += room.boundary.elements.size();
      for (const auto& e : room.boundary.elements)
        geometry += bytesOf(e.start.x(), e.start.y(), e.radius, e.residual, e.inliers);
    }
    return outcome(size, geometry);
  }

private:
  std::vector<std::uint32_t> rooms_;
};

using SegmentationAdaptors = ::testing::Types<WallGrowingAdaptor,
                                              SlicedWallGrowingAdaptor,
                                              PlaneDetectionAdaptor,
                                              RoomSegmentationAdaptor,
                                              SliceDetailAdaptor,
                                              FloorplanAdaptor>;
INSTANTIATE_TYPED_TEST_SUITE_P(Segmentation, Contract, SegmentationAdaptors);

} // namespace contract
