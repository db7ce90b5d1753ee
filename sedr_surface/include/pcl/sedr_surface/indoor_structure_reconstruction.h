// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/stage_error.h>
#include <pcl/sedr_surface/structure_chain.h>

#include <pcl/surface/reconstruction.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A scan that was thinned elsewhere, say in parts on several machines. */
struct ThinnedScan {
  using CloudPtr = StructureChain::Cloud::Ptr;

  std::size_t size = 0; ///< points of the scan
  /** The means of the voxels, as ParallelVoxelGrid gives them. */
  CloudPtr points{new StructureChain::Cloud};
  unsigned stray_limit = 0; ///< its getStrayLimit()
  /** Every k-th point of the scan, as few as to leave 5 million at most. */
  std::shared_ptr<std::vector<Eigen::Vector3f>> excerpt{
      new std::vector<Eigen::Vector3f>};
  std::string problem; ///< what is wrong with the scan, or empty
};

} // namespace sedr

/** @brief From an indoor scan to the closed model of its ceilings, floors and walls:
 * all stages of the paper (section 2.1) as one SurfaceReconstruction. Frame: z up,
 * metres; no trajectory or scanner position is needed, see setScanPositions().
 * Non-finite points are left out.
 *
 * A thin composition: getVoxelGrid() and getChain() reach every stage, to be set as it
 * is set alone; the setters here carry the names of the paper's Table 1 and pass on
 * what several stages share.
 *
 * After reconstruct() the mesh has one closed component a room; its points by label,
 * the floor plan and what every stage did can be asked for. Where a stage finds
 * nothing, the mesh is empty and getErrorMessage() says which stage and what it looked
 * for.
 * @code
 * pcl::IndoorStructureReconstruction<pcl::PointXYZ> sedr;
 * sedr.setInputCloud(scan);
 * pcl::PolygonMesh mesh;
 * sedr.reconstruct(mesh);
 * @endcode */
template <typename PointT>
class IndoorStructureReconstruction : public SurfaceReconstruction<PointT>,
                                      public sedr::StageError {
public:
  using Ptr = shared_ptr<IndoorStructureReconstruction<PointT>>;
  using ConstPtr = shared_ptr<const IndoorStructureReconstruction<PointT>>;
  using PointCloud = pcl::PointCloud<PointT>;

  IndoorStructureReconstruction();

  /** @brief A scan that comes in pieces and need not stand in memory, in place of an
   * input cloud and its indices: the same result, in memory that grows with the thinned
   * scan and not with the scan. Null (default): the input cloud. */
  void setInputSource(const std::shared_ptr<const sedr::RowSource>& source)
  {
    source_ = source;
  }
  std::shared_ptr<const sedr::RowSource> getInputSource() const { return source_; }

  /** @brief Who thins the scan, with the leaf of getVoxelGrid(), in place of input
   * cloud and input source; called once a run. Null (default): this object. */
  void setThinning(const std::function<sedr::ThinnedScan()>& thinning)
  {
    thinning_ = thinning;
  }

  /** @brief What was subtracted from the coordinates of the scan before they became
   * floats, metres: nothing is computed with it, it is for who writes the results, as
   * sedr::floorplanToJson() does. Default 0, 0, 0. */
  void setOrigin(const sedr::Origin& origin) { chain_.origin = origin; }
  const sedr::Origin& getOrigin() const { return chain_.origin; }

  /** @brief Where the points of the scan were taken from, by their place in the input
   * cloud or source: what glass and mirrors show a second time is left out then, see
   * doc/building_blocks.md. Default none: nothing is. */
  void setScanPositions(const sedr::ScanPositions& positions)
  {
    positions_ = positions;
  }
  const sedr::ScanPositions& getScanPositions() const { return positions_; }

  /** @brief Size of a voxel in down-sampling, metres. Default 0.05. */
  void setVoxelSize(float size);
  float getVoxelSize() const { return voxel_grid_.getLeafSize().x(); }

  /** @brief Tolerance of plane, metres. Default 0.07. */
  void setPlaneTolerance(double tolerance);
  double getPlaneTolerance() const
  {
    return chain_.plane_detection.getDistanceThreshold();
  }

  /** @brief Grid size of all stages, metres. Default 0.05. After a run with an adaptive
   * grid, the size it took. */
  void setGridSize(double size);
  double getGridSize() const { return chain_.plane_detection.getGridSize(); }

  /** @brief Whether a scan too sparse to fill the cells of its ceilings gets larger
   * ones, of at most 2.5 times the grid size; a warning tells. Default true. */
  void setAdaptiveGrid(bool is_adaptive) { chain_.adapts_grid = is_adaptive; }
  bool getAdaptiveGrid() const { return chain_.adapts_grid; }

  /** @brief Angle and neighbours of boundary estimation: radians, number of points.
   * Default 60 degrees and 200. */
  void setBoundaryEstimation(double angle, unsigned neighbours);
  double getBoundaryAngle() const { return chain_.wall_growing.getAngleThreshold(); }
  unsigned getBoundaryNeighbors() const
  {
    return static_cast<unsigned>(chain_.wall_growing.getNumberOfNeighbors());
  }

  /** @brief Minimum of grids in a structural detail. Default 20. */
  void setMinimumDetailCells(std::size_t cells)
  {
    chain_.slice_detail.setMinimumCells(cells);
  }
  std::size_t getMinimumDetailCells() const
  {
    return chain_.slice_detail.getMinimumCells();
  }

  /** @brief Tolerance of boundary, metres. Default 0.05. */
  void setBoundaryTolerance(double tolerance)
  {
    chain_.floorplan_fitting.setDistanceThreshold(tolerance);
  }
  double getBoundaryTolerance() const
  {
    return chain_.floorplan_fitting.getDistanceThreshold();
  }

  /** @brief Maximum tree depth of the Poisson reconstruction. Default 9. */
  void setTreeDepth(int depth) { chain_.poisson.setDepth(depth); }

  int getTreeDepth() const { return chain_.poisson.getDepth(); }

  /** @brief Threads of all stages, 0 for all processors. Default 0. The result does not
   * depend on it. */
  void setNumberOfThreads(unsigned threads = 0);
  unsigned getNumberOfThreads() const { return threads_; }

  /** @brief What is believed of buildings, furniture and scanners before the scan is
   * looked at, see StructureChain::setPriors(). */
  void setPriors(const sedr::Priors& priors) { chain_.setPriors(priors); }
  const sedr::Priors& getPriors() const { return chain_.getPriors(); }

  /** @brief Seed of all random samples. Default 1. */
  void setSeed(std::uint64_t seed);
  std::uint64_t getSeed() const { return chain_.plane_detection.getSeed(); }

  ParallelVoxelGrid<PointT>& getVoxelGrid() { return voxel_grid_; }
  const ParallelVoxelGrid<PointT>& getVoxelGrid() const { return voxel_grid_; }

  /** @brief The stages after thinning, and what the last run left of each. */
  sedr::StructureChain& getChain() { return chain_; }
  const sedr::StructureChain& getChain() const { return chain_; }

  /** @brief The mesh with the room of every triangle. */
  void reconstruct(pcl::PolygonMesh& output) override;

  /** @brief As above; the points are those of the mesh. */
  void reconstruct(PointCloud& points, std::vector<pcl::Vertices>& polygons) override;

  /** @brief Finds the structure without making the mesh.
   * @return false where a stage found nothing, with the reason in getErrorMessage() */
  bool findStructure();

  /** @brief Makes the mesh of the structure that was found, for
   * getChain().poisson.getMesh() alone: without PCL's form of it, which is several
   * times as large.
   * @return false where there is none, with the reason in getErrorMessage() */
  bool makeMesh();

  /** @brief Refined and repaired points with normal, label and room. */
  sedr::StructureChain::StructureCloud::ConstPtr getStructure() const
  {
    return chain_.structure;
  }

  std::shared_ptr<const sedr::Floorplan> getFloorplan() const { return chain_.plan; }

  /** @brief What every stage did, in order. */
  const std::vector<sedr::StageReport>& getStageReports() const { return reports_; }

  /** @brief The stage that found nothing in the last run; empty after a good one. */
  const std::string& getFailedStage() const { return chain_.failed_stage; }

protected:
  void performReconstruction(pcl::PolygonMesh& output) override;

  void performReconstruction(PointCloud& points,
                             std::vector<pcl::Vertices>& polygons) override;

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

  bool refuseInput(const std::string& problem);

  /** @brief Checks the sizes of voxels and cells, and tells that thinning begins. */
  bool beginThinning();

  /** @brief Thins the input cloud; the raw cloud of the fit is the cloud itself. */
  bool thinCloud(PointCloud& means);

  /** @brief Thins the input source, in one pass; the raw cloud of the fit is every k-th
   * of its points. */
  bool thinSource(PointCloud& means);

  /** @brief Takes what is thinned elsewhere. */
  bool takeThinned(sedr::StructureChain::Cloud& thinned);

  bool thin(sedr::StructureChain::Cloud& thinned);

  /** @brief Leaves out of what was thinned, and of the points of the fit, what mirrors
   * show, if the positions of the scan are known. */
  void leaveOutMirrored(sedr::StructureChain::Cloud& thinned);

  /** @brief Thins a scan that stands here. */
  bool thinHere(sedr::StructureChain::Cloud& thinned);

  std::function<sedr::ThinnedScan()> thinning_;
  std::size_t scan_size_ = 0; ///< points
  sedr::ScanPositions positions_;
  std::shared_ptr<std::vector<Eigen::Vector3f>> excerpt_; ///< of the last run
  std::shared_ptr<const sedr::RowSource> source_;
  ParallelVoxelGrid<PointT> voxel_grid_;
  sedr::StructureChain chain_;
  std::vector<sedr::StageReport> reports_;
  unsigned threads_ = 0;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_surface/impl/indoor_structure_reconstruction.hpp>
#endif
