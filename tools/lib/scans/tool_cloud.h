// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_rows.h"
#include "scan_settings.h"

#include <pcl/sedr_filters/point_types.h>

#include <Eigen/Geometry>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief A cloud as a tool holds it: all fields, and what every stage reads of them.
 */
struct ToolCloud {
  std::string path;
  pcl::PCLPointCloud2 blob; ///< every field of the file; x, y, z as FLOAT32 metres, no
                            ///< padding, height 1
  pcl::PointCloud<pcl::PointXYZ>::Ptr
      points; ///< x, y, z of the rows; carries the viewpoint
  std::vector<std::uint32_t>
      label; ///< a StructureLabel a row, zeros if the file has none
  std::vector<std::uint32_t> room; ///< 0 none, zeros if the file has none
  Origin origin;                   ///< what coordinates are counted from
  bool has_label = false;
  bool has_room = false;

  std::size_t size() const { return label.size(); }

  /** @brief The rows with this label. */
  pcl::Indices withLabel(StructureLabel wanted) const;
};

/** @brief Reads all of a scan as ScanFile does; what is amiss is a ToolError of one
 * sentence. */
ToolCloud loadCloud(const std::string& path, const ScanSettings& settings = {});

/** @param unit metres that one unit of the file stands for */
ToolCloud loadCloud(const std::string& path, double unit);

enum class PcdData { Binary, Compressed };

/** @brief Throws a ToolError if no cloud can be written to `path`: see checkWritable();
 * the name must end in .pcd or .ply. To be asked before the work. */
void checkCloudOutput(const std::string& path);

/** @brief Writes `cloud.blob` whole or not at all: PCD, or binary PLY if `path` ends in
 * .ply. What fails is a ToolError. `label` and `room` of the ToolCloud are not looked
 * at: see setField(). */
void saveCloud(const std::string& path,
               const ToolCloud& cloud,
               PcdData data = PcdData::Binary);

/** @brief The same for a blob alone, seen from the origin. */
void saveCloud(const std::string& path,
               const pcl::PCLPointCloud2& blob,
               PcdData data = PcdData::Binary);

/** @brief Writes a structure as a binary PCD, whole or not at all, piece by piece: no
 * second copy of it is needed. What fails is a ToolError. */
void saveStructure(const std::string& path,
                   const pcl::PointCloud<pcl::PointStructure>& structure,
                   const Origin& origin = {});

class ScanFile;

/** @brief Writes a scan as it is read, piece by piece: binary PCD, or PLY if `path`
 * ends in .ply. */
void saveScan(const std::string& path, const ScanFile& scan);

} // namespace tools
} // namespace sedr
} // namespace pcl
