// SPDX-License-Identifier: BSD-3-Clause
#include "scan_excerpt.h"
#include "sedr_filters/src/base/field_access.h"
#include "sedr_filters/src/base/parallel.h"

#include <cstdint>
#include <cstring>

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

std::vector<Eigen::Vector3f>
excerptOf(const RowSource& scan, std::size_t most, unsigned threads)
{
  std::vector<Eigen::Vector3f> excerpt;
  RowCoordinates coordinates(scan.fields(), scan.rowSize());
  scan.forEachPiece([&](const RowSource::Piece& piece) {
    addToExcerpt(coordinates.of(piece.rows, piece.size, threads), piece.first,
                 rawStep(scan.size(), most), excerpt);
    return true;
  });
  return excerpt;
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
                     unsigned threads,
                     bool all_fields)
    : scan_(scan)
    , frame_(frame)
    , threads_(threads)
    , row_size_(all_fields ? scan.rowSize() : sizeof(Eigen::Vector3f))
{
  for (const char* name : {"x", "y", "z"}) {
    pcl::PCLPointField field = *findField(scan.fields(), name);
    std::size_t& offset = offsets_[fields_.size()];
    offset = all_fields ? field.offset : fields_.size() * sizeof(float);
    field.offset = static_cast<pcl::uindex_t>(offset);
    field.datatype = pcl::PCLPointField::FLOAT32;
    fields_.push_back(field);
  }
  if (all_fields)
    fields_ = scan.fields();
}

void
MovedRows::forEachPiece(const std::function<bool(const Piece&)>& see) const
{
  RowCoordinates coordinates(scan_.fields(), scan_.rowSize());
  const bool has_others = row_size_ > sizeof(Eigen::Vector3f);
  std::vector<Eigen::Vector3f> moved;
  std::vector<std::uint8_t> rows;
  scan_.forEachPiece([&](const Piece& piece) {
    moved.resize(piece.size);
    movePoints(frame_, coordinates.of(piece.rows, piece.size, threads_), threads_,
               moved.data());
    if (has_others) {
      rows.assign(piece.rows, piece.rows + piece.size * row_size_);
      for (std::size_t i = 0; i < piece.size; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
          std::memcpy(rows.data() + i * row_size_ + offsets_[axis],
                      &moved[i][static_cast<Eigen::Index>(axis)], sizeof(float));
    }
    return see(
        {has_others ? rows.data() : reinterpret_cast<const std::uint8_t*>(moved.data()),
         piece.first, piece.size});
  });
}

} // namespace pcl::sedr
