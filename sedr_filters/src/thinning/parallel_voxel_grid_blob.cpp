// SPDX-License-Identifier: BSD-3-Clause
#include "field_means.h"

#include "../voxels/voxel_sums.h"

#include "../base/field_access.h"
#include "../voxels/voxel_visit.h"
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <array>
#include <cstring>
#include <utility>

namespace pcl {

namespace {

constexpr std::size_t voxels_at_once = 4096;

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

/** @brief A PCLPointCloud2 as a source of one piece. */
class BlobRows : public sedr::RowSource {
public:
  explicit BlobRows(const pcl::PCLPointCloud2& blob)
      : blob_(blob)
  {}

  const std::vector<pcl::PCLPointField>& fields() const override
  {
    return blob_.fields;
  }
  std::size_t rowSize() const override { return blob_.point_step; }
  std::size_t size() const override { return std::size_t{blob_.width} * blob_.height; }

  std::string problem() const override
  {
    if (blob_.data.size() >= size() * rowSize())
      return {};
    return "the cloud holds " + std::to_string(blob_.data.size()) + " bytes, " +
           std::to_string(size()) + " points of " + std::to_string(rowSize()) +
           " bytes need " + std::to_string(size() * rowSize());
  }

  void forEachPiece(const std::function<bool(const Piece&)>& see) const override
  {
    see({blob_.data.data(), 0, size()});
  }

private:
  const pcl::PCLPointCloud2& blob_;
};

/** @brief Normalises the normal at `point`, if there is one and it is not zero. */
void
normalise(const std::vector<pcl::PCLPointField>& fields, std::uint8_t* point)
{
  std::array<const pcl::PCLPointField*, 3> normal{sedr::findField(fields, "normal_x"),
                                                  sedr::findField(fields, "normal_y"),
                                                  sedr::findField(fields, "normal_z")};
  double square = 0;
  for (const auto* f : normal) {
    if (!f)
      return;
    const double value = sedr::readField(point + f->offset, f->datatype);
    square += value * value;
  }
  if (!(square > 0))
    return;
  for (const auto* f : normal)
    sedr::writeField(point + f->offset, f->datatype,
                     sedr::readField(point + f->offset, f->datatype) /
                         std::sqrt(square));
}

} // namespace

void
ParallelVoxelGrid<pcl::PCLPointCloud2>::filter(PCLPointCloud2& output)
{
  if (!input_) {
    clearError();
    fail("ParallelVoxelGrid", "no input cloud was set");
    clearLayout();
    removed_indices_->clear();
    output = PCLPointCloud2();
    return;
  }
  if (use_indices_ || extract_removed_indices_) {
    Filter<pcl::PCLPointCloud2>::filter(output);
    return;
  }
  // pcl::Filter would first create the indices of all points.
  PCLPointCloud2 thinned;
  thin(BlobRows(*input_), nullptr, thinned);
  thinned.header = input_->header;
  thinned.is_bigendian = input_->is_bigendian;
  output = std::move(thinned);
}

void
ParallelVoxelGrid<pcl::PCLPointCloud2>::filter(const sedr::RowSource& source,
                                               PCLPointCloud2& output)
{
  thin(source, nullptr, output);
}

void
ParallelVoxelGrid<pcl::PCLPointCloud2>::applyFilter(PCLPointCloud2& output)
{
  const BlobRows rows(*input_);
  const bool is_done = thin(rows, indices_.get(), output);
  output.is_bigendian = input_->is_bigendian;
  if (!is_done && extract_removed_indices_)
    *removed_indices_ = sedr::indicesInRange(*indices_, rows.size());
}

bool
ParallelVoxelGrid<pcl::PCLPointCloud2>::thin(const sedr::RowSource& source,
                                             const pcl::Indices* indices,
                                             PCLPointCloud2& output)
{
  using Piece = sedr::RowSource::Piece;
  clearError();
  clearLayout();
  removed_indices_->clear();
  output = PCLPointCloud2();
  output.fields = source.fields();
  output.point_step = static_cast<pcl::uindex_t>(source.rowSize());
  output.height = 1;
  output.is_dense = true;

  const unsigned threads = getNumberOfThreads();
  std::string problem = rowsProblem(source);
  if (problem.empty() && indices)
    problem = sedr::indicesProblem(*indices, source.size());
  if (!problem.empty())
    return fail("ParallelVoxelGrid", problem);
  sedr::VoxelSums sums(inverseLeaf());
  addRows(source, indices, sums);
  const std::size_t size = finish(sums);
  output.width = static_cast<std::uint32_t>(size);
  output.row_step = output.width * output.point_step;
  output.data.resize(size * output.point_step);
  writeMeans(sums, output);

  std::vector<pcl::PCLPointField> others;
  for (const auto& field : source.fields())
    if (field.name != "_" && !isSummed(field) &&
        (getDownsampleAllData() || isCoordinate(field)))
      others.push_back(field);
  if (!others.empty() || extract_removed_indices_) {
    const sedr::VoxelIndex index(sums.frame(), sums.take(threads));
    sedr::FieldMeans means(others, size);
    std::vector<bool> stays(extract_removed_indices_ ? source.size() : 0, false);
    forEachPiece(source, indices,
                 [&](const Piece& piece, const sedr::PointView& points,
                     const pcl::Indices* chosen) {
                   if (!others.empty())
                     sedr::visitVoxels(index, points, chosen, threads,
                                       [&](std::size_t voxel, std::size_t i) {
                                         means.add(voxel,
                                                   piece.rows + i * source.rowSize());
                                       });
                   if (chosen && extract_removed_indices_)
                     for (const auto i : *chosen)
                       stays[static_cast<std::size_t>(i)] =
                           index.find(points[static_cast<std::size_t>(i)]) >= 0;
                 });
    if (indices && extract_removed_indices_)
      for (const auto i : *indices)
        if (!stays[static_cast<std::size_t>(i)])
          removed_indices_->push_back(i);
    sedr::parallelFor(size, voxels_at_once, threads, [&](std::size_t v) {
      auto* to = output.data.data() + v * output.point_step;
      means.write(v, index.voxels()[v].count, to);
      if (getDownsampleAllData())
        normalise(output.fields, to);
    });
  }
  return true;
}

void
ParallelVoxelGrid<pcl::PCLPointCloud2>::writeMeans(const sedr::VoxelSums& sums,
                                                   PCLPointCloud2& output) const
{
  std::vector<std::pair<int, std::size_t>> summed; // axis and offset
  const std::array<const char*, 3> axes{"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const auto* field =
        sedr::findField(output.fields, axes[static_cast<std::size_t>(axis)]);
    if (isSummed(*field))
      summed.emplace_back(axis, field->offset);
  }
  sums.forEach(
      [&](const sedr::VoxelSum& voxel, std::size_t place) {
        const Eigen::Vector3f mean = sums.frame().mean(voxel);
        auto* to = output.data.data() + place * output.point_step;
        for (const auto& [axis, offset] : summed)
          std::memcpy(to + offset, &mean[axis], sizeof mean[axis]);
      },
      getNumberOfThreads());
}

} // namespace pcl
