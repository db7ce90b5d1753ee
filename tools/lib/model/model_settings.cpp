// SPDX-License-Identifier: BSD-3-Clause
#include "model_settings.h"
#include "prior_values.h"

#include <pcl/common/angles.h>

namespace pcl::sedr::tools {

ModelSettings::ModelSettings(const Reconstruction& chain)
    : voxel(chain.getVoxelSize())
    , plane_tolerance(chain.getPlaneTolerance())
    , grid(chain.getGridSize())
    , angle(pcl::rad2deg(chain.getBoundaryAngle()))
    , neighbours(chain.getBoundaryNeighbors())
    , minimum_cells(chain.getMinimumDetailCells())
    , boundary_tolerance(chain.getBoundaryTolerance())
    , depth(chain.getTreeDepth())
    , threads(chain.getNumberOfThreads())
    , seed(chain.getSeed())
    , z_up(chain.getChain().trust_up)
    , levelled(chain.getChain().keep_levelled)
    , mesh_from_plan(chain.getChain().mesh_from_plan)
{}

void
addModelOptions(Options& options, ModelSettings& s)
{
  options.number("voxel-size", s.voxel, "m", "edge of a voxel in down-sampling",
                 Range::between(0.005, 1));
  options.flag("keep-strays", s.keep_strays,
               "keep voxels that points scattered in the air explain");
  options.number("plane-tolerance", s.plane_tolerance, "m",
                 "tolerance of the planes of ceiling and floor",
                 Range::between(0.001, 1));
  options.number("grid-size", s.grid, "m", "cell of outlier removal and grid-slices",
                 Range::between(0.01, 1));
  options.flag("fixed-grid", s.fixed_grid,
               "keep the cells even where the scan is too sparse to fill them");
  options.number("boundary-angle", s.angle, "degrees", "angle of boundary estimation",
                 Range::between(1, 359));
  options.number("boundary-neighbors", s.neighbours, "points",
                 "neighbours of boundary estimation", Range::between(3, 10000));
  options.number("minimum-cells", s.minimum_cells, "cells",
                 "least region of a structural detail", Range::atLeast(1));
  options.number("boundary-tolerance", s.boundary_tolerance, "m",
                 "tolerance of the walls' lines and circles", Range::between(0.001, 1));
  options.number("tree-depth", s.depth, "levels",
                 "greatest depth of the Poisson reconstruction", Range::between(3, 14));
  options.number("threads", s.threads, "", "threads, 0 for all processors",
                 Range::between(0, 1024));
  options.number("seed", s.seed, "", "seed of the random samples", Range::atLeast(0));
  addScanOptions(options, s.scan);
  addPositionsOption(options, s.scan);
  options.flag(
      "z-up", s.z_up,
      "take z as up even if another axis seems to be, or the scan is inclined");
  options.flag("levelled", s.levelled,
               "of a scan tilted by 0.3 to 3 degrees, write all results level");
  options.flag("mesh-from-plan", s.mesh_from_plan,
               "sample the floor plan for mesh.ply, not the points");
  options.flag("no-mesh", s.no_mesh,
               "stop at the plan and its solid: no mesh.ply and no distances to it");
  options.flag("partial", s.partial,
               "write the model even if it holds less than half of the floor that was "
               "seen");
  addIfcOptions(options, s.ifc);
  options.text("prior", s.priors,
               "what is believed before the scan is looked at, name=value, with commas "
               "between them; see doc/priors.md");
  options.text("prior-file", s.prior_file,
               "file with a line of name = value for each, # begins a comment");
  options.flag("explain", s.explain,
               "print all priors: value, unit, range, source and where they act");
  options.flag("report", s.report,
               "write report.html, one page on all of it, as pcl_sedr_report does");
}

void
apply(const ModelSettings& s, Reconstruction& chain)
{
  chain.setPriors(priorsOf(s.priors, s.prior_file));
  chain.setVoxelSize(static_cast<float>(s.voxel));
  chain.getVoxelGrid().setRemoveStrays(!s.keep_strays);
  chain.setPlaneTolerance(s.plane_tolerance);
  chain.setGridSize(s.grid);
  chain.setAdaptiveGrid(!s.fixed_grid);
  chain.setBoundaryEstimation(pcl::deg2rad(s.angle), s.neighbours);
  chain.setMinimumDetailCells(s.minimum_cells);
  chain.setBoundaryTolerance(s.boundary_tolerance);
  chain.setTreeDepth(s.depth);
  chain.setNumberOfThreads(s.threads);
  chain.setSeed(s.seed);
  chain.getChain().trust_up = s.z_up;
  chain.getChain().keep_levelled = s.levelled;
  chain.getChain().mesh_from_plan = s.mesh_from_plan;
}

} // namespace pcl::sedr::tools
