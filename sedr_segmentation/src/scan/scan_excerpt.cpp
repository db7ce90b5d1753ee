// SPDX-License-Identifier: BSD-3-Clause
#include "scan_excerpt.h"
#include "sedr_filters/src/base/parallel_for.h"

namespace pcl::sedr {

void
addToExcerpt(const PointView& points,
             std::size_t first,
             std::size_t step,
             std::vector<Eigen::Vector3f>& excerpt)
{
  for (std::size_t k = (first + step - 1) / step * step; k < first + points.size();
       k += step)
    excerpt.push_back(points[k - first]);
}

void
movePoints(const BuildingFrame& frame,
           const PointView& points,
           unsigned threads,
           Eigen::Vector3f* moved)
{
  parallelFor(points.size(), points_a_block, threads, [&](std::size_t i) {
    moved[i] = frame.toBuilding(points[i].cast<double>()).cast<float>();
  });
}

MovedRows::MovedRows(const RowSource& scan,
                     const BuildingFrame& frame,
                     unsigned threads)
    : scan_(scan)
    , frame_(frame)
    , threads_(threads)
{
  for (const char* name : {"x", "y", "z"}) {
    pcl::PCLPointField field;
    field.name = name;
    field.offset = static_cast<std::uint32_t>(fields_.size() * sizeof(float));
    field.datatype = pcl::PCLPointField::FLOAT32;
    field.count = 1;
    fields_.push_back(field);
  }
}

void
MovedRows::forEachPiece(const std::function<bool(const Piece&)>& see) const
{
  RowCoordinates coordinates(scan_.fields(), scan_.rowSize());
  std::vector<Eigen::Vector3f> moved;
  scan_.forEachPiece([&](const Piece& piece) {
    moved.resize(piece.size);
    movePoints(frame_, coordinates.of(piece.rows, piece.size, threads_), threads_,
               moved.data());
    return see(
        {reinterpret_cast<const std::uint8_t*>(moved.data()), piece.first, piece.size});
  });
}

} // namespace pcl::sedr
