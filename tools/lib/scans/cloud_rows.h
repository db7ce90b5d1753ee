// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

// A row is a point of a pcl::PCLPointCloud2 with all its fields. Blobs here have height
// 1 and no padding, as loadCloud() gives them.

inline std::size_t
rowsOf(const pcl::PCLPointCloud2& blob)
{
  return std::size_t{blob.width} * blob.height;
}

/** @brief The field called `name`, null if there is none. */
const pcl::PCLPointField* findField(const pcl::PCLPointCloud2& blob,
                                    const std::string& name);

/** @brief The rows `indices` of `blob`, in that order. */
pcl::PCLPointCloud2 selectRows(const pcl::PCLPointCloud2& blob,
                               const pcl::Indices& indices);

/** @brief Adds copies of the rows `indices` of `from`, which has the same fields, to
 * the end of `to`; `from` may be `to`. */
void appendRows(pcl::PCLPointCloud2& to,
                const pcl::PCLPointCloud2& from,
                const pcl::Indices& indices);

/** @brief Adds `count` rows of zeros to the end. */
void appendZeroRows(pcl::PCLPointCloud2& blob, std::size_t count);

/** @brief Writes `points`, metres, as x, y and z to the rows from `first_row` on. */
void setCoordinates(pcl::PCLPointCloud2& blob,
                    std::size_t first_row,
                    const std::vector<Eigen::Vector3f>& points);

/** @brief Sets field `name` of all rows, as UINT32: added, or put in the place of one
 * of another type. `values` are as many as rows. */
void setField(pcl::PCLPointCloud2& blob,
              const std::string& name,
              const std::vector<std::uint32_t>& values);

/** @brief The same as FLOAT32, say for normal_x. */
void setField(pcl::PCLPointCloud2& blob,
              const std::string& name,
              const std::vector<float>& values);

/** @brief The first value of field `name` of every row as a whole number: NaN and what
 * is below 0 give 0. Empty if there is no such field. */
std::vector<std::uint32_t> wholeField(const pcl::PCLPointCloud2& blob,
                                      const std::string& name);

/** @brief The first value of field `name` of every row; empty if there is no such
 * field. */
std::vector<float> floatField(const pcl::PCLPointCloud2& blob, const std::string& name);

/** @brief The coordinates of a cloud of any point type, for setCoordinates(). */
template <typename PointT>
std::vector<Eigen::Vector3f>
coordinatesOf(const pcl::PointCloud<PointT>& cloud)
{
  std::vector<Eigen::Vector3f> points;
  points.reserve(cloud.size());
  for (const auto& p : cloud)
    points.emplace_back(p.x, p.y, p.z);
  return points;
}

} // namespace tools
} // namespace sedr
} // namespace pcl
