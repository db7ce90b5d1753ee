// SPDX-License-Identifier: BSD-3-Clause
#include "drawing_files.h"

#include "sedr_filters/src/base/parallel.h"
#include "solid_files.h"

#include <algorithm>

namespace pcl::sedr::tools {

const std::vector<std::string> drawing_names{"floorplan.svg", "floorplan.pdf",
                                             "floorplan.dxf"};

void
writeDrawings(OutputFolder& folder,
              const Floorplan& plan,
              const std::string& input,
              const DrawingSettings& settings,
              unsigned threads)
{
  std::vector<std::string> old =
      folder.filesLike("floorplan(_[0-9]+)?\\.(svg|pdf|dxf)");
  std::vector<DrawingSheet> sheets;
  for (const std::string& name : drawing_names)
    for (const DrawingSheet& sheet : drawingSheets(name, plan)) {
      folder.add({sheet.path});
      sheets.push_back({folder.file(sheet.path), sheet.storey});
      old.erase(std::remove(old.begin(), old.end(), sheet.path), old.end());
    }
  parallelBlocks(sheets.size(), 1, threads, [&](std::size_t k, std::size_t) {
    saveDrawing(sheets[k], plan, settings);
  });
  folder.remove(old, input);
}

} // namespace pcl::sedr::tools
