// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <utility>

namespace pcl {

namespace {

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

} // namespace

bool
ParallelVoxelGrid<pcl::PCLPointCloud2>::thinInto(PCLPointCloud2& output,
                                                 const sedr::RowSource& source,
                                                 const pcl::Indices* indices)
{
  clearError();
  removed_indices_->clear();
  PCLPointCloud2 thinned;
  thinned.fields = source.fields();
  thinned.point_step = static_cast<pcl::uindex_t>(source.rowSize());
  thinned.height = 1;
  thinned.is_dense = true;
  const auto make = [&](std::size_t n) {
    thinned.width = static_cast<std::uint32_t>(n);
    thinned.row_step = thinned.width * thinned.point_step;
    thinned.data.resize(n * thinned.point_step);
    return thinned.data.data();
  };
  const std::string problem =
      thin(source, indices, {thinned.fields, source.rowSize(), make},
           extract_removed_indices_ ? removed_indices_.get() : nullptr);
  output = std::move(thinned);
  return problem.empty() || fail("ParallelVoxelGrid", problem);
}

void
ParallelVoxelGrid<pcl::PCLPointCloud2>::filter(PCLPointCloud2& output)
{
  if (input_ && BlobRows(*input_).problem().empty()) {
    Filter<pcl::PCLPointCloud2>::filter(output);
    return;
  }
  clearError();
  clearLayout();
  removed_indices_->clear();
  output = PCLPointCloud2();
  fail("ParallelVoxelGrid",
       input_ ? BlobRows(*input_).problem() : std::string("no input cloud was set"));
}

void
ParallelVoxelGrid<pcl::PCLPointCloud2>::filter(const sedr::RowSource& source,
                                               PCLPointCloud2& output)
{
  thinInto(output, source, nullptr);
}

void
ParallelVoxelGrid<pcl::PCLPointCloud2>::applyFilter(PCLPointCloud2& output)
{
  const BlobRows rows(*input_);
  const bool is_done = thinInto(output, rows, fake_indices_ ? nullptr : indices_.get());
  output.is_bigendian = input_->is_bigendian;
  if (!is_done && extract_removed_indices_)
    *removed_indices_ = sedr::indicesInRange(*indices_, rows.size());
}

} // namespace pcl
