// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_streams.h"
#include "formats/scan_formats.h"

#include <memory>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief The points of a scan of an E57 file, moved by its pose. Throws ToolError with
 * a reason if they cannot be read. */
struct E57Points {
  /** @brief What is read: x, y and z, or range, azimuth and elevation; the others if
   * the scan has them. */
  enum Role : std::size_t { X, Y, Z, Invalid, Intensity, Blue, Green, Red };

  /** @param first_row number of its first point in the whole file */
  E57Points(const E57Pages& pages, const E57Scan& scan, std::size_t first_row);

  bool has(Role role) const { return fields[role] >= 0; }

  /** @brief Decodes `size` points from `first` on into rows of a layout: x, y and z,
   * doubles, then others; what the scan does not have stays as it is. */
  void read(std::size_t first,
            std::size_t size,
            const StoredRow& row,
            std::uint8_t* rows) const;

  E57Scan scan;
  std::size_t begin;       ///< number of its first point in the whole file
  std::size_t end;         ///< number behind its last one
  std::vector<int> fields; ///< number of each role's field, -1: none
  E57Streams streams;
};

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

  std::string path_;
  std::unique_ptr<const E57Pages> pages_;
  std::vector<std::unique_ptr<const E57Points>> scans_; ///< scans with points
};

/** @brief Lists the scans of an E57 file, including those that cannot be read. */
std::vector<E57Entry> listE57Scans(const std::string& path);

} // namespace pcl::sedr::tools
