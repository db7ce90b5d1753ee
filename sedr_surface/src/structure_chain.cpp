// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/structure_chain.h>

#include <pcl/sedr_segmentation/cell_fill.h>
#include <pcl/sedr_segmentation/room_territory.h>
#include <pcl/sedr_segmentation/scan_check.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iterator>
#include <limits>
#include <numeric>

namespace pcl {
namespace sedr {

namespace {

double
secondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
      .count();
}

std::uint32_t
valueOf(StructureLabel label)
{
  return static_cast<std::uint32_t>(label);
}

pcl::IndicesPtr
allIndices(std::size_t n)
{
  pcl::IndicesPtr indices(new pcl::Indices(n));
  std::iota(indices->begin(), indices->end(), 0);
  return indices;
}

const char*
kindName(LevelKind kind)
{
  return kind == LevelKind::Ceiling ? "ceiling"
         : kind == LevelKind::Floor ? "floor"
                                    : "other";
}

/** @brief The planes in words: "0.00 m floor 30.1 m2, 2.40 m ceiling 29.8 m2"; the
 * largest six. */
std::string
listOf(std::vector<pcl::HorizontalPlane> planes)
{
  std::stable_sort(planes.begin(), planes.end(),
                   [](const auto& a, const auto& b) { return a.area > b.area; });
  std::string list;
  for (std::size_t i = 0; i < planes.size() && i < 6; ++i) {
    char text[96];
    std::snprintf(text, sizeof text, "%s%.2f m %s %.1f m2", i == 0 ? "" : ", ",
                  planes[i].height, kindName(planes[i].kind), planes[i].area);
    list += text;
  }
  return list;
}

} // namespace

StructureChain::StructureChain()
{
  reset(Cloud::ConstPtr(new Cloud));
  // A wall point may lie two cells and a voxel away from the outermost ceiling point.
  wall_growing.setDistanceThreshold(0.15);
  // Of a round room, facets of 0.5 mm would be all that is between the solid and truth.
  extrusion.setChordTolerance(0.00025);
}

void
StructureChain::setGridSize(double size)
{
  plane_detection.setGridSize(size);
  outlier_removal.setGridSize(size);
  room_segmentation.cell_size = size;
  slice_detail.setGridSize(size);
  floor_recovery.setGridSize(size);
  floorplan_fitting.setGridSize(size);
  hole_repair.setGridSize(size);
  enlarged_from_ = 0;
}

/** @brief Larger cells for what looks at the scan; repaired points stay as dense. */
void
StructureChain::enlargeCells(double size)
{
  const double least = plane_detection.getGridSize();
  setGridSize(size);
  hole_repair.setGridSize(least);
  wall_growing.setDistanceThreshold(wall_growing.getDistanceThreshold() +
                                    2 * (size - least));
  enlarged_from_ = least;
}

void
StructureChain::reset(const Cloud::ConstPtr& thinned)
{
  if (enlarged_from_ > 0)
    enlargeCells(enlarged_from_);
  enlarged_from_ = 0;
  cloud.reset(new Cloud(*thinned));
  labels.assign(cloud->size(), 0);
  rooms.assign(cloud->size(), 0);
  planes.clear();
  plan = std::make_shared<Floorplan>();
  structure.reset(new StructureCloud);
  refined_.reset(new StructureCloud);
  reports.clear();
  warnings.clear();
  failed_stage.clear();
  problem.clear();
  levels_.clear();
  regions_.clear();
  territory_.clear();
  slice_height_.clear();
}

template <typename Step>
bool
StructureChain::runStage(const std::string& name, std::size_t points_in, Step step)
{
  if (on_stage)
    on_stage(name);
  StageReport report{name, points_in, 0, 0};
  failed_stage = name;
  const auto start = std::chrono::steady_clock::now();
  const bool is_done = step(report);
  report.seconds = secondsSince(start);
  reports.push_back(report);
  if (is_done)
    failed_stage.clear();
  return is_done;
}

bool
StructureChain::fail(const std::string& reason)
{
  problem = reason;
  return false;
}

void
StructureChain::tellResult(const char* stage, std::uint32_t room) const
{
  if (on_result)
    on_result(stage, room);
}

void
StructureChain::warn(std::uint32_t room, const std::string& reason)
{
  warnings.push_back("room " + std::to_string(room) + ": " + reason);
}

bool
StructureChain::findStructure(const Cloud::ConstPtr& thinned)
{
  if (!thinned)
    return fail("no cloud was given");
  reset(thinned);
  const std::size_t n = cloud->size();
  return checkScan() &&
         runStage("HorizontalPlaneDetection", n,
                  [&](auto& r) { return findPlanes(r); }) &&
         runStage("GridRegionOutlierRemoval", n,
                  [&](auto& r) { return removeOutliers(r); }) &&
         runStage("RoomSegmentation", n, [&](auto& r) { return partRooms(r); }) &&
         runStage("GridSliceDetail", n, [&](auto& r) { return findDetails(r); }) &&
         runStage("FloorProjectionRecovery", n,
                  [&](auto& r) { return recoverFloors(r); }) &&
         runStage("CeilingBoundaryWallGrowing", n,
                  [&](auto& r) { return growWalls(r); }) &&
         runStage("FloorplanFitting", cloud->size(),
                  [&](auto& r) { return fitPlan(r); }) &&
         runStage("StructureRefinement", cloud->size(),
                  [&](auto& r) { return refine(r); }) &&
         runStage("VerticalHoleRepair", refined_->size(),
                  [&](auto& r) { return repair(r); }) &&
         runStage("FloorplanExtrusion", structure->size(),
                  [&](auto& r) { return extrude(r); });
}

bool
StructureChain::makeMesh()
{
  return runStage("StructuralPoisson", structure->size(), [&](StageReport& report) {
    poisson.setInputCloud(structure);
    poisson.setFloorplan(mesh_from_plan ? plan : nullptr);
    pcl::PolygonMesh unused;
    poisson.reconstruct(unused);
    report.points_out = poisson.getMesh().vertices.size();
    if (poisson.getMesh().empty())
      return fail(poisson.getErrorMessage());
    tellResult("StructuralPoisson");
    if (!poisson.getErrorMessage().empty())
      warnings.push_back(poisson.getErrorMessage());
    return true;
  });
}

bool
StructureChain::checkScan()
{
  failed_stage = "input";
  const std::string reason =
      trust_up ? std::string()
               : upProblem(PointView(*cloud), *allIndices(cloud->size()));
  return reason.empty() || fail(reason);
}

bool
StructureChain::detectPlanes()
{
  plane_detection.setInputCloud(cloud);
  return plane_detection.segment(planes) || fail(plane_detection.getErrorMessage());
}

bool
StructureChain::findPlanes(StageReport& report)
{
  if (!detectPlanes())
    return false;
  if (adapts_grid) {
    const double size = plane_detection.getGridSize();
    std::vector<CellSet> ceilings;
    for (const auto& plane : planes)
      if (plane.kind == LevelKind::Ceiling)
        ceilings.emplace_back(CellGrid(size), PointView(*cloud), plane.inliers.indices);
    const double wanted = cellSizeFor(ceilings, size);
    if (wanted > size) {
      char text[160];
      std::snprintf(
          text, sizeof text,
          "the scan is too sparse for cells of %.2f m, its ceilings leave some "
          "empty: cells of %.2f m are used",
          size, wanted);
      warnings.push_back(text);
      enlargeCells(wanted);
      if (!detectPlanes())
        return false;
    }
  }
  tellResult("HorizontalPlaneDetection");
  std::size_t ceilings = 0;
  std::size_t floors = 0;
  for (const auto& plane : planes) {
    ceilings += plane.kind == LevelKind::Ceiling ? 1 : 0;
    floors += plane.kind == LevelKind::Floor ? 1 : 0;
    if (plane.kind != LevelKind::Other)
      report.points_out += plane.inliers.indices.size();
  }
  if (ceilings > 0 && floors > 0)
    return true;
  char text[160];
  std::snprintf(text, sizeof text,
                "of %zu horizontal planes %zu are ceilings and %zu floors; a ceiling "
                "needs a floor "
                "at least %.2f m below it; found: ",
                planes.size(), ceilings, floors,
                plane_detection.getMinimumRoomHeight());
  const std::string turned =
      upProblem(PointView(*cloud), *allIndices(cloud->size()), false);
  return fail(text + listOf(planes) + (turned.empty() ? "" : "; " + turned));
}

bool
StructureChain::removeOutliers(StageReport& report)
{
  pcl::IndicesPtr floors(new pcl::Indices);
  for (const auto& plane : planes)
    if (plane.kind == LevelKind::Floor)
      floors->insert(floors->end(), plane.inliers.indices.begin(),
                     plane.inliers.indices.end());
  outlier_removal.setInputCloud(cloud);
  outlier_removal.setSupportIndices(floors);
  const CellGrid grid(outlier_removal.getGridSize());
  const PointView points(*cloud);
  for (const auto& plane : planes) {
    Level level;
    level.slab = plane.slab;
    level.height = plane.height;
    level.kind = plane.kind;
    level.inliers = plane.inliers.indices;
    if (level.kind == LevelKind::Ceiling) {
      outlier_removal.setIndices(pcl::IndicesConstPtr(new pcl::Indices(level.inliers)));
      outlier_removal.filter(level.inliers);
      if (!outlier_removal.getErrorMessage().empty())
        return fail(outlier_removal.getErrorMessage());
      tellResult("GridRegionOutlierRemoval");
    }
    if (level.kind != LevelKind::Other) {
      level.cells = CellSet(grid, points, level.inliers);
      report.points_out += level.inliers.size();
    }
    levels_.push_back(std::move(level));
  }
  return true;
}

bool
StructureChain::partRooms(StageReport& report)
{
  const RoomParameters& parameters = room_segmentation;
  const PointView points(*cloud);
  std::string reason;
  regions_ =
      segmentRooms(points, *allIndices(cloud->size()), levels_, parameters, reason);
  if (!reason.empty())
    return fail(reason);
  if (regions_.empty()) {
    char text[240];
    std::snprintf(
        text, sizeof text,
        "no room of at least %.1f square metres with a floor below %.0f %% of its "
        "ceiling and walls around it, along %.0f %% more of its outline than is open; "
        "planes: ",
        parameters.minimum_area, 100 * parameters.minimum_floor_share,
        100 * parameters.minimum_enclosure);
    return fail(text + listOf(planes));
  }
  const CellGrid grid(parameters.cell_size);
  for (std::size_t r = 0; r < regions_.size(); ++r)
    for (const int i : levels_[regions_[r].ceiling_level].inliers) {
      const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
      if (!regions_[r].ceiling.contains(grid.at(p.x(), p.y())))
        continue;
      labels[static_cast<std::size_t>(i)] = valueOf(StructureLabel::Ceiling);
      rooms[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(r + 1);
      ++report.points_out;
    }
  for (std::size_t r = 0; r < regions_.size(); ++r)
    report.points_out += addHiddenCeiling(r);
  territory_ = territories();
  tellResult("RoomSegmentation");
  return true;
}

std::size_t
StructureChain::addHiddenCeiling(std::size_t region)
{
  const CellGrid grid(room_segmentation.cell_size);
  const CellSet& hidden = regions_[region].hidden;
  const PlanSlab& slab = levels_[regions_[region].ceiling_level].slab;
  for (std::size_t i = 0; i < hidden.size(); ++i) {
    const Eigen::Vector2d place = grid.centre(hidden[i]);
    cloud->push_back({static_cast<float>(place.x()), static_cast<float>(place.y()),
                      static_cast<float>(slab.heightAt(place))});
    labels.push_back(valueOf(StructureLabel::Ceiling));
    rooms.push_back(static_cast<std::uint32_t>(region + 1));
  }
  return hidden.size();
}

std::vector<pcl::IndicesPtr>
StructureChain::territories() const
{
  std::vector<CellSet> scopes;
  for (const auto& region : regions_)
    scopes.push_back(region.scope);
  const RoomTerritory territory(CellGrid(outlier_removal.getGridSize()), scopes);
  std::vector<pcl::IndicesPtr> result;
  for (std::size_t r = 0; r < regions_.size(); ++r)
    result.emplace_back(new pcl::Indices);
  const PointView points(*cloud);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::int32_t room = territory.roomAt(points[i]);
    if (room >= 0)
      result[static_cast<std::size_t>(room)]->push_back(static_cast<int>(i));
  }
  return result;
}

pcl::IndicesPtr
StructureChain::labelled(StructureLabel label, std::uint32_t room) const
{
  pcl::IndicesPtr indices(new pcl::Indices);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == valueOf(label) && (room == 0 || rooms[i] == room))
      indices->push_back(static_cast<int>(i));
  return indices;
}

bool
StructureChain::findDetails(StageReport& report)
{
  slice_detail.setInputCloud(cloud);
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const auto room = static_cast<std::uint32_t>(r + 1);
    const Eigen::Vector2d middle =
        CellGrid(outlier_removal.getGridSize())
            .centre(regions_[r].scope[regions_[r].scope.size() / 2]);
    slice_detail.setIndices(territory_[r]);
    slice_detail.setCeilingIndices(labelled(StructureLabel::Ceiling, room));
    slice_detail.setFloorHeight(levels_[regions_[r].floor_level].slab.heightAt(middle));
    pcl::PointIndices details;
    if (!slice_detail.segment(details))
      warn(room, slice_detail.getErrorMessage());
    tellResult("GridSliceDetail", room);
    slice_height_.push_back(slice_detail.getSliceHeight());
    for (const int i : details.indices) {
      labels[static_cast<std::size_t>(i)] = valueOf(StructureLabel::Detail);
      rooms[static_cast<std::size_t>(i)] = room;
    }
    report.points_out += details.indices.size() + labelLowerCeilings(r);
  }
  return true;
}

std::size_t
StructureChain::labelLowerCeilings(std::size_t region)
{
  const CellGrid grid(outlier_removal.getGridSize());
  const PointView points(*cloud);
  std::size_t found = 0;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Level& level : levels_) {
    if (level.kind != LevelKind::Ceiling)
      continue;
    for (const int i : level.inliers) {
      const auto at = static_cast<std::size_t>(i);
      if (labels[at] != 0 ||
          !regions_[region].scope.contains(grid.at(points[at].x(), points[at].y())))
        continue;
      labels[at] = valueOf(StructureLabel::Detail);
      rooms[at] = static_cast<std::uint32_t>(region + 1);
      ++found;
      lowest = std::min<double>(lowest, points[at].z());
    }
  }
  // Walls below a soffit grow from the floor's boundary, as below any detail.
  double& slice = slice_height_[region];
  if (found > 0 && !(slice < lowest))
    slice = lowest - grid.size();
  return found;
}

pcl::IndicesPtr
StructureChain::floorPoints(std::size_t region) const
{
  const double main = levels_[regions_[region].floor_level].height;
  const double ceiling = levels_[regions_[region].ceiling_level].height;
  pcl::IndicesPtr seen(new pcl::Indices);
  for (const Level& level : levels_)
    if (level.kind == LevelKind::Floor && level.height > main - 1 &&
        level.height < ceiling - plane_detection.getMinimumRoomHeight())
      std::set_intersection(level.inliers.begin(), level.inliers.end(),
                            territory_[region]->begin(), territory_[region]->end(),
                            std::back_inserter(*seen));
  std::sort(seen->begin(), seen->end());
  return seen;
}

bool
StructureChain::recoverFloors(StageReport& report)
{
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const auto room = static_cast<std::uint32_t>(r + 1);
    const Level& floor = levels_[regions_[r].floor_level];
    const pcl::IndicesPtr seen = floorPoints(r);
    pcl::ModelCoefficients::Ptr plane(new pcl::ModelCoefficients);
    for (int k = 0; k < 4; ++k)
      plane->values.push_back(static_cast<float>(floor.slab.plane[k]));
    floor_recovery.setInputCloud(cloud);
    floor_recovery.setIndices(seen);
    floor_recovery.setCeilingIndices(labelled(StructureLabel::Ceiling, room));
    floor_recovery.setDetailIndices(labelled(StructureLabel::Detail, room));
    floor_recovery.setFloorCoefficients(plane);
    Cloud whole;
    floor_recovery.filter(whole);
    if (!floor_recovery.getErrorMessage().empty()) {
      warn(room, floor_recovery.getErrorMessage());
      continue;
    }
    tellResult("FloorProjectionRecovery", room);
    const std::size_t kept = whole.size() - floor_recovery.getNumberOfProjected();
    for (std::size_t k = 0; k < whole.size(); ++k) {
      std::size_t at = cloud->size();
      if (k < kept)
        at = static_cast<std::size_t>(floor_recovery.getProjectedIndices()[k]);
      else {
        cloud->push_back(whole[k]);
        labels.push_back(0);
        rooms.push_back(0);
      }
      labels[at] = valueOf(StructureLabel::Floor);
      rooms[at] = room;
    }
    report.points_out += whole.size();
  }
  return true;
}

bool
StructureChain::growWalls(StageReport& report)
{
  wall_growing.setInputCloud(cloud);
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const auto room = static_cast<std::uint32_t>(r + 1);
    wall_growing.setIndices(territory_[r]);
    wall_growing.setCeilingIndices(labelled(StructureLabel::Ceiling, room));
    wall_growing.setFloorIndices(labelled(StructureLabel::Floor, room));
    wall_growing.setDetailIndices(labelled(StructureLabel::Detail, room));
    wall_growing.setSliceHeight(slice_height_[r]);
    pcl::PointIndices walls;
    if (!wall_growing.segment(walls)) {
      warn(room, wall_growing.getErrorMessage());
      continue;
    }
    tellResult("CeilingBoundaryWallGrowing", room);
    for (const int i : wall_growing.getWallIndices()) {
      const auto at = static_cast<std::size_t>(i);
      if (labels[at] != 0)
        continue;
      labels[at] = valueOf(StructureLabel::Wall);
      rooms[at] = room;
      ++report.points_out;
    }
  }
  return report.points_out > 0 ||
         fail("no point lies within " +
              std::to_string(wall_growing.getDistanceThreshold()) +
              " m in plan of the boundary of the ceilings");
}

bool
StructureChain::fitPlan(StageReport& report)
{
  floorplan_fitting.setInputCloud(cloud);
  floorplan_fitting.setCeilingIndices(labelled(StructureLabel::Ceiling, 0));
  floorplan_fitting.setFloorIndices(labelled(StructureLabel::Floor, 0));
  floorplan_fitting.setDetailIndices(labelled(StructureLabel::Detail, 0));
  floorplan_fitting.setWallIndices(labelled(StructureLabel::Wall, 0));
  floorplan_fitting.setRooms(rooms);
  if (!floorplan_fitting.segment(*plan))
    return fail(floorplan_fitting.getErrorMessage());
  tellResult("FloorplanFitting");
  warnings.insert(warnings.end(), floorplan_fitting.getWarnings().begin(),
                  floorplan_fitting.getWarnings().end());
  for (const auto& room : plan->rooms) {
    for (const auto& element : room.boundary.elements)
      report.points_out += element.inliers;
    labelNiches(room);
  }
  return true;
}

void
StructureChain::labelNiches(const PlanRoom& room)
{
  const double reach = refinement.getMaximumDistance();
  const std::vector<UprightSurface> uprights = uprightSurfaces(room);
  for (const int i : *territory_[room.id - 1]) {
    const auto at = static_cast<std::size_t>(i);
    const Eigen::Vector3d p = (*cloud)[at].getVector3fMap().cast<double>();
    const bool is_outside = !room.boundary.contains(p.head<2>());
    SurfacePoint snapped;
    if (is_outside && room.nicheAt(p.head<2>()) >= 0 &&
        snapToRoom(room, uprights, p, StructureLabel::Detail, reach, snapped)) {
      labels[at] = valueOf(StructureLabel::Detail);
      rooms[at] = room.id;
    }
  }
}

bool
StructureChain::refine(StageReport& report)
{
  StructureCloud::Ptr labelled_cloud(new StructureCloud);
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    if (labels[i] == 0)
      continue;
    pcl::PointStructure p;
    p.getVector3fMap() = (*cloud)[i].getVector3fMap();
    p.label = labels[i];
    p.room = rooms[i];
    labelled_cloud->push_back(p);
  }
  refinement.setInputCloud(labelled_cloud);
  refinement.setFloorplan(plan);
  refinement.filter(*refined_);
  tellResult("StructureRefinement");
  report.points_out = refined_->size();
  return !refined_->empty() || fail(refinement.getErrorMessage().empty()
                                        ? "no labelled point lies on the floor plan"
                                        : refinement.getErrorMessage());
}

bool
StructureChain::repair(StageReport& report)
{
  hole_repair.setInputCloud(refined_);
  hole_repair.setFloorplan(plan);
  hole_repair.filter(*structure);
  tellResult("VerticalHoleRepair");
  report.points_out = structure->size();
  return !structure->empty() || fail(hole_repair.getErrorMessage());
}

bool
StructureChain::extrude(StageReport& report)
{
  extrusion.setFloorplan(plan);
  pcl::PolygonMesh unused;
  extrusion.reconstruct(unused);
  tellResult("FloorplanExtrusion");
  report.points_out = extrusion.getMesh().vertices.size();
  warnings.insert(warnings.end(), extrusion.getWarnings().begin(),
                  extrusion.getWarnings().end());
  // The mesh may do without: a room that has no solid is told, and the others go on.
  if (!extrusion.getErrorMessage().empty())
    warnings.push_back(extrusion.getErrorMessage());
  return true;
}

} // namespace sedr
} // namespace pcl
