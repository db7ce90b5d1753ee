// SPDX-License-Identifier: BSD-3-Clause
// Replaces laz_reader.cpp in builds without LASzip.
#include "las_reader.h"

#include "tool_error.h"

namespace pcl::sedr::tools {

std::shared_ptr<const PointReader>
openLaz(const MappedFile& /*file*/,
        const std::string& path,
        const LasHeader& /*header*/)
{
  throw ToolError("'" + path +
                  "' is LAZ, compressed LAS, which this build cannot read, as it was "
                  "made without LASzip: 'laszip -i SCAN.laz -o SCAN.las' or 'pdal "
                  "translate SCAN.laz SCAN.las' makes LAS of it");
}

} // namespace pcl::sedr::tools
