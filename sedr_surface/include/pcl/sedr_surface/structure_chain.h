// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floor_projection_recovery.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_filters/sight_lines.h>
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

namespace pcl {
namespace sedr {

class RoomTerritory;
class RoomWorkers;
struct RepairJob;
struct RepairedRoom;
struct WallJob;

/** @brief What a stage of the chain did. */
struct StageReport {
  std::string name;           ///< of the stage's class
  std::size_t points_in = 0;  ///< points it looked at
  std::size_t points_out = 0; ///< points it found or made
  double seconds = 0;
};

/** @brief What the positions of the scanner told. */
struct MirrorFigures {
  std::size_t positions = 0; ///< that are known
  std::size_t untrue = 0;    ///< of these, that the points were not taken from, as the
                          ///< scan shows
  std::size_t rays = 0;                    ///< that were followed
  std::size_t mirrors = 0;                 ///< surfaces that showed rooms a second time
  std::size_t points = 0;                  ///< thinned points that were left out
  std::shared_ptr<const SightLines> lines; ///< rays that met no reflection
  std::vector<std::uint8_t> behind; ///< 1 for each thinned point that was seen only
                                    ///< through panes
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

  pcl::RoomSegmentation<pcl::PointXYZ> room_segmentation;
  pcl::HorizontalPlaneDetection<pcl::PointXYZ> plane_detection;
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
   * object, while its getters still tell what that run decided. Planes, details,
   * floors, walls, refinement and repair run once a room; room 0 stands for all. */
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

  /** @brief What leaveOutMirrored() found before the run; a warning tells it. */
  MirrorFigures mirrored;

  /** @brief Leaves out what glass and mirrors show a second time, before
   * findStructure(): of `thinned`, and of every `step`-th point of the scan, where it
   * becomes NaN. */
  void leaveOutMirrored(const ScanPositions& positions,
                        std::size_t step,
                        Cloud& thinned,
                        std::vector<Eigen::Vector3f>& rows);

  /** @brief Whether the mesh is made of samples of the plan instead of the repaired
   * points: its edges round off less. */
  bool mesh_from_plan = false;

  /** @brief Whether a scan in which z seems not to be up, or that leans, is taken as it
   * is. */
  bool trust_up = false;

  /** @brief Whether what is made of a tilted scan stays in the level frame that it was
   * fitted in, see `levelling`. */
  bool keep_levelled = false;

  /** @brief What the coordinates of the scan are counted from, for who writes what the
   * chain found. */
  Origin origin;

  /** @brief The cells of all stages, metres. */
  void setGridSize(double size);

  /** @brief What all stages believe of buildings, furniture and scanners before they
   * look at the scan; headroom, steps, tilts and door widths of the stages with it. */
  void setPriors(const Priors& priors);
  const Priors& getPriors() const { return priors_; }

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
  /** @brief How walls that lean were made vertical for all stages but the solid; the
   * identity where none does. `cloud` and the mesh are in that frame, plan, structure
   * and solid in that of the scan. */
  Straightening straightening;
  WallTilts tilts;  ///< the walls of `plan` that lean
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

  /** @brief The building as room segmentation found it: room r + 1 is the r-th. */
  const Building& getBuilding() const { return room_segmentation.getBuilding(); }

  /** @brief A solid that the chain holds, in the frame of the scan, unless
   * keep_levelled. */
  TriangleMesh inScanFrame(TriangleMesh mesh) const;

  /** @brief The mesh with walls that lean, level as all that the chain holds. */
  TriangleMesh leanedMesh() const;

  /** @brief The mesh in that frame. */
  TriangleMesh meshInScanFrame() const;

  /** @brief Whether that is another one than the mesh is in. */
  bool isMeshMoved() const
  {
    return !straightening.isIdentity() || (levelling && !keep_levelled);
  }

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

  /** @brief Makes walls that lean vertical. */
  void straightenScan();

  /** @brief Gives the walls of the plan their tilts, and keeps the plan with vertical
   * ones for the stages that follow. */
  void leanPlan();

  /** @brief The structure in the frame of the scan; the mesh is made in the other. */
  void leanStructure();
  bool partRooms(StageReport& report);
  bool findPlanes(StageReport& report);
  double cellSizeThatFills() const;
  void setCells(double size);
  void enlargeCells(double size);
  void restoreCells();

  /** @brief Adds to the floors of rooms the points of their platforms and steps. */
  void findPlatforms();

  /** @brief Keeps the planes of all rooms as `planes`, for those who look at them. */
  void listPlanes();

  /** @brief Puts points where the ceiling of a room was hidden, by the air below it.
   * @return how many */
  std::size_t addHiddenCeiling(std::size_t room);

  bool findDetails(StageReport& report);

  /** @brief What of a ceiling that is not level lies off what stands for it. */
  struct PlaceOff {
    double area = 0;                                      ///< square metres
    double low = std::numeric_limits<double>::infinity(); ///< metres
    double high = -std::numeric_limits<double>::infinity();
  };

  /** @brief What of a room's ceiling is neither level nor near what stands for it:
   * `distance(place, height)` says how far a height is from that, metres. */
  PlaceOff ceilingOff(
      std::size_t region,
      const std::function<double(const Eigen::Vector2d&, double)>& distance) const;

  /** @brief Whether a room's ceiling is more than level planes. */
  bool hasSheet(std::size_t region) const;

  /** @brief The points of a room's ceiling that were scanned. */
  pcl::Indices seenCeiling(std::size_t region) const;

  /** @brief The points of all ceilings that are not level, increasing. */
  pcl::IndicesPtr sheetPoints() const;

  /** @brief Warns of ceilings that are not level and that the plan does not tell. */
  void warnOfCeilings();
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

  /** @brief Takes the labels of every room that the plan does not have. */
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

  /** @brief The cells of each room. */
  std::vector<CellSet> scopes() const;

  /** @brief The territory of each room, as far as `reach` metres from its ceiling. */
  RoomTerritory territory(double reach) const;

  /** @brief The same as far as walls can be. */
  RoomTerritory territory() const;

  /** @brief Points that lie in each room's territory. */
  std::vector<pcl::IndicesPtr> territories(const RoomTerritory& of_rooms) const;

  /** @brief The columns of a room, of the building's size, below level parts of its
   * ceiling. */
  CellSet levelColumns(std::size_t room) const;

  /** @brief Labels what is not yet labelled of a room's ceiling: soffits that the
   * slices did not tell from the head of a window, and what no slab is.
   * @return how many points */
  std::size_t labelLowerCeilings(std::size_t room);

  /** @brief Labels the points in the niches of rooms, which no earlier stage looks at.
   */
  void labelNiches();

  Priors priors_;
  double enlarged_from_ = 0; ///< the size of cells that was set; 0: it was kept
  /** @brief What is known of a room before its plan is fitted. */
  struct ChainRoom {
    pcl::Indices ceiling;  ///< points of its ceiling, whatever its shape
    pcl::Indices floor;    ///< points of its floor and its platforms
    PlanSlab ceiling_slab; ///< the largest of its ceiling
    PlanSlab floor_slab;   ///< the largest of its floor
    CellSet scope;         ///< cells of its ceiling
  };

  std::shared_ptr<const SightLines> sight_; ///< rays, in the frame of `cloud`
  std::vector<LeaningFace> leaning_faces_;
  std::shared_ptr<Floorplan> straight_plan_; ///< `plan` with vertical walls
  StructureCloud::Ptr straight_structure_;   ///< `structure` between them
  std::vector<ChainRoom> regions_;
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
