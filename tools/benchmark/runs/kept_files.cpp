// SPDX-License-Identifier: BSD-3-Clause
#include "kept_files.h"

#include "benchmark/table/cells.h"

#include "simulator/truth/files.h"
#include "tool_cloud.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/wall_tilts.h>
#include <pcl/sedr_surface/mesh_io.h>

#include <stdexcept>

namespace pcl::sedr::benchmark {

namespace {

void
saveMesh(const std::filesystem::path& path, const TriangleMesh& mesh)
{
  const std::string problem = savePly(path.string(), mesh);
  if (!problem.empty())
    throw std::runtime_error(problem);
}

} // namespace

KeptFiles::KeptFiles(const std::filesystem::path& folder, const RunRow& row)
{
  if (folder.empty())
    return;
  folder_ = folder / (row.scene + "_n" + cellOf(row.noise) + "_s" + cellOf(row.seed));
  std::filesystem::create_directories(folder_);
}

void
KeptFiles::keepInput(const sim::Scan& scan,
                     const SceneTruth& truth,
                     const std::string& scene) const
{
  if (folder_.empty())
    return;
  sim::writePcd(folder_ / "scan.pcd", scan.points);
  sim::writeText(folder_ / "truth.json", sim::roomTruthsToJson(scene, truth.rooms));
  saveMesh(folder_ / "truth.ply", *truth.mesh);
}

void
KeptFiles::keepResult(const pcl::IndoorStructureReconstruction<pcl::PointXYZ>& chain,
                      bool has_mesh) const
{
  if (folder_.empty() || chain.getStructure()->empty())
    return;
  tools::saveStructure((folder_ / "structure.pcd").string(), *chain.getStructure());
  sim::writeText(folder_ / "floorplan.json",
                 withTilts(floorplanToJson(*chain.getFloorplan(), nullptr, {},
                                           chain.getPriors().max_wall),
                           chain.getChain().tilts, {}));
  const TriangleMesh& solid = chain.getChain().extrusion.getMesh();
  if (!solid.empty())
    saveMesh(folder_ / "solid.ply", solid);
  if (has_mesh)
    saveMesh(folder_ / "mesh.ply", chain.getChain().poisson.getMesh());
}

} // namespace pcl::sedr::benchmark
