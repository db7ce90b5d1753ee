// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_filters/structure_refinement.h>
#include <pcl/sedr_filters/vertical_hole_repair.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>
#include <pcl/sedr_segmentation/opening_detection.h>
#include <pcl/sedr_segmentation/room_segmentation.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/impl/mesh_reconstruction.h>
#include <pcl/sedr_surface/plan_review.h>
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

/** @brief What is known of a scan before it is looked at. */
struct ScanAssumptions {
  /** z is up, so that only its tilt is looked for. A scan of which another axis is up
   * by odds of 10 to 1 is refused otherwise. */
  bool up_is_known = false;
  /** The unit is the metre, so that no warning doubts it. A scan that is in feet by
   * odds of 10 to 1 is refused otherwise. */
  bool unit_is_known = false;
  /** A scan whose z axis seems not to be up, or which is tilted, is used unchanged. */
  bool trust_up = false;
  /** All results of a tilted scan stay level, see StructureModel::levelling. */
  bool keep_levelled = false;
};

/** @brief The stages, with setters of their own. */
struct ChainStages {
  pcl::ParallelVoxelGrid<pcl::PointXYZ> voxel_grid;
  pcl::RoomSegmentation<pcl::PointXYZ> room_segmentation;
  pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ> wall_growing;
  pcl::FloorplanFitting<pcl::PointXYZ> floorplan_fitting;
  pcl::OpeningDetection<pcl::PointXYZ> opening_detection;
  pcl::StructureRefinement<pcl::PointStructure> refinement;
  pcl::VerticalHoleRepair<pcl::PointStructure> hole_repair;
  pcl::FloorplanExtrusion<pcl::PointXYZ> extrusion;
  pcl::StructuralPoisson<pcl::PointStructure> poisson;
};

/** @brief Results of a run of the stages. What a stage keeps of its own run, such as
 * solid and mesh, has getters there. */
struct StructureModel {
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  using StructureCloud = pcl::PointCloud<pcl::PointStructure>;

  /** The rotation that levelled a scan tilted by 0.3 to 3 degrees; empty otherwise. All
   * results are in the level frame, but for the building of RoomSegmentation. */
  std::optional<Levelling> levelling;
  bool stays_level = false; ///< see ScanAssumptions::keep_levelled
  BuildingFrame frame;      ///< from the scan to the building, see findBuildingFrame()
  double stray_share = 0;   ///< of the points, removed by thinning
  MirrorFigures mirrored;
  Coverage coverage;                 ///< of what was seen by the plan
  Cloud::Ptr cloud{new Cloud};       ///< thinned points, without reflections
  std::vector<std::uint32_t> labels; ///< StructureLabel of each point
  std::vector<std::uint32_t> rooms;  ///< room of each point, 0 none
  std::vector<std::uint32_t> owners; ///< room whose air each point bounds, 0 none
  std::shared_ptr<Floorplan> plan = std::make_shared<Floorplan>();
  StructureCloud::Ptr structure{new StructureCloud}; ///< refined and repaired
  std::vector<StageReport> reports;
  std::vector<PlanWarning> warnings; ///< see sentenceOf() and reviewOf()
  std::string unit_doubt;   ///< the one of `warnings` that doubts the unit, or empty
  std::string failed_stage; ///< "input" if the scan is to blame; empty: none
  std::string problem;      ///< why it failed, a sentence

  /** @brief Returns the frame of the results in that of the building. */
  BuildingFrame levelFrame() const
  {
    return levelling ? levelling->frame() : BuildingFrame();
  }

  /** @brief Returns whether the frame of the results differs from that in which points,
   * mesh and solid are to be written: that of the scan, unless `stays_level`. */
  bool isMoved() const { return levelling && !stays_level; }

  /** @brief Returns a solid of the chain in the frame to write it in. */
  TriangleMesh inScanFrame(TriangleMesh mesh) const;

  /** @brief Returns `structure` in the frame to write it in. */
  StructureCloud::Ptr structureInScanFrame() const;
};

/** @brief A scan that was thinned in the frame of its building; elsewhere, e.g. in
 * parts on several machines. */
struct ThinnedScan {
  std::size_t size = 0; ///< points of the scan
  /** Means of the voxels, as ParallelVoxelGrid returns them. */
  StructureModel::Cloud::Ptr points{new StructureModel::Cloud};
  std::size_t strays = 0; ///< ParallelVoxelGrid::getStrayPoints()
  /** Every k-th point of the scan, with k chosen so that at most 5 million remain, in
   * the frame of the scan. */
  std::shared_ptr<std::vector<Eigen::Vector3f>> excerpt{
      new std::vector<Eigen::Vector3f>};
  std::string problem; ///< what is wrong with the scan, or empty
};

/** @brief A function that finds the frame of a building from ThinnedScan::excerpt; none
 * if the scan is refused. */
using FindFrame =
    std::function<std::optional<BuildingFrame>(const std::vector<Eigen::Vector3f>&)>;

/** @brief Runs the stages (paper, section 2.1): what of IndoorStructureReconstruction
 * does not depend on its type of points. The stages share one cloud with a label and a
 * room per point. What ceilings and floors hide is a state of their cells, see
 * HiddenCells; only repair makes points of it. */
class StructureChain {
public:
  using Cloud = StructureModel::Cloud;
  using StructureCloud = StructureModel::StructureCloud;

  StructureChain();
  ~StructureChain(); // here it would be compiled with every user

  ChainStages& getStages() { return stages_; }
  const ChainStages& getStages() const { return stages_; }

  /** @brief Returns the results of the last run. */
  const StructureModel& getModel() const { return model_; }

  /** @brief Sets a function that is called with a stage's name before it runs. If it
   * returns false, the run ends there and fails. */
  void setStageCallback(const std::function<bool(const std::string&)>& callback)
  {
    callback_ = callback;
  }

  /** @brief Sets what is known of the scan. Default: nothing. */
  void setAssumptions(const ScanAssumptions& known) { known_ = known; }
  const ScanAssumptions& getAssumptions() const { return known_; }

  /** @brief Sets what was subtracted from the scan's coordinates before they became
   * floats, metres. No stage uses it; writers of results do, e.g. floorplanToJson().
   * Default 0, 0, 0. */
  void setOrigin(const Origin& origin) { origin_ = origin; }
  const Origin& getOrigin() const { return origin_; }

  /** @brief Sets the scanner position of each point, by its place in the scan; excludes
   * indices. With positions, reflections in glass and mirrors are removed, see
   * doc/reading_scans.md. Default: none. */
  void setScanPositions(const ScanPositions& positions) { positions_ = positions; }

  /** @brief Sets a function that thins the scan with the leaf of the voxel grid, in
   * place of this object. It is called once per run: it takes the excerpt, asks for the
   * frame, and thins the points moved to it. Null (default): this object thins. */
  void setThinning(const std::function<ThinnedScan(const FindFrame&)>& thinning)
  {
    thinning_ = thinning;
  }

  /** @brief Sets the voxel size of down-sampling, metres. Default 0.05. Walls grow
   * within two cells and a voxel of the boundary of their ceiling. */
  void setVoxelSize(float size);
  float getVoxelSize() const { return stages_.voxel_grid.getLeafSize().x(); }

  /** @brief Sets the "tolerance of plane", metres. Default 0.07. */
  void setPlaneTolerance(double tolerance) { plane_tolerance_ = tolerance; }
  double getPlaneTolerance() const { return plane_tolerance_; }

  /** @brief Sets the cell size of all stages, metres. Default 0.05. After a run with an
   * adaptive grid, the getter returns the size that was used. */
  void setGridSize(double size);
  double getGridSize() const { return stages_.room_segmentation.getGridSize(); }

  /** @brief Sets the angle (radians) and the number of neighbors of boundary
   * estimation. Default 60 degrees and 200. */
  void setBoundaryEstimation(double angle, unsigned neighbors)
  {
    stages_.wall_growing.setAngleThreshold(static_cast<float>(angle));
    stages_.wall_growing.setNumberOfNeighbors(neighbors);
  }
  double getBoundaryAngle() const { return stages_.wall_growing.getAngleThreshold(); }
  unsigned getBoundaryNeighbors() const
  {
    return static_cast<unsigned>(stages_.wall_growing.getNumberOfNeighbors());
  }

  /** @brief Sets the "tolerance of boundary", metres. Default 0.05. */
  void setBoundaryTolerance(double tolerance)
  {
    stages_.floorplan_fitting.setDistanceThreshold(tolerance);
  }
  double getBoundaryTolerance() const
  {
    return stages_.floorplan_fitting.getDistanceThreshold();
  }

  /** @brief Sets the threads of all stages; 0 (default): all processors. The result
   * does not depend on it. */
  void setNumberOfThreads(unsigned threads = 0);
  unsigned getNumberOfThreads() const { return threads_; }

  /** @brief Sets the priors on buildings, furniture and scanners, including headroom,
   * steps, tilts and door widths of the stages. */
  void setPriors(const Priors& priors);
  const Priors& getPriors() const { return stages_.floorplan_fitting.getPriors(); }

  /** @brief Sets the seed of all random samples. Default 1. */
  void setSeed(std::uint64_t seed) { stages_.floorplan_fitting.setSeed(seed); }
  std::uint64_t getSeed() const { return stages_.floorplan_fitting.getSeed(); }

  /** @brief Runs all stages but thinning and the mesh, in the frame of the scan, made
   * level, as the cells of the stages follow those of thinning.
   * @return false if a stage found nothing; getModel() tells which and why */
  bool findStructure(const Cloud::ConstPtr& thinned);

  /** @brief Makes the mesh of the structure found by findStructure(). */
  bool makeMesh();

  /** @brief Returns the mesh in the frame to write it in, see
   * StructureModel::inScanFrame(). */
  TriangleMesh meshInScanFrame() const;

protected:
  /** @brief Discards the last run, including enlarged cells. */
  void reset();

  /** @brief Ends the run because of the scan, not of a stage.
   * @return false, always */
  bool refuse(const std::string& reason);

  /** @brief Thins a scan and runs all stages but the mesh in the frame of the building;
   * the results are turned back. To be called after reset().
   * @param scan null: that of the thinning which was set
   * @return false if a stage found nothing; getModel() tells which and why */
  bool findStructureOf(const RowSource* scan);

  std::function<ThinnedScan(const FindFrame&)> thinning_;
  ScanPositions positions_;
  StructureModel model_;

private:
  bool checkScan(const ScanPositions& positions);
  std::optional<BuildingFrame> findFrame(const std::vector<Eigen::Vector3f>& excerpt);
  ThinnedScan thin(const RowSource& scan);
  void leaveOutMirrored(const ScanPositions& positions, ThinnedScan& scan);
  bool runStage(const std::string& name,
                std::size_t points_in,
                const std::function<std::string(StageReport&)>& step);
  bool runStages();
  bool checkUnit();
  bool stop(const std::string& stage, const std::string& reason);
  void setCloud(const Cloud::ConstPtr& thinned);

  ChainStages stages_;
  Origin origin_;
  ScanAssumptions known_;
  std::function<bool(const std::string&)> callback_;
  unsigned threads_ = 0;
  double plane_tolerance_ = 0.07;
  double enlarged_from_ = 0; ///< cell size before it was enlarged; 0: not enlarged
  bool seems_in_feet_ = false;
  std::string missing_;  ///< what of floor and ceiling the scan does not show
  std::string up_doubt_; ///< why another direction than z may be up
};

} // namespace pcl::sedr

namespace pcl {

/** @brief Reconstructs the closed model of ceilings, floors and walls from an indoor
 * scan: all stages of the paper (section 2.1) as one SurfaceReconstruction. Frame: z
 * up, metres. Neither trajectory nor scanner positions are required, see
 * setScanPositions(). Non-finite points are skipped.
 *
 * This class is a thin composition. getStages() gives access to every stage, whose own
 * setters apply. Setters with names of the paper's Table 1 pass on the parameters that
 * several stages share.
 *
 * After reconstruct() the mesh has one closed component per room, and getModel() holds
 * labelled points, the floor plan, warnings and reports of the stages. If a stage finds
 * nothing, the mesh is empty and getErrorMessage() names the stage and what it looked
 * for. */
template <typename PointT>
class IndoorStructureReconstruction : public sedr::MeshReconstruction<PointT>,
                                      public sedr::StructureChain {
public:
  using Ptr = shared_ptr<IndoorStructureReconstruction<PointT>>;
  using ConstPtr = shared_ptr<const IndoorStructureReconstruction<PointT>>;
  using PointCloud = pcl::PointCloud<PointT>;

  IndoorStructureReconstruction();
  ~IndoorStructureReconstruction()
      override; // here it would be compiled with every user

  /** @brief Sets a scan that is read in pieces, in place of an input cloud and its
   * indices. The result is the same; memory grows with the thinned scan, not with the
   * scan. Null (default): the input cloud. */
  void setInputSource(const std::shared_ptr<const sedr::RowSource>& source)
  {
    source_ = source;
  }

  /** @brief Finds the structure without making the mesh.
   * @return false if a stage found nothing, with the reason in getErrorMessage() */
  bool findStructure();
  using StructureChain::findStructure;

  /** @brief Makes only the mesh of the structural Poisson, see getStages(), without the
   * copy of getMesh() and PCL's form, which is several times as large.
   * @return false if there is none, with the reason in getErrorMessage() */
  bool makeMesh();

  /** @brief Returns the refined and repaired points with normal, label and room. */
  StructureCloud::ConstPtr getStructure() const { return model_.structure; }
  std::shared_ptr<const sedr::Floorplan> getFloorplan() const { return model_.plan; }

protected:
  bool run() override;

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;
  using sedr::MeshReconstruction<PointT>::mesh_;

  /** @brief Tells why the run failed. */
  bool fail();

  std::shared_ptr<const sedr::RowSource> source_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_surface/impl/indoor_structure_reconstruction.hpp>
#endif
