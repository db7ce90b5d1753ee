// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_points.h"
#include "formats/point_reader.h"
#include "formats/scan_formats.h"

#include <memory>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief The points of the scans of an E57 file (ASTM E2807-11), in sequence, see
 * openE57(). Coordinates are Cartesian, or else spherical: floats of single or double
 * precision, integers or scaled integers of 0 to 64 bits. Throws ToolError that names
 * the scan. */
class E57Reader : public PointReader {
public:
  E57Reader(const InputFilePtr& file, const ScanSettings& settings);

  std::vector<ScanStation> stations() const override;

protected:
  void read(Chunk& chunk) const override;

private:
  void open(const E57Entry& entry, bool skip_broken);
  void layRow();

  std::string path_;
  std::unique_ptr<const E57Pages> pages_;
  std::vector<std::unique_ptr<const E57Points>> scans_; ///< scans with points
  E57Row places_;
};

/** @brief Lists the scans of an E57 file, including those that cannot be read. */
std::vector<E57Entry> listE57Scans(const std::string& path);

} // namespace pcl::sedr::tools
