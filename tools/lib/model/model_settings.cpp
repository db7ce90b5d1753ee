// SPDX-License-Identifier: BSD-3-Clause
#include "model_run.h"
#include "solid_files.h"
#include "tool_error.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace pcl::sedr::tools {

namespace {

/** @brief Reads priors: name=value, separated by commas. */
Priors
readPriors(const std::string& list)
{
  Priors priors;
  std::istringstream given(list);
  for (std::string one; std::getline(given, one, ',');) {
    one.erase(0, std::min(one.find_first_not_of(' '), one.size()));
    const std::size_t equals = std::min(one.find('='), one.size());
    const std::string number = one.substr(std::min(equals + 1, one.size()));
    char* end = nullptr;
    const double value = std::strtod(number.c_str(), &end);
    if (number.empty() || *end != '\0' || !std::isfinite(value))
      throw ToolError("a prior is given as name=value, its value a number, not '" +
                      one + "'");
    const std::string problem = setPrior(one.substr(0, equals), value, priors);
    if (!problem.empty())
      throw ToolError(problem + "; doc/priors.md lists all");
  }
  return priors;
}

} // namespace

void
addModelOptions(Options& options, ModelSettings& s, Reconstruction& chain)
{
  options.parameter("voxel-size", chain, &Reconstruction::getVoxelSize,
                    &Reconstruction::setVoxelSize, "m",
                    "edge of a voxel in down-sampling", Range::between(0.005, 0.05));
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
  options.flag(
      "z-up", s.known.trust_up,
      "take z as up even if another axis seems to be, or the scan is inclined");
  options.flag("levelled", s.known.keep_levelled,
               "of a scan tilted by 0.3 to 3 degrees, write all results level");
  options.flag("no-mesh", s.no_mesh,
               "stop at the plan and its solid: no mesh.ply and no distances to it");
  options.flag("partial", s.partial,
               "write the model even if it holds less than half of the floor that was "
               "seen");
  addSheetTexts(options, s.texts);
  options.text("prior", s.priors,
               "what is believed before the scan is looked at, name=value, with commas "
               "between them; see doc/priors.md");
  options.text("openings", s.openings,
               "doors and windows in the solid: closed, or cut with their reveals",
               {"closed", "cut"});
  options.flag("report", s.report,
               "write report.html, one page on all of it, as pcl_sedr_report does");
}

void
apply(const ModelSettings& s, Reconstruction& chain)
{
  chain.setPriors(readPriors(s.priors));
  chain.setNumberOfThreads(s.threads);
  chain.getStages().extrusion.setCutOpenings(s.openings == "cut");
}

} // namespace pcl::sedr::tools
