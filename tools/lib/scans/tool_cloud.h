// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_settings.h"

#include <pcl/PCLPointCloud2.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <array>
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

/** @brief A cloud in a tool: all fields, and those that every stage uses. */
struct ToolCloud {
  std::string path;
  pcl::PCLPointCloud2 blob; ///< every field of the file; x, y, z as FLOAT32 metres, no
                            ///< padding, height 1
  pcl::PointCloud<pcl::PointXYZ>::Ptr
      points; ///< x, y, z of the rows; carries the viewpoint
  std::vector<std::uint32_t>
      label; ///< StructureLabel per row, zeros if the file has none
  std::vector<std::uint32_t> room; ///< 0 none, zeros if the file has none
  Origin origin;                   ///< origin of the coordinates
  bool knows_viewpoint = false;    ///< whether `points` tell it, also if it is 0
  bool has_label = false;
  bool has_room = false;

  std::size_t size() const { return label.size(); }

  /** @brief Returns the rows with this label. */
  pcl::Indices withLabel(StructureLabel wanted) const;
};

/** @brief Reads a whole scan by ScanFile; throws ToolError on failure. */
ToolCloud loadCloud(const std::string& path, const ScanSettings& settings = {});

/** @brief Throws ToolError if `path` cannot be written, see checkWritable(), or does
 * not end in .pcd or .ply. To be called before the work. */
void checkCloudOutput(const std::string& path);

/** @brief Writes `cloud.blob` completely or not at all: PCD, or binary PLY if `path`
 * ends in .ply. `label` and `room` of the ToolCloud are ignored: see setField(). Throws
 * ToolError on failure. */
void saveCloud(const std::string& path, const ToolCloud& cloud);

/** @brief Writes a structure as a binary PCD, completely or not at all, piece by piece
 * to avoid a second copy. Throws ToolError on failure.
 * @param colours of the points, blue, green, red, 255, and 1 where it was seen: fields
 * `rgb` and `seen`; empty: none */
void saveStructure(const std::string& path,
                   const pcl::PointCloud<pcl::PointStructure>& structure,
                   const Origin& origin = {},
                   const std::vector<std::array<std::uint8_t, 5>>& colours = {});

class ScanFile;

/** @brief Warns once per file that scanner positions are not written, if there are
 * several. */
void warnOfPositions(const ScanFile& scan);

/** @brief Writes rows while reading them, piece by piece: binary PCD, or PLY if `path`
 * ends in .ply.
 * @param scan whose frame they are in */
void saveScan(const std::string& path, const RowSource& rows, const ScanFile& scan);

} // namespace pcl::sedr::tools
