// SPDX-License-Identifier: BSD-3-Clause
#include "chain_stages.h"

#include "sedr_filters/src/rays/sight_lines.h"
#include "sedr_segmentation/src/scan/scan_check.h"
#include "seen_surfaces.h"

#include <pcl/sedr_filters/impl/refinement.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <cmath>
#include <map>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace pcl::sedr {

void
setCells(ChainStages& stages, double size)
{
  stages.room_segmentation.setGridSize(size);
  stages.floorplan_fitting.setGridSize(size);
  stages.hole_repair.setGridSize(size);
}

void
enlargeCells(ChainStages& stages, double size)
{
  const double before = stages.room_segmentation.getGridSize();
  const double repaired = stages.hole_repair.getGridSize();
  setCells(stages, size);
  stages.hole_repair.setGridSize(repaired);
  stages.wall_growing.setDistanceThreshold(stages.wall_growing.getDistanceThreshold() +
                                           2 * (size - before));
}

namespace {

void
append(const std::vector<PlanWarning>& found, std::vector<PlanWarning>& warnings)
{
  warnings.insert(warnings.end(), found.begin(), found.end());
}

std::shared_ptr<const Floorplan>
planOf(const PlanRoom& room)
{
  return std::make_shared<const Floorplan>(Floorplan{{room}});
}

/** @brief Returns freed memory to the system. Each thread keeps its own, and other
 * threads run the next stage. */
void
giveFreedMemoryBack()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

} // namespace

std::string
ChainRun::partRooms(StageReport& report)
{
  stages.room_segmentation.setInputCloud(model.cloud);
  stages.room_segmentation.setSeenThroughPanes(model.mirrored.behind);
  std::vector<pcl::PointIndices> unused;
  if (!stages.room_segmentation.segment(unused))
    return stages.room_segmentation.getErrorMessage() +
           (may_be_in_feet ? std::string("; ") + if_in_feet : "");
  const Building& building = stages.room_segmentation.getBuilding();
  if (!inchProblem(PointView(*model.cloud), building.storeys.size()).empty())
    return "the storeys that were found are too high for a building";
  for (const LeftOut& thing : building.left_out)
    if (thing.kind == LeftOutKind::Mirror || thing.kind == LeftOutKind::Partial)
      model.warnings.push_back(
          {WarningKind::LeftOut, {thing.area}, 0, 0, thing.reason, thing.at});
  for (const BuildingRoom& room : building.rooms)
    if (room.enclosure < stages.floorplan_fitting.getPriors().share_clear)
      model.warnings.push_back({WarningKind::Open, {room.unseen_outline}, room.id});
  rooms = roomsOf(building);
  std::transform(building.owner_of.begin(), building.owner_of.end(),
                 model.owners.begin(),
                 [](const PointOwner& owner) { return owner.beyond ? 0 : owner.room; });
  for (const ChainRoom& room : rooms)
    report.points_out += room.ceiling.size() + room.floor.size();
  return {};
}

std::string
ChainRun::findPlanes(StageReport& report)
{
  const Priors& priors = stages.floorplan_fitting.getPriors();
  if (!(plane_tolerance > 0 && 2 * plane_tolerance < priors.min_headroom))
    return "the distance threshold must be above 0 and below half the headroom, it "
           "is " +
           std::to_string(plane_tolerance) + " m";
  const PointView points(*model.cloud);
  const double size = stages.room_segmentation.getGridSize();
  std::vector<CellSet> ceilings;
  for (const ChainRoom& room : rooms)
    ceilings.emplace_back(CellGrid(size), points, room.ceiling);
  if (const double wanted = cellSizeFor(ceilings, size, priors); wanted > size) {
    enlargeCells(stages, wanted);
    model.warnings.push_back({WarningKind::Sparse, {size, wanted}});
  }
  const ScannedBuilding scan{points,
                             stages.room_segmentation.getBuilding(),
                             CellGrid(stages.room_segmentation.getGridSize()),
                             priors,
                             {plane_tolerance, radians(priors.max_slab_tilt),
                              stages.floorplan_fitting.getSeed(),
                              stages.room_segmentation.getNumberOfThreads()}};
  findCeilings(scan, rooms);
  findFloors(scan, rooms);
  labelSlabs(rooms, scan.grid, model);
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    report.points_out += rooms[r].ceiling.size() + rooms[r].floor.size();
    if (rooms[r].scope.empty())
      model.warnings.push_back(warningOf(
          WarningKind::Stage, "no point of its ceiling was found: it is left out", {},
          static_cast<std::uint32_t>(r + 1)));
  }
  return {};
}

std::string
ChainRun::findWalls(StageReport& report)
{
  const CellGrid grid(stages.room_segmentation.getGridSize());
  const std::string problem = growWalls(rooms, grid, stages.wall_growing, model);
  report.points_out = labelled(model, StructureLabel::Wall)->size();
  return problem;
}

std::string
ChainRun::fitPlan(StageReport& report)
{
  auto& fitting = stages.floorplan_fitting;
  fitting.setInputCloud(model.cloud);
  fitting.setCeilingIndices(labelled(model, StructureLabel::Ceiling));
  fitting.setFloorIndices(labelled(model, StructureLabel::Floor));
  fitting.setWallIndices(labelled(model, StructureLabel::Wall));
  fitting.setRooms(model.rooms);
  std::map<std::uint32_t, HiddenCells> hidden;
  for (std::size_t r = 0; r < rooms.size(); ++r)
    hidden[static_cast<std::uint32_t>(r + 1)] = rooms[r].hidden;
  fitting.setHiddenCells(std::move(hidden));
  fitting.setOwners(stages.room_segmentation.getBuilding().owner_of);
  if (!fitting.segment(*model.plan))
    return fitting.getErrorMessage();
  append(fitting.getWarnings(), model.warnings);
  giveStoreys(stages.room_segmentation.getBuilding(), *model.plan);
  for (const PlanRoom& room : model.plan->rooms)
    for (const PlanElement& element : room.boundary.elements)
      report.points_out += element.inliers;
  labelByPlan(rooms, stages.refinement.getMaximumDistance(), model);
  return {};
}

std::string
ChainRun::findOpenings(StageReport& report)
{
  const PointView raw = stages.floorplan_fitting.getRawPoints();
  const bool has_raw = raw.size() > 0;
  const PointView thinned(*model.cloud);
  report.points_in = (has_raw ? raw : thinned).size();
  stages.opening_detection.setSightLines(model.mirrored.lines);
  if (!stages.opening_detection.segment(
          has_raw ? raw : thinned,
          has_raw ? stages.floorplan_fitting.getRawIndices() : nullptr, *model.plan))
    return stages.opening_detection.getErrorMessage();
  numberOpenings(*model.plan);
  labelNiches(stages.room_segmentation.getBuilding().owner_of,
              stages.refinement.getMaximumDistance(), model);
  const Building& building = stages.room_segmentation.getBuilding();
  append(doubtsOfRooms(building, *model.plan), model.warnings);
  append(linksWithoutOpening(building, *model.plan), model.warnings);
  append(unexplainedSurfaces(thinned, building, *model.plan,
                             *stages.opening_detection.getSearch(),
                             stages.floorplan_fitting.getPriors()),
         model.warnings);
  report.points_out = model.plan->openings.size();
  return {};
}

namespace {

/** @brief Returns points with their labels and rooms. */
StructureModel::StructureCloud::Ptr
labelledCloud(const StructureModel& model, const pcl::Indices& points)
{
  StructureModel::StructureCloud::Ptr cloud(new StructureModel::StructureCloud);
  cloud->reserve(points.size());
  for (const int i : points) {
    const auto at = static_cast<std::size_t>(i);
    pcl::PointStructure p;
    p.getVector3fMap() = (*model.cloud)[at].getVector3fMap();
    p.label = model.labels[at];
    p.room = model.rooms[at];
    cloud->push_back(p);
  }
  return cloud;
}

} // namespace

std::string
ChainRun::refine(StageReport& report)
{
  const std::vector<pcl::Indices> points =
      pointsByRoom(model, stages.room_segmentation.getBuilding().rooms.size());
  std::string problem = "no labelled point lies on the floor plan";
  for (const PlanRoom& room : model.plan->rooms) {
    const pcl::Indices& of_room = points[room.id];
    refined.emplace_back(new StructureModel::StructureCloud);
    stages.refinement.setInputCloud(labelledCloud(model, of_room));
    stages.refinement.setFloorplan(planOf(room));
    stages.refinement.filter(*refined.back());
    const pcl::Indices& sources = stages.refinement.getSourceIndices();
    // A point labelled ceiling that was moved to a soffit is a detail from here on.
    for (std::size_t k = 0; k < sources.size(); ++k)
      assign(model, of_room[static_cast<std::size_t>(sources[k])],
             static_cast<StructureLabel>((*refined.back())[k].label), room.id);
    if (!stages.refinement.getErrorMessage().empty()) // a room without points is empty
      problem = stages.refinement.getErrorMessage();
    report.points_out += refined.back()->size();
  }
  stages.refinement.setFloorplan(model.plan);
  return report.points_out > 0 ? std::string() : problem;
}

std::string
ChainRun::repair(StageReport& report)
{
  const double size = stages.hole_repair.getGridSize();
  if (const std::string excess =
          size > 0 ? surfaceCellsProblem(*model.plan, size) : std::string();
      !excess.empty())
    return excess;
  for (std::size_t r = 0; r < refined.size(); ++r) {
    if (refined[r]->empty())
      continue;
    StructureModel::StructureCloud whole;
    stages.hole_repair.setInputCloud(refined[r]);
    stages.hole_repair.setFloorplan(planOf(model.plan->rooms[r]));
    refined[r].reset(); // points kept twice would be most of the memory
    stages.hole_repair.filter(whole);
    if (!stages.hole_repair.getErrorMessage().empty())
      return stages.hole_repair.getErrorMessage();
    *model.structure += whole;
  }
  stages.hole_repair.setFloorplan(model.plan);
  report.points_out = model.structure->size();
  warnOfGuesses(model);
  return {};
}

std::string
ChainRun::extrude(StageReport& report)
{
  stages.extrusion.setFloorplan(model.plan);
  pcl::PolygonMesh unused;
  stages.extrusion.reconstruct(unused);
  report.points_out = stages.extrusion.getMesh().vertices.size();
  append(stages.extrusion.getWarnings(), model.warnings);
  // The mesh does not need the solids: rooms without one are reported, the run
  // continues.
  for (const RoomSolidReport& solid : stages.extrusion.getReports())
    if (!solid.problem.empty())
      model.warnings.push_back(
          {WarningKind::NoSolid, {}, solid.room, 0, solid.problem});
  return {};
}

std::string
ChainRun::makeMesh(StageReport& report)
{
  stages.poisson.setInputCloud(model.structure);
  const bool is_made = stages.poisson.makeMesh();
  giveFreedMemoryBack();
  report.points_out = stages.poisson.getMesh().vertices.size();
  if (!is_made)
    return stages.poisson.getErrorMessage();
  for (const RoomPoissonReport& room : stages.poisson.getReports())
    for (const std::string* reason : {&room.problem, &room.warning})
      if (!reason->empty())
        model.warnings.push_back({WarningKind::Mesh, {}, room.room, 0, *reason});
  if (!stages.extrusion.getCutOpenings()) // the mesh has none
    warnOfVolumes(stages.extrusion.getReports(), stages.poisson.getReports(), model);
  return {};
}

} // namespace pcl::sedr
