// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/parallel_voxel_grid.h>
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
  using CloudPtr = StructureModel::Cloud::Ptr;

  std::size_t size = 0; ///< points of the scan
  /** Means of the voxels, as ParallelVoxelGrid returns them. */
  CloudPtr points{new StructureModel::Cloud};
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
 * This class is a thin composition. getVoxelGrid() and getStages() give access to every
 * stage, whose own setters apply. Setters with names of the paper's Table 1 pass on the
 * parameters that several stages share.
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

  /** @brief Sets a function that thins the scan with the leaf of getVoxelGrid(), in
   * place of input cloud and source. It is called once per run: it takes the excerpt,
   * asks for the frame, and thins the points moved to it. Null (default): this object
   * thins. */
  void
  setThinning(const std::function<sedr::ThinnedScan(const sedr::FindFrame&)>& thinning)
  {
    thinning_ = thinning;
  }

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
    stages_.wall_growing.setDistanceThreshold(2 * getGridSize() + size);
  }
  float getVoxelSize() const { return voxel_grid_.getLeafSize().x(); }

  /** @brief As StructureChain::setGridSize(); walls grow within two cells and a voxel.
   */
  void setGridSize(double size)
  {
    StructureChain::setGridSize(size);
    stages_.wall_growing.setDistanceThreshold(2 * size + getVoxelSize());
  }

  /** @brief Sets the threads of all stages, see StructureChain. */
  void setNumberOfThreads(unsigned threads = 0)
  {
    StructureChain::setNumberOfThreads(threads);
    voxel_grid_.setNumberOfThreads(threads);
  }

  ParallelVoxelGrid<PointT>& getVoxelGrid() { return voxel_grid_; }
  const ParallelVoxelGrid<PointT>& getVoxelGrid() const { return voxel_grid_; }

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

  /** @brief Returns what is wrong with the settings, a sentence, or an empty text. */
  std::string settingsProblem() const;

  /** @brief Thins the scan here. */
  sedr::ThinnedScan thinHere(const sedr::FindFrame& find_frame);

  /** @brief Finds the frame of the building. */
  std::optional<sedr::BuildingFrame>
  findFrameOf(const std::vector<Eigen::Vector3f>& excerpt);

  /** @brief Thins the scan in the frame of the building.
   * @return why it failed, a sentence, or an empty text */
  std::string thin(sedr::ThinnedScan& scan, sedr::StageReport& report);

  std::function<sedr::ThinnedScan(const sedr::FindFrame&)> thinning_;
  sedr::ScanPositions positions_;
  std::shared_ptr<const sedr::RowSource> source_;
  ParallelVoxelGrid<PointT> voxel_grid_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_surface/impl/indoor_structure_reconstruction.hpp>
#endif
