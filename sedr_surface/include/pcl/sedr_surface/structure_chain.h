// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floor_projection_recovery.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/grid_region_outlier_removal.h>
#include <pcl/sedr_filters/levelling.h>
#include <pcl/sedr_filters/structure_refinement.h>
#include <pcl/sedr_filters/vertical_hole_repair.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>
#include <pcl/sedr_segmentation/grid_slice_detail.h>
#include <pcl/sedr_segmentation/horizontal_plane_detection.h>
#include <pcl/sedr_segmentation/room_segmentation.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/room_jobs.h>
#include <pcl/sedr_surface/structural_poisson.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What a stage of the chain did. */
struct StageReport {
  std::string name;           ///< of the stage's class
  std::size_t points_in = 0;  ///< points it looked at
  std::size_t points_out = 0; ///< points it found or made
  double seconds = 0;
};

/** @brief The stages 2 to 11 on a thinned cloud, one after the other (paper,
 * section 2.1): each is PCL's kind of object, reached by its name and set as it is
 * alone. What flows through is one cloud with a label and a room a point; recovered
 * floor points are appended to it. */
class StructureChain {
public:
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  using StructureCloud = pcl::PointCloud<pcl::PointStructure>;

  StructureChain();

  pcl::HorizontalPlaneDetection<pcl::PointXYZ> plane_detection;
  pcl::GridRegionOutlierRemoval<pcl::PointXYZ> outlier_removal;
  RoomParameters
      room_segmentation; ///< of segmentRooms(), which has no class of its own
  pcl::GridSliceDetail<pcl::PointXYZ> slice_detail;
  pcl::FloorProjectionRecovery<pcl::PointXYZ> floor_recovery{
      true}; ///< tells what it removes
  pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ> wall_growing;
  pcl::FloorplanFitting<pcl::PointXYZ> floorplan_fitting;
  pcl::StructureRefinement<pcl::PointStructure> refinement;
  pcl::VerticalHoleRepair<pcl::PointStructure> hole_repair;
  pcl::FloorplanExtrusion<pcl::PointXYZ> extrusion;
  pcl::StructuralPoisson<pcl::PointStructure> poisson;

  /** @brief Called with a stage's name before it runs. */
  std::function<void(const std::string&)> on_stage;

  /** @brief Called with a stage's name and a room after every run of that stage's
   * object, while its getters still tell what that run decided. Outlier removal runs
   * once a ceiling plane; details, floors, walls, refinement and repair run once a
   * room; room 0 stands for all. */
  std::function<void(const std::string&, std::uint32_t)> on_result;

  /** @brief Who finds walls, refines, repairs and meshes the rooms, in this process or
   * elsewhere; null (default): the stages' objects here, one room after the other. The
   * result is the same, but on_result is not called for what is done elsewhere. A room
   * that is lost is left out and told by a warning. */
  std::shared_ptr<RoomWorkers> room_workers;

  /** @brief Whether a scan too sparse for its cells gets larger ones, see
   * cellSizeFor().
   */
  bool adapts_grid = true;

  /** @brief Voxels of fewer points were taken for strays when the scan was thinned, as
   * ParallelVoxelGrid::getStrayLimit() says; a warning tells it. */
  unsigned stray_limit = 0;

  /** @brief Whether the mesh is made of samples of the plan instead of the repaired
   * points: its edges round off less. */
  bool mesh_from_plan = false;

  /** @brief Whether a scan in which z seems not to be up, or that leans, is taken as it
   * is. */
  bool trust_up = false;

  /** @brief Whether what is made of a tilted scan stays in the level frame that it was
   * fitted in, see `levelling`. */
  bool keep_levelled = false;

  /** @brief The cells of all stages, metres. */
  void setGridSize(double size);

  /** @brief Finds the structure: all stages but the mesh.
   * @return false where a stage found nothing; failed_stage and problem say which and
   * why */
  bool findStructure(const Cloud::ConstPtr& thinned);

  /** @brief Makes the mesh of what findStructure() found. */
  bool makeMesh();

  /** @brief Forgets the last run, the cells it enlarged too, and takes `thinned` as the
   * cloud. */
  void reset(const Cloud::ConstPtr& thinned);

  // What the last run left.
  /** @brief How a scan tilted by 0.3 to 3 degrees was made level; none for others. All
   * that the chain holds is level. */
  std::optional<Levelling> levelling;
  Cloud::Ptr cloud; ///< thinned points, then those recovered of ceilings and floors
  std::vector<std::uint32_t> labels; ///< StructureLabel of each of them
  std::vector<std::uint32_t> rooms;  ///< room of each of them, 0 none
  std::vector<pcl::HorizontalPlane> planes;
  std::shared_ptr<Floorplan> plan;
  StructureCloud::Ptr structure; ///< refined and repaired
  std::vector<StageReport> reports;
  std::vector<std::string> warnings;
  std::string failed_stage;
  std::string problem;

  /** @brief The rooms as segmentRooms() parted them, on cells of its size: room r + 1
   * is the r-th. */
  const std::vector<RoomRegion>& getRoomRegions() const { return regions_; }

  /** @brief A mesh or solid that the chain holds, in the frame of the scan, unless
   * keep_levelled. */
  TriangleMesh inScanFrame(TriangleMesh mesh) const;

  /** @brief The mesh in that frame. */
  TriangleMesh meshInScanFrame() const;

  /** @brief The refined and repaired points in that frame. */
  StructureCloud::Ptr structureInScanFrame() const;

  /** @brief How many points of `cloud`, the first ones, are of the scan: the thinned
   * points less reflections. What was recovered comes after them. */
  std::size_t scannedPoints() const { return scanned_points_; }

  /** @brief Share of each room's points that hole repair added in the last run. */
  std::map<std::uint32_t, double> repairedShares() const { return repaired_shares_; }

  /** @brief How much of each room the scan did not support, at its own density, in the
   * last run: a warning tells where that is much. */
  const std::map<std::uint32_t, UnseenShares>& unseenShares() const { return unseen_; }

private:
  /** @brief Runs one stage, `step(report)`, and keeps its report. */
  template <typename Step>
  bool runStage(const std::string& name, std::size_t points_in, Step step);

  bool fail(const std::string& reason);

  void tellResult(const char* stage, std::uint32_t room = 0) const;

  /** @brief Notes that a stage could not do one room; the others go on. */
  void warn(std::uint32_t room, const std::string& reason);

  bool checkScan();

  /** @brief Makes the cloud, and the raw points of the fit, level if the scan is
   * tilted. */
  void levelScan();
  bool detectPlanes();

  /** @brief Takes points, increasing, out of the cloud before any has a label. */
  void removePoints(const pcl::Indices& indices);

  /** @brief The planes as levels, with cells of that size. */
  std::vector<Level> levelsOfPlanes(double cell_size) const;

  /** @brief Takes cupboards that hang before the edge of a ceiling out of the cloud and
   * puts points on the walls that they hide, before any has a label.
   * @return whether there were any: the planes must be found again */
  bool leaveOutHangingFurniture(const std::vector<Level>& levels);

  double cellSizeThatFills(const std::vector<Level>& levels) const;
  void enlargeCells(double size);

  /** @brief Gives outlier removal its minimum back, unless another was set since. */
  void restoreSupportedCells();
  bool findPlanes(StageReport& report);

  /** @brief Keeps the regions of a ceiling that floors or walls around support. */
  bool keepRegions(std::size_t ceiling,
                   const pcl::IndicesConstPtr& floors,
                   const pcl::Indices& all);

  /** @brief Keeps strips of a ceiling, of the points `seen`, beside what is kept of it.
   */
  void keepStrips(std::size_t ceiling,
                  const std::vector<int>& seen,
                  const pcl::Indices& floors);

  /** @brief Puts points where a sweep left gaps between its lines on a ceiling.
   * @param all indices of the cloud */
  void fillSweepGaps(const pcl::Indices& all);
  bool removeOutliers(StageReport& report);
  bool partRooms(StageReport& report);
  bool findDetails(StageReport& report);
  bool recoverFloors(StageReport& report);
  bool growWalls(StageReport& report);
  bool fitPlan(StageReport& report);
  bool refine(StageReport& report);
  bool repair(StageReport& report);

  /** @brief The labelled points of a room, as refinement takes them. */
  StructureCloud::Ptr labelledCloud(std::uint32_t room) const;

  /** @brief Labels the walls of a room where there is no label yet.
   * @return how many points */
  std::size_t labelWalls(std::uint32_t room, const pcl::Indices& walls);

  // The same stages by room_workers.
  void growWallsElsewhere(StageReport& report);
  bool refineElsewhere(StageReport& report); ///< hole repair too

  /** @brief The points that tell a room's walls, increasing. */
  pcl::Indices wallPoints(std::size_t region) const;

  WallJob wallJob(std::size_t region) const;
  RepairJob repairJob(const PlanRoom& room) const;

  /** @brief Takes the labels from all points of a room. */
  void giveUp(std::uint32_t room);

  /** @brief The same of every room that the plan does not have. */
  void giveUpRoomsWithoutPlan();

  void addStructure(std::uint32_t room, const RepairedRoom& repaired);

  void warnOfGuesses();
  bool extrude(StageReport& report);

  /** @brief Points of a label. */
  pcl::IndicesPtr labelled(StructureLabel label) const;

  /** @brief The same of one room, for which shareOut() has been called since points got
   * to or left rooms but for this one. */
  pcl::IndicesPtr labelled(StructureLabel label, std::uint32_t room) const;

  /** @brief Notes the points of every room. */
  void shareOut();

  /** @brief Labels the points of a level that are of rooms' ceilings.
   * @return how many */
  std::size_t labelCeilings(std::size_t level);

  /** @brief Puts points where something hides a room's ceiling from all stations.
   * @return how many */
  std::size_t addHiddenCeiling(std::size_t region);

  /** @brief The cells of each room. */
  std::vector<CellSet> scopes() const;

  /** @brief Points that lie in each room's territory. */
  std::vector<pcl::IndicesPtr> territories() const;

  /** @brief Points of ceilings that have no label. */
  pcl::Indices unlabelledCeilings() const;

  /** @brief Labels what is not yet labelled of the ceilings that room segmentation
   * joined to a room: soffits that the slices did not tell from the head of a window.
   * @param unlabelled points of ceilings without a label, some of which may have got
   * one since
   * @return how many points */
  std::size_t labelLowerCeilings(std::size_t region, const pcl::Indices& unlabelled);

  /** @brief Labels the points in the niches of rooms, which no earlier stage looks at.
   */
  void labelNiches();

  /** @brief The floor that each point belongs to; null for the others. */
  std::vector<const Level*> floorsOfPoints() const;

  /** @brief The points of a room's floor and of its platforms, increasing.
   * @param floor_of floorsOfPoints() */
  pcl::IndicesPtr floorPoints(std::size_t region,
                              const std::vector<const Level*>& floor_of) const;

  double enlarged_from_ = 0;        ///< the size of cells that was set; 0: it was kept
  std::size_t supported_cells_ = 0; ///< minimum of outlier removal at that size
  std::size_t scaled_cells_ = 0;    ///< the same at the size that is used
  std::vector<Level> levels_;
  std::vector<RoomRegion> regions_;
  std::vector<pcl::IndicesPtr> territory_; ///< of each room, thinned points
  std::vector<pcl::Indices> shares_;       ///< points of each room, from room 0 on
  std::vector<double> slice_height_;       ///< of each room, NaN without details
  std::vector<StructureCloud::Ptr>
      refined_; ///< of each room of the plan, till repaired
  std::map<std::uint32_t, double> repaired_shares_;
  std::map<std::uint32_t, UnseenShares> unseen_;
  std::size_t scanned_points_ = 0;
};

} // namespace sedr
} // namespace pcl
