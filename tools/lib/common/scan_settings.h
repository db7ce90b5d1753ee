// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/scan_frame.h>

#include <cstddef>
#include <optional>
#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief How a scan is read. */
struct ScanSettings {
  double unit = 1;              ///< metres that one unit of the file stands for
  std::optional<Origin> origin; ///< to count coordinates from; none: found by itself
  bool shifts = true;           ///< whether an origin is subtracted if none is given
  std::size_t scan = 0;         ///< number, from 1, of the scan of an E57 file; 0: all
  bool skip_broken = false;     ///< leave out scans of an E57 file that cannot be read
  std::string positions;        ///< file of scanner positions; empty: as the scan says
  std::string columns;          ///< names of the columns of a text; empty: as it says
  std::size_t piece_bytes = std::size_t{1} << 23; ///< about how much makes a piece
};

} // namespace tools
} // namespace sedr
} // namespace pcl
