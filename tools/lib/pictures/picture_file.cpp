// SPDX-License-Identifier: BSD-3-Clause
#include "picture_file.h"

#include "scan_file.h"
#include "stage_pictures.h"

namespace pcl::sedr::tools {

void
PictureFile::check() const
{
  if (!path.empty())
    checkOutput(path, "a picture", {".png"});
}

void
StageFiles::declare(Options& options, const std::string& help, std::string* plan)
{
  options.file("INPUT", input, "PCD or PLY file" + help);
  if (plan)
    options.file("PLAN.json", *plan,
                 "floor plan, as pcl_floorplan_fitting and pcl_sedr write it");
  options.file("OUTPUT", output, "PCD or PLY file to write");
  picture.declare(options);
}

void
StageFiles::check() const
{
  checkCloudOutput(output);
  picture.check();
}

void
StageFiles::save(const ToolCloud& cloud, const ScanSettings& reading) const
{
  CellChanges changes;
  if (!picture.path.empty()) // first, as the output may be the input
    countLabels(ScanFile(input, reading), 0, changes);
  saveCloud(output, cloud);
  picture.write([&] {
    countLabels(ScanFile(output), 1, changes);
    return drawLabels(changes);
  });
}

} // namespace pcl::sedr::tools
