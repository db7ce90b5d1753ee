// SPDX-License-Identifier: BSD-3-Clause
#include "joint_scan.h"
#include "model/model_run.h"
#include "run_tool.h"

#include <memory>

using namespace pcl::sedr::tools;

int
main(int argc, char** argv)
{
  Reconstruction chain;
  ModelSettings settings;
  Options options(
      "pcl_sedr",
      "Reconstructs ceiling, floor and walls of an indoor scan as one closed mesh a "
      "room.\nWrites structure.pcd, mesh.ply, solid.ply, .obj, model.glb, .ifc, "
      "floorplan.json, .svg, .pdf, .dxf, report.json and schedules (rooms.csv, "
      "openings.csv, walls.csv); of several storeys one drawing each, "
      "floorplan_1.svg, ...");
  options.files(
      "INPUT", settings.inputs,
      "PCD, PLY, E57, LAS or text, z up, or a folder of them; several are one "
      "scan; - is the standard input");
  options.file("OUTPUT_DIR", settings.folder,
               "folder for the results, made if missing");
  addModelOptions(options, settings, chain);
  options.flag("pictures", settings.pictures,
               "write pictures of the rooms and the fitted plan to "
               "OUTPUT_DIR/pictures");
  return runTool(options, argc, argv, [&] {
    apply(settings, chain);
    return makeModel(settings, chain, [&] {
      // Everything but the headers is read during thinning.
      const auto scan =
          std::make_shared<JointScan>(settings.inputs, settings.scan.resolved());
      chain.setInputSource(scan);
      chain.setOrigin(scan->origin());
      chain.setScanPositions(scan->positions());
      return scan->size();
    });
  });
}
