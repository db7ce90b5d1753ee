// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/number_text.h"
#include "sedr_segmentation/src/adjust/plan_adjustment.h"
#include "sedr_segmentation/src/scan/scan_check.h"
#include "sedr_segmentation/src/scan/scan_excerpt.h"
#include <pcl/sedr_surface/impl/indoor_structure_reconstruction.hpp>

#include <pcl/impl/instantiate.hpp>

namespace pcl::sedr {

std::string
voxelProblem(double voxel_size, double grid_size)
{
  if (voxel_size <= 1.001 * grid_size)
    return {};
  return "the voxel size " + numberText(voxel_size) +
         " m must not be above the grid size " + numberText(grid_size) +
         " m, or cells stay empty";
}

std::size_t
excerptStep(std::size_t points)
{
  return rawStep(points, AdjustmentParameters().max_points);
}

std::string
readExcerpt(const RowSource& source,
            unsigned threads,
            std::vector<Eigen::Vector3f>& excerpt)
{
  if (!source.problem().empty())
    return source.problem();
  RowCoordinates coordinates(source.fields(), source.rowSize());
  source.forEachPiece([&](const RowSource::Piece& piece) {
    addToExcerpt(coordinates.of(piece.rows, piece.size, threads), piece.first,
                 excerptStep(source.size()), excerpt);
    return true;
  });
  return scanProblem(PointView(excerpt.data(), sizeof excerpt[0], excerpt.size()));
}

std::unique_ptr<const RowSource>
movedRows(const RowSource& source, const BuildingFrame& frame, unsigned threads)
{
  return std::make_unique<MovedRows>(source, frame, threads);
}

void
moveScan(const BuildingFrame& frame,
         unsigned threads,
         std::vector<Eigen::Vector3f>& excerpt,
         ScanPositions& positions)
{
  movePoints(frame, PointView(excerpt.data(), sizeof excerpt[0], excerpt.size()),
             threads, excerpt.data());
  for (ScanPosition& position : positions)
    position.place = frame.toBuilding(position.place.cast<double>()).cast<float>();
}

} // namespace pcl::sedr

PCL_INSTANTIATE(IndoorStructureReconstruction, SEDR_POINT_TYPES)
