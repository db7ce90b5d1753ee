// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_streams.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Where the values of a point stand in a row; x, y and z, doubles, at 0. */
struct E57Row {
  std::size_t size = 0;
  std::size_t intensity = 0; ///< 0: none
  std::size_t colour = 0;    ///< 0: none
};

/** @brief The points of a scan of an E57 file, moved by its pose. Throws ToolError with
 * a reason if they cannot be read. */
class E57Points {
public:
  /** @param first_row number of its first point in the whole file */
  E57Points(const E57Pages& pages, const E57Scan& scan, std::size_t first_row);

  const E57Scan& head() const { return scan_; }
  const E57Streams& streams() const { return streams_; }
  std::size_t begin() const { return first_row_; }
  std::size_t end() const { return first_row_ + scan_.points; }
  bool hasIntensity() const { return fields_[Intensity] >= 0; }
  bool hasColour() const { return fields_[Blue] >= 0; }

  /** @brief Decodes `size` points from `first` on into rows; what the scan does not
   * have stays as it is. */
  void read(std::size_t first,
            std::size_t size,
            const E57Row& row,
            std::uint8_t* rows) const;

private:
  /** @brief What is read: x, y and z, or range, azimuth and elevation; the others if
   * the scan has them. */
  enum Role : std::size_t { X, Y, Z, Invalid, Intensity, Blue, Green, Red };

  /** @brief Returns the number of each role's field, -1 for none. */
  static std::vector<int> fieldsOf(const E57Scan& scan);

  void placePoints(const std::vector<E57Values>& values,
                   std::size_t first,
                   std::size_t n,
                   std::size_t row_size,
                   std::uint8_t* rows) const;
  void placeColours(const std::vector<E57Values>& values,
                    std::size_t first,
                    std::size_t n,
                    std::size_t row_size,
                    std::uint8_t* rows) const;

  E57Scan scan_;
  std::size_t first_row_;
  std::vector<int> fields_;
  E57Streams streams_;
};

} // namespace pcl::sedr::tools
