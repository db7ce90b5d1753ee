// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/impl/mesh_reconstruction.hpp>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <pcl/common/io.h>

#include <chrono>

namespace pcl {
namespace sedr {

/** @brief Returns why voxels are too large for the grid, a sentence; empty if they are
 * not. */
std::string voxelProblem(double voxel_size, double grid_size);

/** @brief Returns why a scan or its indices are invalid, a sentence; empty if valid. */
std::string cloudProblem(const PointView& points,
                         const pcl::Indices& indices,
                         const Priors& priors);

/** @brief Returns the step k of the excerpt, which holds every k-th point of the
 * scan. */
std::size_t excerptStep(std::size_t points);

/** @brief Returns every k-th point of a cloud, NaN where it is not among the
 * indices. */
std::shared_ptr<std::vector<Eigen::Vector3f>> excerptOf(const PointView& points,
                                                        const pcl::Indices& indices);

/** @brief Thins a source by `thin` and collects every k-th of its points in the same
 * pass.
 * @return why the scan is invalid, a sentence; empty if valid */
std::string thinWithExcerpt(const RowSource& source,
                            unsigned threads,
                            const std::function<void(const RowSource&)>& thin,
                            std::shared_ptr<std::vector<Eigen::Vector3f>>& excerpt);

} // namespace sedr

template <typename PointT>
IndoorStructureReconstruction<PointT>::IndoorStructureReconstruction()
{
  voxel_grid_.setDownsampleAllData(false);
  voxel_grid_.setRemoveStrays(true);
  setNumberOfThreads(threads_);
}

template <typename PointT>
void
IndoorStructureReconstruction<PointT>::setVoxelSize(float size)
{
  voxel_grid_.setLeafSize(size, size, size);
  chain_.wall_growing.setDistanceThreshold(2 * getGridSize() + size);
}

template <typename PointT>
void
IndoorStructureReconstruction<PointT>::setPlaneTolerance(double tolerance)
{
  chain_.plane_detection.setDistanceThreshold(tolerance);
}

template <typename PointT>
void
IndoorStructureReconstruction<PointT>::setGridSize(double size)
{
  chain_.setGridSize(size);
  chain_.wall_growing.setDistanceThreshold(2 * size + getVoxelSize());
}

template <typename PointT>
void
IndoorStructureReconstruction<PointT>::setBoundaryEstimation(double angle,
                                                             unsigned neighbours)
{
  chain_.wall_growing.setAngleThreshold(static_cast<float>(angle));
  chain_.wall_growing.setNumberOfNeighbors(neighbours);
}

template <typename PointT>
void
IndoorStructureReconstruction<PointT>::setNumberOfThreads(unsigned threads)
{
  threads_ = threads;
  voxel_grid_.setNumberOfThreads(threads);
  chain_.plane_detection.setNumberOfThreads(threads);
  chain_.room_segmentation.setNumberOfThreads(threads);
  chain_.wall_growing.setNumberOfThreads(threads);
  chain_.floorplan_fitting.setNumberOfThreads(threads);
  chain_.opening_detection.setNumberOfThreads(threads);
  chain_.refinement.setNumberOfThreads(threads);
  chain_.hole_repair.setNumberOfThreads(threads);
  chain_.poisson.setNumberOfThreads(threads);
}

template <typename PointT>
void
IndoorStructureReconstruction<PointT>::setSeed(std::uint64_t seed)
{
  chain_.plane_detection.setSeed(seed);
  chain_.floorplan_fitting.setSeed(seed);
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::refuseInput(const std::string& problem)
{
  chain_.failed_stage = "input";
  return fail("IndoorStructureReconstruction", "input: " + problem);
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::beginThinning()
{
  const std::string problem = sedr::voxelProblem(getVoxelSize(), getGridSize());
  if (!problem.empty())
    return refuseInput(problem);
  if (chain_.on_stage)
    chain_.on_stage("ParallelVoxelGrid");
  return true;
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::thinCloud(PointCloud& means)
{
  // Checked before thinning, which would not reduce a scan in millimetres.
  const std::string problem =
      sedr::cloudProblem(sedr::PointView(*input_), *indices_, getPriors());
  if (!problem.empty())
    return refuseInput(problem);
  if (!beginThinning())
    return false;
  voxel_grid_.setInputCloud(input_);
  voxel_grid_.setIndices(indices_);
  voxel_grid_.filter(means);
  chain_.floorplan_fitting.setRawCloud(input_, indices_);
  if (!positions_.empty())
    excerpt_ = sedr::excerptOf(sedr::PointView(*input_), *indices_);
  return true;
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::thinSource(PointCloud& means)
{
  if (!beginThinning())
    return false;
  const std::string problem = sedr::thinWithExcerpt(
      *source_, threads_,
      [&](const sedr::RowSource& rows) { voxel_grid_.filter(rows, means); }, excerpt_);
  if (!problem.empty())
    return refuseInput(problem);
  chain_.floorplan_fitting.setRawPoints(excerpt_);
  return true;
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::takeThinned(sedr::StructureChain::Cloud& thinned)
{
  if (!beginThinning())
    return false;
  const sedr::ThinnedScan scan = thinning_();
  if (!scan.problem.empty())
    return refuseInput(scan.problem);
  thinned.swap(*scan.points);
  scan_size_ = scan.size;
  chain_.stray_limit = scan.stray_limit;
  excerpt_ = scan.excerpt;
  chain_.floorplan_fitting.setRawPoints(excerpt_);
  return true;
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::thinHere(sedr::StructureChain::Cloud& thinned)
{
  PointCloud means;
  if (!(source_ ? thinSource(means) : thinCloud(means)))
    return false;
  if (!voxel_grid_.getErrorMessage().empty()) {
    chain_.failed_stage = "ParallelVoxelGrid";
    return fail("IndoorStructureReconstruction",
                "ParallelVoxelGrid: " + voxel_grid_.getErrorMessage());
  }
  pcl::copyPointCloud(means, thinned);
  scan_size_ = source_ ? source_->size() : indices_->size();
  chain_.stray_limit = voxel_grid_.getStrayLimit();
  return true;
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::thin(sedr::StructureChain::Cloud& thinned)
{
  const auto start = std::chrono::steady_clock::now();
  if (!(thinning_ ? takeThinned(thinned) : thinHere(thinned)))
    return false;
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - start;
  reports_.push_back(
      {"ParallelVoxelGrid", scan_size_, thinned.size(), seconds.count()});
  return true;
}

template <typename PointT>
void
IndoorStructureReconstruction<PointT>::leaveOutMirrored(
    sedr::StructureChain::Cloud& thinned)
{
  if (positions_.empty())
    return;
  const auto start = std::chrono::steady_clock::now();
  if (chain_.on_stage)
    chain_.on_stage("MirroredPoints");
  const std::size_t before = thinned.size();
  const std::size_t rows = source_ || thinning_ ? scan_size_ : input_->size();
  chain_.leaveOutMirrored(positions_, sedr::excerptStep(rows), thinned, *excerpt_);
  if (before > thinned.size())
    chain_.floorplan_fitting.setRawPoints(excerpt_);
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - start;
  reports_.push_back({"MirroredPoints", before, thinned.size(), seconds.count()});
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::findStructure()
{
  constexpr const char* name = "IndoorStructureReconstruction";
  this->clearError();
  mesh_ = sedr::TriangleMesh();
  reports_.clear();
  const sedr::StructureChain::Cloud::Ptr thinned(new sedr::StructureChain::Cloud);
  chain_.reset(thinned);
  const bool has_cloud = !source_ && !thinning_;
  if (has_cloud && !this->initCompute()) {
    chain_.failed_stage = "input";
    return fail(name, "no input cloud was set");
  }
  chain_.mirrored = sedr::MirrorFigures();
  bool is_done = thin(*thinned);
  if (is_done) {
    leaveOutMirrored(*thinned);
    is_done = chain_.findStructure(thinned);
    reports_.insert(reports_.end(), chain_.reports.begin(), chain_.reports.end());
    if (!is_done)
      fail(name, chain_.failed_stage + ": " + chain_.problem);
  }
  chain_.floorplan_fitting.setRawPoints(nullptr);
  excerpt_.reset();
  if (has_cloud)
    this->deinitCompute();
  return is_done;
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::makeMesh()
{
  const bool is_done = chain_.makeMesh();
  reports_.push_back(chain_.reports.back());
  return is_done || fail("IndoorStructureReconstruction",
                         chain_.failed_stage + ": " + chain_.problem);
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::run()
{
  if (!findStructure() || !makeMesh())
    return false;
  mesh_ = chain_.meshInScanFrame();
  return true;
}

} // namespace pcl

#define PCL_INSTANTIATE_IndoorStructureReconstruction(T)                               \
  template class PCL_EXPORTS pcl::IndoorStructureReconstruction<T>;
