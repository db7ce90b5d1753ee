// SPDX-License-Identifier: BSD-3-Clause
#include "drawing_files.h"

#include "solid_files.h"

#include <algorithm>

namespace pcl {
namespace sedr {
namespace tools {

const std::vector<std::string> drawing_names{"floorplan.svg", "floorplan.dxf"};

void
writeDrawings(OutputFolder& folder,
              const Floorplan& plan,
              const std::string& input,
              const Origin& origin)
{
  std::vector<std::string> old = folder.filesLike("floorplan(_[0-9]+)?\\.(svg|dxf)");
  for (const std::string& name : drawing_names)
    for (const DrawingSheet& sheet : drawingSheets(name, plan)) {
      folder.add({sheet.path});
      saveDrawing({folder.file(sheet.path), sheet.storey}, plan, 0, origin);
      old.erase(std::remove(old.begin(), old.end(), sheet.path), old.end());
    }
  folder.remove(old, input);
}

} // namespace tools
} // namespace sedr
} // namespace pcl
