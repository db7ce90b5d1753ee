// SPDX-License-Identifier: BSD-3-Clause
#include "model/model_run.h"
#include "run_tool.h"
#include "scan_file.h"

#include <memory>

using namespace pcl::sedr::tools;

int
main(int argc, char** argv)
{
  Reconstruction chain;
  ModelSettings settings(chain);
  Options options(
      "pcl_sedr",
      "Reconstructs ceiling, floor and walls of an indoor scan as one closed mesh a "
      "room.\nWrites structure.pcd, mesh.ply, solid.ply, solid.obj, floorplan.json, "
      "floorplan.svg, .pdf, .dxf and report.json; of several storeys one drawing "
      "each, floorplan_1.svg, ...");
  options.file("INPUT", settings.input,
               "PCD, PLY, E57, LAS or text, z up; - is the standard input");
  options.file("OUTPUT_DIR", settings.folder,
               "folder for the results, made if missing");
  addModelOptions(options, settings);
  options.flag("pictures", settings.pictures,
               "write a picture of what each stage decided to OUTPUT_DIR/pictures");
  return runTool(options, argc, argv, [&] {
    apply(settings, chain);
    settings.inputs = {settings.input};
    return makeModel(settings, chain, [&] {
      // What is not in its header is read while it is thinned.
      const auto scan =
          std::make_shared<ScanFile>(settings.input, settings.scan.resolved());
      chain.setInputSource(scan);
      chain.setOrigin(scan->origin());
      chain.setScanPositions(scan->positions());
      return scan->size();
    });
  });
}
