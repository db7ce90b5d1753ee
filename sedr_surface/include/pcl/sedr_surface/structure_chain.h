// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floor_projection_recovery.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_filters/straightening.h>
#include <pcl/sedr_filters/structure_refinement.h>
#include <pcl/sedr_filters/vertical_hole_repair.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>
#include <pcl/sedr_segmentation/grid_slice_detail.h>
#include <pcl/sedr_segmentation/horizontal_plane_detection.h>
#include <pcl/sedr_segmentation/room_segmentation.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/structural_poisson.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl::sedr {

class RoomTerritory;
class RoomWorkers;
class SightLines;
struct RepairJob;
struct RepairedRoom;
struct WallJob;

/** @brief Report on a stage of the chain. */
struct StageReport {
  std::string name;           ///< of the stage's class
  std::size_t points_in = 0;  ///< number of input points
  std::size_t points_out = 0; ///< number of points found or made
  double seconds = 0;
};

/** @brief Results of using the scanner positions. */
struct MirrorFigures {
  std::size_t positions = 0; ///< known positions
  std::size_t untrue = 0;    ///< of these, positions that the scan contradicts
  std::size_t rays = 0;      ///< rays traced
  std::size_t mirrors = 0;   ///< surfaces that reflect rooms
  std::size_t points = 0;    ///< thinned points that were removed
  std::shared_ptr<const SightLines> lines; ///< rays that met no reflection
  std::vector<std::uint8_t> behind;        ///< 1: thinned point seen only through glass
};

/** @brief Runs the stages 2 to 11 on a thinned cloud (paper, section 2.1). Each stage
 * is a PCL-style object, a member of this class with its own setters. The stages share
 * one cloud with a label and a room per point; recovered floor points are appended to
 * it. */
class StructureChain {
public:
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  using StructureCloud = pcl::PointCloud<pcl::PointStructure>;

  StructureChain();

  pcl::RoomSegmentation<pcl::PointXYZ> room_segmentation;
  pcl::HorizontalPlaneDetection<pcl::PointXYZ> plane_detection;
  pcl::GridSliceDetail<pcl::PointXYZ> slice_detail;
  pcl::FloorProjectionRecovery<pcl::PointXYZ> floor_recovery{
      true}; ///< reports what it removes
  pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ> wall_growing;
  pcl::FloorplanFitting<pcl::PointXYZ> floorplan_fitting;
  pcl::StructureRefinement<pcl::PointStructure> refinement;
  pcl::VerticalHoleRepair<pcl::PointStructure> hole_repair;
  pcl::FloorplanExtrusion<pcl::PointXYZ> extrusion;
  pcl::StructuralPoisson<pcl::PointStructure> poisson;

  /** @brief Called with a stage's name before it runs. */
  std::function<void(const std::string&)> on_stage;

  /** @brief Called with a stage's name and a room after every run of that stage's
   * object, while its getters still hold the results. Planes, details, floors, walls,
   * refinement and repair run once per room; room 0 means all rooms. */
  std::function<void(const std::string&, std::uint32_t)> on_result;

  /** @brief Workers that find walls, refine, repair and mesh the rooms, in this process
   * or elsewhere. Null (default): the stages' objects here, room by room. The result is
   * the same, but on_result is not called for work done elsewhere. A lost room is left
   * out with a warning. */
  std::shared_ptr<RoomWorkers> room_workers;

  /** @brief Whether the cells grow if the scan is too sparse for them, see
   * cellSizeFor(). */
  bool adapts_grid = true;

  /** @brief Voxels with fewer points were removed as strays by thinning, see
   * ParallelVoxelGrid::getStrayLimit(). A warning reports it. */
  unsigned stray_limit = 0;

  /** @brief Result of leaveOutMirrored(), if called before the run. A warning reports
   * it. */
  MirrorFigures mirrored;

  /** @brief Removes reflections in glass and mirrors; to be called before
   * findStructure(). They are erased from `thinned` and set to NaN in `rows`, every
   * `step`-th point of the scan. */
  void leaveOutMirrored(const ScanPositions& positions,
                        std::size_t step,
                        Cloud& thinned,
                        std::vector<Eigen::Vector3f>& rows);

  /** @brief Whether the mesh is made from samples of the plan instead of the repaired
   * points, which keeps its edges sharper. */
  bool mesh_from_plan = false;

  /** @brief Whether a scan whose z axis seems not to be up, or which is tilted, is used
   * unchanged. */
  bool trust_up = false;

  /** @brief Whether the results of a tilted scan stay in the level frame, see
   * `levelling`. */
  bool keep_levelled = false;

  /** @brief Whether the unit is known to be the metre, so that no warning doubts it. */
  bool unit_is_known = false;

  /** @brief Origin of the scan's coordinates, for writers of the results. */
  Origin origin;

  /** @brief Sets the cell size of all stages, metres. */
  void setGridSize(double size);

  /** @brief Sets the priors on buildings, furniture and scanners, including headroom,
   * steps, tilts and door widths of the stages. */
  void setPriors(const Priors& priors);
  const Priors& getPriors() const { return priors_; }

  /** @brief Runs all stages but the mesh.
   * @return false if a stage found nothing; see failed_stage and problem */
  bool findStructure(const Cloud::ConstPtr& thinned);

  /** @brief Makes the mesh of the structure found by findStructure(). */
  bool makeMesh();

  /** @brief Discards the last run, including enlarged cells, and sets `thinned` as the
   * cloud. */
  void reset(const Cloud::ConstPtr& thinned);

  // Results of the last run.
  /** @brief The rotation that levelled a scan tilted by 0.3 to 3 degrees; empty
   * otherwise. All results of the chain are in the level frame. */
  std::optional<Levelling> levelling;
  /** @brief The map that made tilted walls vertical for all stages but the solid; the
   * identity without tilted walls. `cloud` and the mesh are in that frame; plan,
   * structure and solid are in the frame of the scan. */
  Straightening straightening;
  WallTilts tilts;  ///< tilted walls of `plan`
  Cloud::Ptr cloud; ///< thinned points, then recovered points of ceilings and floors
  std::vector<std::uint32_t> labels; ///< StructureLabel of each point
  std::vector<std::uint32_t> rooms;  ///< room of each point, 0 none
  std::vector<pcl::HorizontalPlane> planes;
  std::shared_ptr<Floorplan> plan;
  StructureCloud::Ptr structure; ///< refined and repaired
  std::vector<StageReport> reports;
  std::vector<std::string> warnings;
  std::string unit_doubt; ///< the one of `warnings` that doubts the unit, or empty
  std::string failed_stage;
  std::string problem;

  /** @brief Returns the building from room segmentation; room r + 1 is the r-th. */
  const Building& getBuilding() const { return room_segmentation.getBuilding(); }

  /** @brief Moves a solid of the chain to the frame of the scan, unless
   * keep_levelled. */
  TriangleMesh inScanFrame(TriangleMesh mesh) const;

  /** @brief Returns the mesh in the frame of the scan. */
  TriangleMesh meshInScanFrame() const;

  /** @brief Returns whether the frame of the mesh differs from that of the scan. */
  bool isMeshMoved() const
  {
    return !straightening.isIdentity() || (levelling && !keep_levelled);
  }

  /** @brief Returns the refined and repaired points in the frame of the scan. */
  StructureCloud::Ptr structureInScanFrame() const;

  /** @brief Returns how many points of `cloud` come from the scan: the thinned points
   * without reflections. They precede the recovered points. */
  std::size_t scannedPoints() const { return scanned_points_; }

  /** @brief Returns the share of each room's points that hole repair added in the last
   * run. */
  std::map<std::uint32_t, double> repairedShares() const { return repaired_shares_; }

  /** @brief Returns the share of each room that the scan did not support, at its own
   * density, in the last run. A warning reports large shares. */
  const std::map<std::uint32_t, UnseenShares>& unseenShares() const { return unseen_; }

private:
  /** @brief Runs one stage, `step(report)`, and stores its report. */
  template <typename Step>
  bool runStage(const std::string& name, std::size_t points_in, Step step);

  bool fail(const std::string& reason);

  void tellResult(const char* stage, std::uint32_t room = 0) const;

  /** @brief Adds a warning that a stage failed for one room; the others continue. */
  void warn(std::uint32_t room, const std::string& reason);

  bool checkScan();

  /** @brief Levels the cloud and the raw points of the fit if the scan is tilted. */
  void levelScan();

  /** @brief Makes tilted walls vertical. */
  void straightenScan();

  /** @brief Applies the tilts to the walls of the plan, and keeps the plan with
   * vertical walls for the following stages. */
  void tiltPlan();

  /** @brief Fits the ceilings of rooms with tilted walls again, to points where they
   * were scanned: with straightened walls a sloping plane is none. */
  void fitCeilingsAsScanned(const PointView& raw, const pcl::Indices& indices);

  /** @brief Moves the structure to the frame of the scan; the mesh is made in the other
   * frame. */
  void tiltStructure();
  bool partRooms(StageReport& report);
  bool findPlanes(StageReport& report);
  double cellSizeThatFills() const;
  void setCells(double size);
  void enlargeCells(double size);
  void restoreCells();

  /** @brief Adds the points of platforms and steps to the floors of their rooms. */
  void findPlatforms();

  /** @brief Collects the planes of all rooms in `planes`, for display. */
  void listPlanes();

  /** @brief Adds points where a room's ceiling is hidden, using the air below it.
   * @return number of points */
  std::size_t addHiddenCeiling(std::size_t room);

  bool findDetails(StageReport& report);

  /** @brief A part of a sloping ceiling that its model does not represent. */
  struct PlaceOff {
    double area = 0;                                      ///< square metres
    double low = std::numeric_limits<double>::infinity(); ///< metres
    double high = -std::numeric_limits<double>::infinity();
  };

  /** @brief Returns the part of a room's ceiling that is neither level nor near its
   * model. `distance(place, height)` returns the distance of a height from the model,
   * metres. */
  PlaceOff ceilingOff(
      std::size_t region,
      const std::function<double(const Eigen::Vector2d&, double)>& distance) const;

  /** @brief Returns whether a room's ceiling is more than level planes. */
  bool hasSheet(std::size_t region) const;

  /** @brief Returns the scanned points of a room's ceiling. */
  pcl::Indices seenCeiling(std::size_t region) const;

  /** @brief Returns the points of all ceilings that are not level, increasing. */
  pcl::IndicesPtr sheetPoints() const;

  /** @brief Warns of ceilings that are not level and that the plan does not
   * represent. */
  void warnOfCeilings();
  bool recoverFloors(StageReport& report);
  bool growWalls(StageReport& report);
  bool fitPlan(StageReport& report);
  bool refine(StageReport& report);
  bool repair(StageReport& report);

  /** @brief Returns the labelled points of a room, the input of refinement. */
  StructureCloud::Ptr labelledCloud(std::uint32_t room) const;

  /** @brief Labels the unlabelled points of a room's walls.
   * @return number of points */
  std::size_t labelWalls(std::uint32_t room, const pcl::Indices& walls);

  // The same stages, run by room_workers.
  void growWallsElsewhere(StageReport& report);
  bool refineElsewhere(StageReport& report); ///< with hole repair

  /** @brief Returns the points that may be walls of a room, increasing. */
  pcl::Indices wallPoints(std::size_t region) const;

  WallJob wallJob(std::size_t region) const;
  RepairJob repairJob(const PlanRoom& room) const;

  /** @brief Removes the labels of all points of a room. */
  void giveUp(std::uint32_t room);

  /** @brief Removes the labels of every room that has no plan. */
  void giveUpRoomsWithoutPlan();

  void addStructure(std::uint32_t room, const RepairedRoom& repaired);

  void warnOfGuesses();
  bool extrude(StageReport& report);

  /** @brief Returns the points with a label. */
  pcl::IndicesPtr labelled(StructureLabel label) const;

  /** @brief Returns the points of one room with a label. Requires shareOut() after the
   * last change of any other room's points. */
  pcl::IndicesPtr labelled(StructureLabel label, std::uint32_t room) const;

  /** @brief Updates the list of points of every room. */
  void shareOut();

  /** @brief Returns the cells of each room. */
  std::vector<CellSet> scopes() const;

  /** @brief Returns the territory of each room, up to `reach` metres from its
   * ceiling. */
  RoomTerritory territory(double reach) const;

  /** @brief As above, up to the maximum distance of walls. */
  RoomTerritory territory() const;

  /** @brief Returns the points in each room's territory. */
  std::vector<pcl::IndicesPtr> territories(const RoomTerritory& of_rooms) const;

  /** @brief Returns the columns of a room below level parts of its ceiling, on the
   * building's grid. */
  CellSet levelColumns(std::size_t room) const;

  /** @brief Labels the unlabelled points of a room's ceiling: soffits that the slices
   * did not separate from window heads, and points outside all slabs.
   * @return number of points */
  std::size_t labelLowerCeilings(std::size_t room);

  /** @brief Labels the points in niches, which no earlier stage considers. */
  void labelNiches();

  Priors priors_;
  double enlarged_from_ = 0; ///< cell size before it was enlarged; 0: not enlarged
  /** @brief Data of a room before its plan is fitted. */
  struct ChainRoom {
    pcl::Indices ceiling;  ///< ceiling points, whatever its shape
    pcl::Indices floor;    ///< points of its floor and platforms
    PlanSlab ceiling_slab; ///< largest slab of its ceiling
    PlanSlab floor_slab;   ///< largest slab of its floor
    CellSet scope;         ///< cells of its ceiling
  };

  std::shared_ptr<const SightLines> sight_; ///< rays, in the frame of `cloud`
  std::vector<TiltedFace> tilted_faces_;
  std::shared_ptr<Floorplan> straight_plan_; ///< `plan` before tilts are applied
  StructureCloud::Ptr straight_structure_;   ///< `structure` before tilts are applied
  std::vector<ChainRoom> regions_;
  std::vector<pcl::IndicesPtr> territory_; ///< of each room, indices of thinned points
  std::vector<pcl::Indices> shares_; ///< points of each room, starting with room 0
  std::vector<double> slice_height_; ///< of each room, NaN without details
  std::vector<StructureCloud::Ptr>
      refined_; ///< of each room of the plan, until repaired
  std::map<std::uint32_t, double> repaired_shares_;
  std::map<std::uint32_t, UnseenShares> unseen_;
  std::size_t scanned_points_ = 0;
};

} // namespace pcl::sedr
