// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_filters/structure_refinement.h>
#include <pcl/sedr_filters/vertical_hole_repair.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>
#include <pcl/sedr_segmentation/horizontal_plane_detection.h>
#include <pcl/sedr_segmentation/opening_detection.h>
#include <pcl/sedr_segmentation/room_segmentation.h>
#include <pcl/sedr_surface/coverage.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/structural_poisson.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl::sedr {

class SightLines;

/** @brief Report on a stage of the chain. */
struct StageReport {
  std::string name;           ///< of the stage's class
  std::size_t points_in = 0;  ///< number of input points
  std::size_t points_out = 0; ///< number of points found or made
  double seconds = 0;
};

/** @brief Results of using the scanner positions. */
struct MirrorFigures {
  std::size_t positions = 0;               ///< known positions
  std::size_t untrue = 0;                  ///< of these, that the scan contradicts
  std::size_t rays = 0;                    ///< rays traced
  std::size_t mirrors = 0;                 ///< surfaces that reflect rooms
  std::size_t points = 0;                  ///< thinned points that were removed
  std::shared_ptr<const SightLines> lines; ///< rays that met no reflection
  std::vector<std::uint8_t> behind;        ///< 1: thinned point seen only through glass
};

/** @brief Runs the stages after thinning (paper, section 2.1). Each stage
 * is a PCL-style object, a member of this class with its own setters. The stages share
 * one cloud with a label and a room per point. What ceilings and floors hide is a state
 * of their cells, see HiddenCells; only repair makes points of it. */
class StructureChain {
public:
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  using StructureCloud = pcl::PointCloud<pcl::PointStructure>;

  StructureChain();
  ~StructureChain(); // here it would be compiled with every user

  pcl::RoomSegmentation<pcl::PointXYZ> room_segmentation;
  pcl::HorizontalPlaneDetection<pcl::PointXYZ> plane_detection;
  pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ> wall_growing;
  pcl::FloorplanFitting<pcl::PointXYZ> floorplan_fitting;
  pcl::OpeningDetection<pcl::PointXYZ> opening_detection;
  pcl::StructureRefinement<pcl::PointStructure> refinement;
  pcl::VerticalHoleRepair<pcl::PointStructure> hole_repair;
  pcl::FloorplanExtrusion<pcl::PointXYZ> extrusion;
  pcl::StructuralPoisson<pcl::PointStructure> poisson;

  /** @brief Called with a stage's name before it runs. */
  std::function<void(const std::string&)> on_stage;

  /** @brief Asked before every stage. If it returns true, the run ends: it returns
   * false, and `problem` tells before which stage. */
  std::function<bool()> is_cancelled;

  /** @brief Share of the points that thinning removed as strays, see
   * ParallelVoxelGrid::getStrayPoints(). A warning reports it. */
  double stray_share = 0;

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

  /** @brief Whether a scan whose z axis seems not to be up, or which is tilted, is used
   * unchanged. */
  bool trust_up = false;

  /** @brief Whether z is known to be up, so that only its tilt is looked for. A scan
   * of which another axis is up by odds of 10 to 1 is refused otherwise. */
  bool up_is_known = false;

  /** @brief Whether the results of a tilted scan stay in the level frame, see
   * `levelling`. */
  bool keep_levelled = false;

  /** @brief Whether the unit is known to be the metre, so that no warning doubts it. A
   * scan that is in feet by odds of 10 to 1 is refused otherwise. */
  bool unit_is_known = false;

  /** @brief Origin of the scan's coordinates, for writers of the results. */
  Origin origin;

  /** @brief Sets the cell size of all stages, metres. */
  void setGridSize(double size);

  /** @brief Sets the priors on buildings, furniture and scanners, including headroom,
   * steps, tilts and door widths of the stages. */
  void setPriors(const Priors& priors);
  const Priors& getPriors() const { return priors_; }

  /** @brief Checks a scan and finds the frame of its building, see `frame`. Only for
   * those who thin the scan in that frame: findStructure() then takes points in it.
   * @param thinned points of the scan; a sample suffices
   * @param positions of the scanners, if known
   * @return false if it is no scan to work with; see failed_stage and problem */
  bool findFrame(const Cloud::ConstPtr& thinned, const ScanPositions& positions = {});

  /** @brief Runs all stages but the mesh. After findFrame() they work in the frame of
   * the building, and the results are turned back; else in that of the scan, made
   * level, as the cells of the stages follow those of thinning.
   * @param thinned in the frame of the scan, or after findFrame() in that of the
   * building
   * @return false if a stage found nothing; see failed_stage and problem */
  bool findStructure(const Cloud::ConstPtr& thinned);

  /** @brief Makes the mesh of the structure found by findStructure(). */
  bool makeMesh();

  /** @brief Discards the last run, including enlarged cells, and sets `thinned` as the
   * cloud. */
  void reset(const Cloud::ConstPtr& thinned);

  // Results of the last run.
  /** @brief The rotation that levelled a scan tilted by 0.3 to 3 degrees; empty
   * otherwise. All results of the chain are in the level frame, but for getBuilding().
   */
  std::optional<Levelling> levelling;
  BuildingFrame frame; ///< from the scan to the building, see findBuildingFrame()
  Coverage coverage;   ///< of what was seen by the plan
  Cloud::Ptr cloud;    ///< thinned points, without reflections
  std::vector<std::uint32_t> labels; ///< StructureLabel of each point
  std::vector<std::uint32_t> rooms;  ///< room of each point, 0 none
  std::shared_ptr<Floorplan> plan;
  StructureCloud::Ptr structure; ///< refined and repaired
  std::vector<StageReport> reports;
  std::vector<PlanWarning> warnings; ///< see sentenceOf() and summaryOf()
  std::string unit_doubt; ///< the one of `warnings` that doubts the unit, or empty
  std::string failed_stage;
  std::string problem;

  /** @brief Returns the frame of the results in that of the building. */
  BuildingFrame levelFrame() const
  {
    return levelling ? levelling->frame() : BuildingFrame();
  }

  /** @brief Returns the building from room segmentation, in its own frame; room r + 1
   * is the r-th. */
  const Building& getBuilding() const { return room_segmentation.getBuilding(); }

  /** @brief Moves a solid of the chain to the frame of the scan, unless
   * keep_levelled. */
  TriangleMesh inScanFrame(TriangleMesh mesh) const;

  /** @brief Returns the mesh in the frame of the scan. */
  TriangleMesh meshInScanFrame() const;

  /** @brief Returns whether the frame of the mesh differs from that of the scan. */
  bool isMeshMoved() const { return levelling && !keep_levelled; }

  /** @brief Returns the refined and repaired points in the frame of the scan. */
  StructureCloud::Ptr structureInScanFrame() const;

private:
  friend class ChainRun;

  void setCloud(const Cloud::ConstPtr& thinned);
  void setCells(double size);
  void enlargeCells(double size);
  void restoreCells();

  Priors priors_;
  double enlarged_from_ = 0; ///< cell size before it was enlarged; 0: not enlarged
  bool is_in_frame_ = false; ///< the next cloud is in the frame of the building
  bool seems_in_feet_ = false;
  std::string up_doubt_; ///< why another direction than z may be up
};

} // namespace pcl::sedr
