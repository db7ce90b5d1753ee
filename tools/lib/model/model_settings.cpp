// SPDX-License-Identifier: BSD-3-Clause
#include "model_settings.h"
#include "prior_values.h"

#include <iostream>

namespace pcl::sedr::tools {

void
addModelOptions(Options& options, ModelSettings& s, Reconstruction& chain)
{
  options.parameter("voxel-size", chain, &Reconstruction::getVoxelSize,
                    &Reconstruction::setVoxelSize, "m",
                    "edge of a voxel in down-sampling", Range::between(0.005, 1));
  options.parameter("plane-tolerance", chain, &Reconstruction::getPlaneTolerance,
                    &Reconstruction::setPlaneTolerance, "m",
                    "tolerance of the planes of ceiling and floor",
                    Range::between(0.001, 1));
  options.parameter("boundary-tolerance", chain, &Reconstruction::getBoundaryTolerance,
                    &Reconstruction::setBoundaryTolerance, "m",
                    "tolerance of the walls' lines and circles",
                    Range::between(0.001, 1));
  options.number("threads", s.threads, "", "threads, 0 for all processors",
                 Range::between(0, 1024));
  addScanOptions(options, s.scan);
  addPositionsOption(options, s.scan);
  sedr::StructureChain& stages = chain.getChain();
  options.flag(
      "z-up", stages.trust_up,
      "take z as up even if another axis seems to be, or the scan is inclined");
  options.flag("levelled", stages.keep_levelled,
               "of a scan tilted by 0.3 to 3 degrees, write all results level");
  options.flag("no-mesh", s.no_mesh,
               "stop at the plan and its solid: no mesh.ply and no distances to it");
  options.flag("partial", s.partial,
               "write the model even if it holds less than half of the floor that was "
               "seen");
  options.text("prior", s.priors,
               "what is believed before the scan is looked at, name=value, with commas "
               "between them; see doc/priors.md");
  options.text("openings", s.openings,
               "doors and windows in the solid: closed, or cut with their reveals",
               {"closed", "cut"});
  options.flag("explain", s.explain,
               "print all priors: value, unit, range, source and where they act");
  options.flag("report", s.report,
               "write report.html, one page on all of it, as pcl_sedr_report does");
}

void
apply(const ModelSettings& s, Reconstruction& chain)
{
  chain.setPriors(priorsOf(s.priors));
  chain.setNumberOfThreads(s.threads);
  chain.getChain().extrusion.setCutOpenings(s.openings == "cut");
  if (s.explain)
    std::cout << explained(chain.getPriors()) << std::flush;
}

} // namespace pcl::sedr::tools
