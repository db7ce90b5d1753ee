// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

// A row is a point of a pcl::PCLPointCloud2 with all fields. Blobs here have height 1
// and no padding, as from loadCloud().

inline std::size_t
rowsOf(const pcl::PCLPointCloud2& blob)
{
  return std::size_t{blob.width} * blob.height;
}

/** @brief Returns the field called `name`, null if there is none. */
const pcl::PCLPointField* findField(const pcl::PCLPointCloud2& blob,
                                    const std::string& name);

/** @brief Returns the rows `indices` of `blob`, in that order. */
pcl::PCLPointCloud2 selectRows(const pcl::PCLPointCloud2& blob,
                               const pcl::Indices& indices);

/** @brief Appends `count` rows of zeros. */
void appendZeroRows(pcl::PCLPointCloud2& blob, std::size_t count);

/** @brief Writes `points`, metres, as x, y and z to the rows from `first_row` on. */
void setCoordinates(pcl::PCLPointCloud2& blob,
                    std::size_t first_row,
                    const std::vector<Eigen::Vector3f>& points);

/** @brief Sets field `name` of all rows as UINT32; adds it or replaces a field of
 * another type. `values` has one entry per row. */
void setField(pcl::PCLPointCloud2& blob,
              const std::string& name,
              const std::vector<std::uint32_t>& values);

/** @brief As above for FLOAT32, e.g. normal_x. */
void setField(pcl::PCLPointCloud2& blob,
              const std::string& name,
              const std::vector<float>& values);

/** @brief Returns the first value of field `name` of every row as an integer; 0 for NaN
 * and negative values. Empty if there is no such field. */
std::vector<std::uint32_t> wholeField(const pcl::PCLPointCloud2& blob,
                                      const std::string& name);

/** @brief Returns the first value of field `name` of every row; empty if there is no
 * such field. */
std::vector<float> floatField(const pcl::PCLPointCloud2& blob, const std::string& name);

} // namespace pcl::sedr::tools
