// SPDX-License-Identifier: BSD-3-Clause
#include "joint_scan.h"
#include "model/model_run.h"
#include "mpi/joint_work.h"
#include "run_tool.h"
#include "tool_error.h"

#include <boost/mpi/environment.hpp>

#include <cstdio>
#include <iostream>
#include <memory>

using namespace pcl::sedr::tools;

namespace {

/** @brief Makes the model: all ranks do the same on the thinned scan; rank 0 writes. */
int
makeModelTogether(const Ranks& ranks, ModelSettings& settings, Reconstruction& chain)
{
  if (settings.threads == 0)
    settings.threads = fairThreads(ranks);
  apply(settings, chain);
  chain.getStages().poisson.setRoomSharing(sharedRooms(ranks));
  std::unique_ptr<JointScan> scan;
  const auto open = [&] {
    together(ranks, [&] {
      scan = std::make_unique<JointScan>(settings.inputs, settings.scan.resolved());
      chain.setOrigin(scan->origin());
      chain.setScanPositions(scan->positions());
    });
    chain.setThinning([&](const pcl::sedr::FindFrame& find_frame) {
      return thinTogether(ranks, *scan, chain.getStages().voxel_grid, find_frame);
    });
    return scan->size();
  };
  if (ranks.rank() == 0)
    return makeModel(settings, chain, open);
  helpModel(settings, chain, open);
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  boost::mpi::environment environment(argc, argv, boost::mpi::threading::funneled);
  const Ranks ranks;
  if (ranks.rank() > 0) { // rank 0 tells what concerns all
    std::cout.setstate(std::ios::failbit);
    std::cerr.setstate(std::ios::failbit);
  }
  Reconstruction chain;
  ModelSettings settings;
  Options options(
      "pcl_sedr_mpi",
      "Reconstructs ceiling, floor and walls of an indoor scan as pcl_sedr does, with "
      "the same result, on several machines:\n"
      "mpirun -n 4 --hostfile hosts pcl_sedr_mpi SCAN OUTPUT_DIR\n"
      "Every machine needs the scan under the same name.");
  options.files(
      "SCAN", settings.inputs,
      "PCD, PLY, E57, LAS or text, z up, or a folder of them; several are one scan");
  options.file("OUTPUT_DIR", settings.folder,
               "folder for the results, made if missing");
  addModelOptions(options, settings, chain);
  bool has_begun = false;
  const int exit_code = runTool(options, argc, argv, [&] {
    has_begun = true;
    try {
      return makeModelTogether(ranks, settings, chain);
    }
    catch (const ToolError&) {
      throw; // the other ranks have failed as well, or rank 0 ends them
    }
    catch (const std::exception& error) {
      std::fprintf(stderr, "pcl_sedr_mpi: rank %d on '%s' failed: %s\n", ranks.rank(),
                   boost::mpi::environment::processor_name().c_str(), error.what());
      boost::mpi::environment::abort(BadUse);
      return static_cast<int>(BadUse);
    }
  });
  if (ranks.rank() > 0)
    return Done;
  if (has_begun && exit_code != Done)
    boost::mpi::environment::abort(exit_code); // others may be waiting
  return exit_code;
}
