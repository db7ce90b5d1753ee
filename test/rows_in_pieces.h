// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/conversions.h>
#include <pcl/sedr_filters/point_view.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace sedr_test {

/** A cloud as a source of rows, read in pieces of so many. */
class RowsInPieces : public pcl::sedr::RowSource {
public:
  explicit RowsInPieces(pcl::PCLPointCloud2 blob, std::size_t piece = 1U << 30)
      : blob_(std::move(blob))
      , piece_(piece)
  {}

  template <typename PointT>
  explicit RowsInPieces(const pcl::PointCloud<PointT>& cloud,
                        std::size_t piece = 1U << 30)
      : piece_(piece)
  {
    pcl::toPCLPointCloud2(cloud, blob_);
  }

  const std::vector<pcl::PCLPointField>& fields() const override
  {
    return blob_.fields;
  }
  std::size_t rowSize() const override { return blob_.point_step; }
  std::size_t size() const override { return blob_.width; }

  void forEachPiece(const std::function<bool(const Piece&)>& see) const override
  {
    for (std::size_t first = 0; first < size(); first += piece_)
      if (!see({&blob_.data[first * rowSize()], first,
                std::min(piece_, size() - first)}))
        return;
  }

private:
  pcl::PCLPointCloud2 blob_;
  std::size_t piece_;
};

} // namespace sedr_test
