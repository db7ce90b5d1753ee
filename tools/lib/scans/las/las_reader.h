// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "las_header.h"
#include "las_rows.h"
#include "point_reader.h"

#include <memory>

namespace pcl::sedr::tools {

/** @brief The points of a LAS file, see LasRows; other parts of a record are
 * skipped. */
class LasReader : public PointReader {
public:
  LasReader(const MappedFile& file, const LasHeader& header);

  const std::vector<pcl::PCLPointField>& fields() const override
  {
    return rows_.fields();
  }
  std::size_t size() const override { return static_cast<std::size_t>(header_.points); }
  void read(std::size_t first, std::size_t size, std::uint8_t* rows) const override;
  std::size_t placeOf(std::size_t row) const override
  {
    return static_cast<std::size_t>(header_.begin) + row * header_.record;
  }

private:
  LasPoint pointIn(const std::uint8_t* record) const;

  const MappedFile& file_;
  LasHeader header_;
  LasRows rows_;
};

/** @brief Opens a LAS or LAZ file. Throws ToolError on failure. */
std::shared_ptr<const PointReader> openLas(const MappedFile& file,
                                           const std::string& path);

/** @brief Opens a LAZ file by LASzip. In a build without it, throws ToolError with
 * advice on converting the file to LAS. */
std::shared_ptr<const PointReader>
openLaz(const MappedFile& file, const std::string& path, const LasHeader& header);

} // namespace pcl::sedr::tools
