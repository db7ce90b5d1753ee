// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/parallel_voxel_grid.hpp>
#include <pcl/sedr_surface/impl/mesh_reconstruction.hpp>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <pcl/common/io.h>

#include <algorithm>
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
  setNumberOfThreads();
}

template <typename PointT>
IndoorStructureReconstruction<PointT>::~IndoorStructureReconstruction() = default;

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::fail()
{
  return sedr::StageError::fail("IndoorStructureReconstruction",
                                model_.failed_stage + ": " + model_.problem);
}

template <typename PointT>
std::string
IndoorStructureReconstruction<PointT>::settingsProblem() const
{
  std::string problem = sedr::voxelProblem(getVoxelSize(), getGridSize());
  if (!problem.empty() || source_ || thinning_)
    return problem;
  problem = sedr::indicesProblem(*indices_, input_->size());
  if (problem.empty() && !positions_.empty() && !this->fake_indices_)
    problem = "scan positions are of all points, but indices are set";
  return problem;
}

template <typename PointT>
std::optional<sedr::BuildingFrame>
IndoorStructureReconstruction<PointT>::findFrameOf(
    const std::vector<Eigen::Vector3f>& excerpt)
{
  ParallelVoxelGrid<PointXYZ> grid;
  grid.setLeafSize(getVoxelSize(), getVoxelSize(), getVoxelSize());
  grid.setRemoveStrays(voxel_grid_.getRemoveStrays());
  grid.setNumberOfThreads(getNumberOfThreads());
  Cloud::Ptr cloud(new Cloud);
  cloud->resize(excerpt.size());
  for (std::size_t i = 0; i < excerpt.size(); ++i)
    (*cloud)[i].getVector3fMap() = excerpt[i];
  grid.setInputCloud(cloud);
  Cloud::Ptr sample(new Cloud);
  grid.filter(*sample);
  if (!findFrame(sample, positions_))
    return {};
  return model_.frame;
}

template <typename PointT>
sedr::ThinnedScan
IndoorStructureReconstruction<PointT>::thinHere(const sedr::FindFrame& find_frame)
{
  std::shared_ptr<const sedr::RowSource> source = source_;
  PointCloud chosen;
  if (!source && !this->fake_indices_)
    pcl::copyPointCloud(*input_, *indices_, chosen);
  if (!source)
    source = std::make_shared<sedr::CloudRows<PointT>>(this->fake_indices_ ? *input_
                                                                           : chosen);
  sedr::ThinnedScan scan;
  scan.size = source->size();
  scan.problem = sedr::readExcerpt(*source, getNumberOfThreads(), *scan.excerpt);
  if (!scan.problem.empty())
    return scan;
  const auto frame = find_frame(*scan.excerpt);
  if (!frame)
    return scan;
  PointCloud means;
  voxel_grid_.filter(*sedr::movedRows(*source, *frame, getNumberOfThreads()), means);
  pcl::copyPointCloud(means, *scan.points);
  scan.strays = voxel_grid_.getStrayPoints();
  return scan;
}

template <typename PointT>
std::string
IndoorStructureReconstruction<PointT>::thin(sedr::ThinnedScan& scan,
                                            sedr::StageReport& report)
{
  const sedr::FindFrame find_frame = [this](const auto& excerpt) {
    return findFrameOf(excerpt);
  };
  scan = thinning_ ? thinning_(find_frame) : thinHere(find_frame);
  report.points_in = scan.size;
  report.points_out = scan.points->size();
  if (!scan.problem.empty())
    refuse(scan.problem);
  else if (!thinning_ && model_.problem.empty())
    return voxel_grid_.getErrorMessage();
  return {};
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::findStructure()
{
  this->clearError();
  mesh_ = sedr::TriangleMesh();
  reset();
  const bool has_cloud = !source_ && !thinning_;
  if (has_cloud && !this->initCompute())
    return refuse("no input cloud was set") || fail();
  const std::string wrong = settingsProblem();
  sedr::ThinnedScan scan;
  bool is_done = wrong.empty()
                     ? runStage("ParallelVoxelGrid", 0,
                                [&](auto& report) { return thin(scan, report); })
                     : refuse(wrong);
  if (is_done) {
    model_.stray_share = static_cast<double>(scan.strays) /
                         static_cast<double>(std::max<std::size_t>(scan.size, 1));
    sedr::ScanPositions positions = positions_;
    sedr::moveScan(model_.frame, getNumberOfThreads(), *scan.excerpt, positions);
    if (!positions.empty())
      is_done = runStage("MirroredPoints", scan.points->size(), [&](auto& report) {
        leaveOutMirrored(positions, sedr::excerptStep(scan.size), *scan.points,
                         *scan.excerpt);
        report.points_out = scan.points->size();
        return std::string();
      });
  }
  if (is_done) {
    stages_.floorplan_fitting.setRawPoints(scan.excerpt);
    is_done = StructureChain::findStructure(scan.points);
    stages_.floorplan_fitting.setRawPoints(nullptr);
  }
  if (has_cloud)
    this->deinitCompute();
  return is_done || fail();
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::makeMesh()
{
  return StructureChain::makeMesh() || fail();
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::run()
{
  if (!findStructure() || !makeMesh())
    return false;
  mesh_ = meshInScanFrame();
  return true;
}

} // namespace pcl

#define PCL_INSTANTIATE_IndoorStructureReconstruction(T)                               \
  template class PCL_EXPORTS pcl::IndoorStructureReconstruction<T>;
