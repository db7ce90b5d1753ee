// SPDX-License-Identifier: BSD-3-Clause
#include "plan_tilts.h"

#include "bytes/mapped_file.h"
#include "tool_error.h"

namespace pcl {
namespace sedr {
namespace tools {

WallTilts
planTilts(const std::string& path)
{
  const MappedFile file(path);
  const std::string text(reinterpret_cast<const char*>(file.data()), file.size());
  std::string problem;
  WallTilts tilts = tiltsFromJson(text, problem);
  if (!problem.empty())
    throw ToolError("'" + path + "': " + problem);
  return tilts;
}

} // namespace tools
} // namespace sedr
} // namespace pcl
