// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_surface/mesh_reconstruction.h>
#include <pcl/sedr_surface/structure_chain.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A scan that was thinned in the frame of its building; elsewhere, e.g. in
 * parts on several machines. */
struct ThinnedScan {
  using CloudPtr = StructureChain::Cloud::Ptr;

  std::size_t size = 0; ///< points of the scan
  /** Means of the voxels, as ParallelVoxelGrid returns them. */
  CloudPtr points{new StructureChain::Cloud};
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

} // namespace sedr

/** @brief Reconstructs the closed model of ceilings, floors and walls from an indoor
 * scan: all stages of the paper (section 2.1) as one SurfaceReconstruction. Frame: z
 * up, metres. Neither trajectory nor scanner positions are required, see
 * setScanPositions(). Non-finite points are skipped.
 *
 * This class is a thin composition. getVoxelGrid() and getChain() give access to every
 * stage, whose own setters apply. The setters here carry the names of the paper's Table
 * 1 and pass on the parameters that several stages share.
 *
 * After reconstruct() the mesh has one closed component per room. Labelled points, the
 * floor plan and the reports of the stages have getters. If a stage finds nothing, the
 * mesh is empty and getErrorMessage() names the stage and what it looked for. */
template <typename PointT>
class IndoorStructureReconstruction : public sedr::MeshReconstruction<PointT> {
public:
  using Ptr = shared_ptr<IndoorStructureReconstruction<PointT>>;
  using ConstPtr = shared_ptr<const IndoorStructureReconstruction<PointT>>;
  using PointCloud = pcl::PointCloud<PointT>;

  IndoorStructureReconstruction();
  ~IndoorStructureReconstruction() override; // as that of StructureChain

  /** @brief Sets a scan that is read in pieces, in place of an input cloud and its
   * indices. The result is the same; memory grows with the thinned scan, not with the
   * scan. Null (default): the input cloud. */
  void setInputSource(const std::shared_ptr<const sedr::RowSource>& source)
  {
    source_ = source;
  }

  /** @brief Sets a function that thins the scan with the leaf of getVoxelGrid(), in
   * place of input cloud and source. It is called once per run: it takes the excerpt,
   * asks for the frame, and thins the points moved to it. Null (default): this object
   * thins. */
  void
  setThinning(const std::function<sedr::ThinnedScan(const sedr::FindFrame&)>& thinning)
  {
    thinning_ = thinning;
  }

  /** @brief Sets what was subtracted from the scan's coordinates before they became
   * floats, metres. No stage uses it; writers of results do, e.g.
   * sedr::floorplanToJson(). Default 0, 0, 0. */
  void setOrigin(const sedr::Origin& origin) { chain_.origin = origin; }
  const sedr::Origin& getOrigin() const { return chain_.origin; }

  /** @brief Sets the scanner position of each point, by its place in the input cloud or
   * source; excludes indices. With positions, reflections in glass and mirrors are
   * removed, see doc/building_blocks.md. Default: none. */
  void setScanPositions(const sedr::ScanPositions& positions)
  {
    positions_ = positions;
  }

  /** @brief Sets the voxel size of down-sampling, metres. Default 0.05. */
  void setVoxelSize(float size)
  {
    voxel_grid_.setLeafSize(size, size, size);
    chain_.wall_growing.setDistanceThreshold(2 * getGridSize() + size);
  }
  float getVoxelSize() const { return voxel_grid_.getLeafSize().x(); }

  /** @brief Sets the "tolerance of plane", metres. Default 0.07. */
  void setPlaneTolerance(double tolerance)
  {
    chain_.plane_detection.setDistanceThreshold(tolerance);
  }
  double getPlaneTolerance() const
  {
    return chain_.plane_detection.getDistanceThreshold();
  }

  /** @brief Sets the cell size of all stages, metres. Default 0.05. After a run with an
   * adaptive grid, the getter returns the size that was used. */
  void setGridSize(double size)
  {
    chain_.setGridSize(size);
    chain_.wall_growing.setDistanceThreshold(2 * size + getVoxelSize());
  }
  double getGridSize() const { return chain_.plane_detection.getGridSize(); }

  /** @brief Sets the angle (radians) and the number of neighbours of boundary
   * estimation. Default 60 degrees and 200. */
  void setBoundaryEstimation(double angle, unsigned neighbours)
  {
    chain_.wall_growing.setAngleThreshold(static_cast<float>(angle));
    chain_.wall_growing.setNumberOfNeighbors(neighbours);
  }
  double getBoundaryAngle() const { return chain_.wall_growing.getAngleThreshold(); }
  unsigned getBoundaryNeighbors() const
  {
    return static_cast<unsigned>(chain_.wall_growing.getNumberOfNeighbors());
  }

  /** @brief Sets the "tolerance of boundary", metres. Default 0.05. */
  void setBoundaryTolerance(double tolerance)
  {
    chain_.floorplan_fitting.setDistanceThreshold(tolerance);
  }
  double getBoundaryTolerance() const
  {
    return chain_.floorplan_fitting.getDistanceThreshold();
  }

  /** @brief Sets the threads of all stages; 0 (default): all processors. The result
   * does not depend on it. */
  void setNumberOfThreads(unsigned threads = 0);
  unsigned getNumberOfThreads() const { return threads_; }

  /** @brief Sets the priors on buildings, furniture and scanners, see
   * StructureChain::setPriors(). */
  void setPriors(const sedr::Priors& priors) { chain_.setPriors(priors); }
  const sedr::Priors& getPriors() const { return chain_.getPriors(); }

  /** @brief Sets the seed of all random samples. Default 1. */
  void setSeed(std::uint64_t seed)
  {
    chain_.plane_detection.setSeed(seed);
    chain_.floorplan_fitting.setSeed(seed);
  }
  std::uint64_t getSeed() const { return chain_.plane_detection.getSeed(); }

  ParallelVoxelGrid<PointT>& getVoxelGrid() { return voxel_grid_; }
  const ParallelVoxelGrid<PointT>& getVoxelGrid() const { return voxel_grid_; }

  /** @brief Returns the stages after thinning and their results of the last run. */
  sedr::StructureChain& getChain() { return chain_; }
  const sedr::StructureChain& getChain() const { return chain_; }

  /** @brief Finds the structure without making the mesh.
   * @return false if a stage found nothing, with the reason in getErrorMessage() */
  bool findStructure();

  /** @brief Makes only getChain().poisson.getMesh() from the structure, without the
   * copy of getMesh() and PCL's form, which is several times as large.
   * @return false if there is none, with the reason in getErrorMessage() */
  bool makeMesh();

  /** @brief Returns the refined and repaired points with normal, label and room. */
  sedr::StructureChain::StructureCloud::ConstPtr getStructure() const
  {
    return chain_.structure;
  }
  std::shared_ptr<const sedr::Floorplan> getFloorplan() const { return chain_.plan; }

  /** @brief Returns the reports of all stages, in order. */
  const std::vector<sedr::StageReport>& getStageReports() const { return reports_; }

  /** @brief Returns the stage that found nothing in the last run; empty after a
   * success. */
  const std::string& getFailedStage() const { return chain_.failed_stage; }

protected:
  bool run() override;

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;
  using sedr::MeshReconstruction<PointT>::mesh_;
  using sedr::MeshReconstruction<PointT>::fail;

  bool refuseInput(const std::string& problem);

  std::shared_ptr<const sedr::RowSource> sourceOf(PointCloud& chosen) const;

  /** @brief Thins the scan here. */
  sedr::ThinnedScan thinHere(const sedr::FindFrame& find_frame);

  /** @brief Finds the frame of the building. */
  std::optional<sedr::BuildingFrame>
  findFrame(const std::vector<Eigen::Vector3f>& excerpt);

  /** @brief As above; checks the settings before and the result after. */
  bool thin(sedr::ThinnedScan& scan);

  /** @brief Removes reflections from the thinned cloud and the raw points of the fit,
   * if the scanner positions are known. */
  void leaveOutMirrored(sedr::ThinnedScan& scan);

  std::function<sedr::ThinnedScan(const sedr::FindFrame&)> thinning_;
  sedr::ScanPositions positions_;
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
