// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_settings.h"

namespace programs {

/** Returns settings that read a scan in pieces of about so many bytes. */
inline pcl::sedr::tools::ScanSettings
inPieces(std::size_t bytes, double unit = 1)
{
  pcl::sedr::tools::ScanSettings settings;
  settings.unit = unit;
  settings.piece_bytes = bytes;
  return settings;
}

/** Returns settings that read a scan of another unit, metres. */
inline pcl::sedr::tools::ScanSettings
inUnit(double unit)
{
  return inPieces(pcl::sedr::tools::ScanSettings().piece_bytes, unit);
}

} // namespace programs
