// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "las_header.h"
#include "point_reader.h"

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The points of a LAS file: x, y, z, `intensity`, and `rgb` where the format
 * has colours; what else a record holds is skipped. Colours of 16 bits become 8, unless
 * all that are looked at are below 256, as some programs write them. */
class LasReader : public PointReader {
public:
  LasReader(const MappedFile& file, const std::string& path);

  const std::vector<pcl::PCLPointField>& fields() const override { return fields_; }
  std::size_t size() const override { return static_cast<std::size_t>(header_.points); }
  void read(std::size_t first, std::size_t size, std::uint8_t* rows) const override;
  std::size_t placeOf(std::size_t row) const override
  {
    return static_cast<std::size_t>(header_.begin) + row * header_.record;
  }

private:
  bool hasWideColours() const;

  const MappedFile& file_;
  LasHeader header_;
  std::vector<pcl::PCLPointField> fields_;
  unsigned colour_shift_ = 0; ///< bits
};

} // namespace tools
} // namespace sedr
} // namespace pcl
