// SPDX-License-Identifier: BSD-3-Clause
#include "../voxels/voxel_sums.h"

#include "../base/field_access.h"
#include <pcl/sedr_filters/voxel_grid_settings.h>

#include <algorithm>

namespace pcl::sedr {

std::string
VoxelGridSettings::rowsProblem(const RowSource& source) const
{
  if (!parameterProblem().empty())
    return parameterProblem();
  if (!source.problem().empty())
    return source.problem();
  if (source.size() >
      static_cast<std::size_t>(std::numeric_limits<pcl::index_t>::max()))
    return "the cloud has " + std::to_string(source.size()) +
           " points, more than indices can count";
  for (const char* name : {"x", "y", "z"})
    if (!findField(source.fields(), name))
      return std::string("the cloud has no field '") + name + "'";
  for (const auto& field : source.fields()) {
    const std::size_t end = field.offset + fieldSize(field.datatype) *
                                               std::max<std::size_t>(field.count, 1);
    if (field.name != "_" && end > source.rowSize())
      return "field '" + field.name + "' ends at byte " + std::to_string(end) +
             " of points of " + std::to_string(source.rowSize()) + " bytes";
  }
  if (!filter_field_name_.empty() && !findField(source.fields(), filter_field_name_))
    return "the points have no field '" + filter_field_name_ + "' to filter by";
  return {};
}

void
VoxelGridSettings::forEachPiece(
    const RowSource& source,
    const pcl::Indices* indices,
    const std::function<
        void(const RowSource::Piece&, const PointView&, const pcl::Indices*)>& see)
    const
{
  RowCoordinates coordinates(source.fields(), source.rowSize());
  const auto* limited = findField(source.fields(), filter_field_name_);
  source.forEachPiece([&](const RowSource::Piece& piece) {
    const PointView points = coordinates.of(piece.rows, piece.size, threads_);
    if (!limited) {
      see(piece, points, indices);
      return true;
    }
    pcl::Indices passing;
    const std::size_t n = indices ? indices->size() : piece.size;
    for (std::size_t k = 0; k < n; ++k) {
      const auto i = indices ? (*indices)[k] : static_cast<pcl::index_t>(k);
      const auto* row = piece.rows + static_cast<std::size_t>(i) * source.rowSize();
      if (passesLimits(readField(row + limited->offset, limited->datatype)))
        passing.push_back(i);
    }
    see(piece, points, &passing);
    return true;
  });
}

void
VoxelGridSettings::addRows(const RowSource& source,
                           const pcl::Indices* indices,
                           VoxelSums& sums) const
{
  forEachPiece(source, indices,
               [&](const RowSource::Piece& piece, const PointView& points,
                   const pcl::Indices* chosen) {
                 if (chosen)
                   sums.add(points, *chosen, threads_);
                 else
                   sums.add(points, threads_, piece.beside);
               });
}

} // namespace pcl::sedr
