// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_packets.h"
#include "point_reader.h"

#include <memory>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Selection of scans in an E57 file. */
struct E57Choice {
  std::size_t scan = 0;     ///< number from 1; 0: all
  bool skip_broken = false; ///< leave out scans that cannot be read, with a warning
};

/** @brief The points of all scans of an E57 file (ASTM E2807-11), in sequence, each
 * transformed by its pose: x, y, z, then `intensity` and `rgb` if a scan has them.
 *
 * Coordinates are Cartesian, or else spherical: floats of single or double precision,
 * integers or scaled integers of 0 to 64 bits. Points marked as invalid, or as a
 * direction only, are NaN. Checksums are verified. Throws ToolError that names the
 * scan. */
class E57Reader : public PointReader {
public:
  E57Reader(const MappedFile& file, const std::string& path, const E57Choice& choice);
  ~E57Reader() override;

  const std::vector<pcl::PCLPointField>& fields() const override { return fields_; }
  std::size_t size() const override;
  void read(std::size_t first, std::size_t size, std::uint8_t* rows) const override;
  std::size_t placeOf(std::size_t row) const override;
  std::vector<ScanStation> stations() const override;

private:
  class Scan;

  void open(const E57Entry& entry, bool skip_broken);
  void layFields();

  const MappedFile& file_;
  std::string path_;
  E57Pages pages_;
  std::vector<std::unique_ptr<Scan>> scans_; ///< scans with points
  std::vector<pcl::PCLPointField> fields_;
};

/** @brief Lists the scans of an E57 file, including those that cannot be read. */
std::vector<E57Entry> listE57Scans(const std::string& path);

} // namespace pcl::sedr::tools
