// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/scan_frame.h>

#include <cstddef>
#include <optional>
#include <string>

namespace pcl::sedr::tools {

/** @brief Settings for reading a scan. */
struct ScanSettings {
  std::optional<double> unit;   ///< metres per unit of the file; empty: 1
  std::string up;               ///< axis of the file that becomes z: x to -z; empty: z
  std::optional<Origin> origin; ///< of coordinates; empty: chosen automatically
  bool shifts = true;           ///< whether an origin is subtracted if none is given
  std::size_t scan = 0;     ///< number, from 1, of a scan within an E57 file; 0: all
  bool skip_broken = false; ///< skip scans of an E57 file that cannot be read
  std::string positions;    ///< file of scanner positions; empty: from the scan
  std::string columns;      ///< names of columns in a text file; empty: from the file
  std::size_t piece_bytes = std::size_t{1} << 23; ///< approximate size of a piece
};

} // namespace pcl::sedr::tools
