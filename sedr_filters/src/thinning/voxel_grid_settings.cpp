// SPDX-License-Identifier: BSD-3-Clause
#include "../base/field_access.h"
#include "../voxels/voxel_sums.h"
#include "field_means.h"

#include <pcl/sedr_filters/stage_error.h>
#include <pcl/sedr_filters/voxel_grid_settings.h>

#include <algorithm>
#include <sstream>
#include <tuple>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr std::array<const char*, 3> axes{"x", "y", "z"};

/** @brief Compares voxels by z, then y, then x. */
bool
precedes(const Eigen::Vector3i& a, const Eigen::Vector3i& b)
{
  return std::make_tuple(a.z(), a.y(), a.x()) < std::make_tuple(b.z(), b.y(), b.x());
}

bool
isCoordinate(const pcl::PCLPointField& field)
{
  return field.name == "x" || field.name == "y" || field.name == "z";
}

/** @brief Checks whether the voxel sums contain the mean of a field. */
bool
isSummed(const pcl::PCLPointField& field)
{
  return isCoordinate(field) && field.datatype == pcl::PCLPointField::FLOAT32 &&
         field.count <= 1;
}

/** @brief Returns what is wrong with the fields of the rows; empty if nothing is. */
std::string
fieldsProblem(const RowSource& source)
{
  for (const char* name : axes)
    if (!findField(source.fields(), name))
      return std::string("the cloud has no field '") + name + "'";
  for (const auto& field : source.fields()) {
    const std::size_t end = field.offset + fieldSize(field.datatype) *
                                               std::max<std::size_t>(field.count, 1);
    if (field.name != "_" && end > source.rowSize())
      return "field '" + field.name + "' ends at byte " + std::to_string(end) +
             " of points of " + std::to_string(source.rowSize()) + " bytes";
  }
  return {};
}

/** @brief Writes the means of those of x, y and z that are FLOAT32. */
void
writePlaces(const VoxelSums& sums,
            const std::vector<pcl::PCLPointField>& fields,
            std::size_t row_size,
            std::uint8_t* rows,
            unsigned threads)
{
  std::array<const pcl::PCLPointField*, 3> summed{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    summed[axis] = findField(fields, axes[axis]);
  sums.forEach(
      [&](const VoxelSum& voxel, std::size_t place) {
        const Eigen::Vector3f mean = sums.frame().mean(voxel);
        for (std::size_t axis = 0; axis < 3; ++axis)
          if (isSummed(*summed[axis]))
            std::memcpy(rows + place * row_size + summed[axis]->offset,
                        &mean[static_cast<Eigen::Index>(axis)], sizeof(float));
      },
      threads);
}

} // namespace

Eigen::Vector3i
VoxelGridSettings::getGridCoordinates(float x, float y, float z) const
{
  return Eigen::Vector3i(VoxelFrame(inverseLeaf()).codes({x, y, z}).data());
}

int
VoxelGridSettings::getCentroidIndexAt(const Eigen::Vector3i& ijk) const
{
  const auto it = std::lower_bound(layout_.begin(), layout_.end(), ijk, precedes);
  return it != layout_.end() && *it == ijk ? static_cast<int>(it - layout_.begin())
                                           : -1;
}

void
VoxelGridSettings::clearLayout()
{
  stray_limit_ = 0;
  layout_.clear();
}

/** @brief Returns why the rows cannot be thinned, as a sentence; empty if they can. */
std::string
VoxelGridSettings::problemOf(const RowSource& source, const pcl::Indices* indices) const
{
  if (!((leaf_size_.array() > 0).all() && leaf_size_.allFinite() &&
        inverseLeaf().allFinite())) {
    std::ostringstream problem;
    problem << "the leaf must be above 0 m along x, y and z, it is " << leaf_size_.x()
            << " x " << leaf_size_.y() << " x " << leaf_size_.z() << " m";
    return problem.str();
  }
  if (!source.problem().empty())
    return source.problem();
  if (source.size() >
      static_cast<std::size_t>(std::numeric_limits<pcl::index_t>::max()))
    return "the cloud has " + std::to_string(source.size()) +
           " points, more than indices can count";
  const std::string problem = fieldsProblem(source);
  if (!problem.empty())
    return problem;
  return indices ? indicesProblem(*indices, source.size()) : std::string();
}

/** @brief Sorts the summed voxels, drops those with too few points, and saves the
 * layout if requested.
 * @return number of voxels kept */
std::size_t
VoxelGridSettings::finish(VoxelSums& sums)
{
  if (removes_strays_)
    stray_limit_ = sums.strayLimit();
  const std::size_t size =
      sums.arrange(std::max(min_points_per_voxel_, stray_limit_), threads_);
  if (save_leaf_layout_) {
    layout_.resize(size);
    sums.forEach(
        [&](const VoxelSum& voxel, std::size_t place) {
          layout_[place] = Eigen::Vector3i(voxel.code.data());
        },
        threads_);
  }
  return size;
}

std::string
VoxelGridSettings::thin(const RowSource& source,
                        const pcl::Indices* indices,
                        const ThinnedRows& output,
                        pcl::Indices* removed)
{
  using Piece = RowSource::Piece;
  clearLayout();
  const std::string problem = problemOf(source, indices);
  if (!problem.empty())
    return problem;
  VoxelSums sums(inverseLeaf());
  RowCoordinates coordinates(source.fields(), source.rowSize());
  source.forEachPiece([&](const Piece& piece) {
    sums.add(coordinates.of(piece.rows, piece.size, threads_), threads_, indices,
             indices ? RowSource::SeeRun() : piece.beside);
    return true;
  });
  const std::size_t size = finish(sums);
  std::uint8_t* const rows = output.make(size);
  writePlaces(sums, output.fields, output.row_size, rows, threads_);

  std::vector<pcl::PCLPointField> others;
  if (!output.only_places)
    for (const auto& field : source.fields())
      if (field.name != "_" && !isSummed(field) &&
          (downsample_all_data_ || isCoordinate(field)))
        others.push_back(field);
  if (others.empty() && !removed)
    return {};
  sums.index();
  FieldMeans means(others, size);
  std::vector<bool> stays(removed ? source.size() : 0, false);
  source.forEachPiece([&](const Piece& piece) {
    const PointView points = coordinates.of(piece.rows, piece.size, threads_);
    if (!others.empty())
      sums.visit(points, indices, threads_, [&](std::size_t voxel, std::size_t i) {
        means.add(voxel, piece.rows + i * source.rowSize());
      });
    for (std::size_t i = 0; removed && i < piece.size; ++i)
      stays[piece.first + i] = sums.find(points[i]) >= 0;
    return true;
  });
  sums.forEach(
      [&](const VoxelSum& voxel, std::size_t place) {
        means.write(place, voxel.count, rows + place * output.row_size);
      },
      threads_);
  for (std::size_t k = 0; removed && k < (indices ? indices->size() : stays.size());
       ++k)
    if (const auto i = indices ? (*indices)[k] : static_cast<pcl::index_t>(k);
        !stays[static_cast<std::size_t>(i)])
      removed->push_back(i);
  return {};
}

} // namespace pcl::sedr
