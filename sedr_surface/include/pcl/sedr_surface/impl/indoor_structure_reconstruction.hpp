// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/parallel_voxel_grid.hpp>
#include <pcl/sedr_surface/impl/mesh_reconstruction.hpp>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <pcl/common/io.h>

#include <chrono>
#include <memory>

namespace pcl {
namespace sedr {

/** @brief Returns why voxels are too large for the grid, a sentence; empty if they are
 * not. */
std::string voxelProblem(double voxel_size, double grid_size);

/** @brief Returns the step k of the excerpt, which holds every k-th point of the
 * scan. */
std::size_t excerptStep(std::size_t points);

/** @brief Collects every k-th point of a scan.
 * @return why the scan is invalid, a sentence; empty if valid */
std::string readExcerpt(const RowSource& source,
                        unsigned threads,
                        std::vector<Eigen::Vector3f>& excerpt);

/** @brief Returns the coordinates of a scan in another frame, see MovedRows. */
std::unique_ptr<const RowSource>
movedRows(const RowSource& source, const BuildingFrame& frame, unsigned threads);

/** @brief Moves an excerpt and scanner positions to another frame. */
void moveScan(const BuildingFrame& frame,
              unsigned threads,
              std::vector<Eigen::Vector3f>& excerpt,
              ScanPositions& positions);

} // namespace sedr

template <typename PointT>
IndoorStructureReconstruction<PointT>::IndoorStructureReconstruction()
{
  voxel_grid_.setDownsampleAllData(false);
  voxel_grid_.setRemoveStrays(true);
  setNumberOfThreads(threads_);
}

template <typename PointT>
IndoorStructureReconstruction<PointT>::~IndoorStructureReconstruction() = default;

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
bool
IndoorStructureReconstruction<PointT>::refuseInput(const std::string& problem)
{
  chain_.failed_stage = "input";
  return fail("IndoorStructureReconstruction", "input: " + problem);
}

/** @brief Returns the input source, or the points of the input cloud as one. */
template <typename PointT>
std::shared_ptr<const sedr::RowSource>
IndoorStructureReconstruction<PointT>::sourceOf(PointCloud& chosen) const
{
  if (source_)
    return source_;
  if (this->fake_indices_)
    return std::make_shared<sedr::CloudRows<PointT>>(*input_);
  pcl::copyPointCloud(*input_, *indices_, chosen);
  return std::make_shared<sedr::CloudRows<PointT>>(chosen);
}

template <typename PointT>
std::optional<sedr::BuildingFrame>
IndoorStructureReconstruction<PointT>::findFrame(
    const std::vector<Eigen::Vector3f>& excerpt)
{
  ParallelVoxelGrid<PointXYZ> grid;
  grid.setLeafSize(getVoxelSize(), getVoxelSize(), getVoxelSize());
  grid.setRemoveStrays(voxel_grid_.getRemoveStrays());
  grid.setNumberOfThreads(threads_);
  sedr::StructureChain::Cloud::Ptr cloud(new sedr::StructureChain::Cloud);
  cloud->resize(excerpt.size());
  for (std::size_t i = 0; i < excerpt.size(); ++i)
    (*cloud)[i].getVector3fMap() = excerpt[i];
  grid.setInputCloud(cloud);
  sedr::StructureChain::Cloud::Ptr sample(new sedr::StructureChain::Cloud);
  grid.filter(*sample);
  if (!chain_.findFrame(sample, positions_))
    return {};
  return chain_.frame;
}

template <typename PointT>
sedr::ThinnedScan
IndoorStructureReconstruction<PointT>::thinHere(const sedr::FindFrame& find_frame)
{
  PointCloud chosen;
  PointCloud means;
  const auto source = sourceOf(chosen);
  sedr::ThinnedScan scan;
  scan.size = source->size();
  scan.problem = sedr::readExcerpt(*source, threads_, *scan.excerpt);
  if (!scan.problem.empty())
    return scan;
  const auto frame = find_frame(*scan.excerpt);
  if (!frame)
    return scan;
  voxel_grid_.filter(*sedr::movedRows(*source, *frame, threads_), means);
  pcl::copyPointCloud(means, *scan.points);
  scan.strays = voxel_grid_.getStrayPoints();
  return scan;
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::thin(sedr::ThinnedScan& scan)
{
  const auto start = std::chrono::steady_clock::now();
  std::string problem = sedr::voxelProblem(getVoxelSize(), getGridSize());
  if (problem.empty() && !source_ && !thinning_) {
    problem = sedr::indicesProblem(*indices_, input_->size());
    if (problem.empty() && !positions_.empty() && !this->fake_indices_)
      problem = "scan positions are of all points, but indices are set";
  }
  if (!problem.empty())
    return refuseInput(problem);
  if (chain_.on_stage)
    chain_.on_stage("ParallelVoxelGrid");
  const sedr::FindFrame find_frame = [this](const auto& excerpt) {
    return findFrame(excerpt);
  };
  scan = thinning_ ? thinning_(find_frame) : thinHere(find_frame);
  if (!scan.problem.empty())
    return refuseInput(scan.problem);
  if (!chain_.problem.empty())
    return fail("IndoorStructureReconstruction",
                chain_.failed_stage + ": " + chain_.problem);
  if (!thinning_ && !voxel_grid_.getErrorMessage().empty()) {
    chain_.failed_stage = "ParallelVoxelGrid";
    return fail("IndoorStructureReconstruction",
                "ParallelVoxelGrid: " + voxel_grid_.getErrorMessage());
  }
  chain_.stray_share = static_cast<double>(scan.strays) /
                       static_cast<double>(std::max<std::size_t>(scan.size, 1));
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - start;
  reports_.push_back(
      {"ParallelVoxelGrid", scan.size, scan.points->size(), seconds.count()});
  return true;
}

template <typename PointT>
void
IndoorStructureReconstruction<PointT>::leaveOutMirrored(sedr::ThinnedScan& scan)
{
  sedr::ScanPositions positions = positions_;
  sedr::moveScan(chain_.frame, threads_, *scan.excerpt, positions);
  if (positions.empty())
    return;
  const auto start = std::chrono::steady_clock::now();
  if (chain_.on_stage)
    chain_.on_stage("MirroredPoints");
  const std::size_t before = scan.points->size();
  chain_.leaveOutMirrored(positions, sedr::excerptStep(scan.size), *scan.points,
                          *scan.excerpt);
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - start;
  reports_.push_back({"MirroredPoints", before, scan.points->size(), seconds.count()});
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::findStructure()
{
  constexpr const char* name = "IndoorStructureReconstruction";
  this->clearError();
  mesh_ = sedr::TriangleMesh();
  reports_.clear();
  sedr::ThinnedScan scan;
  chain_.reset(scan.points);
  const bool has_cloud = !source_ && !thinning_;
  if (has_cloud && !this->initCompute()) {
    chain_.failed_stage = "input";
    return fail(name, "no input cloud was set");
  }
  chain_.mirrored = sedr::MirrorFigures();
  bool is_done = thin(scan);
  if (is_done) {
    leaveOutMirrored(scan);
    chain_.floorplan_fitting.setRawPoints(scan.excerpt);
    is_done = chain_.findStructure(scan.points);
    reports_.insert(reports_.end(), chain_.reports.begin(), chain_.reports.end());
    if (!is_done)
      fail(name, chain_.failed_stage + ": " + chain_.problem);
  }
  chain_.floorplan_fitting.setRawPoints(nullptr);
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
