// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "model/solid_files.h"
#include "run_tool.h"
#include "scan_options.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include <pcl/conversions.h>
#include <pcl/sedr_surface/structural_poisson.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <iostream>
#include <sstream>

using namespace pcl::sedr::tools;
using pcl::sedr::RoomPoissonReport;

namespace {

struct Settings {
  std::string input;
  std::string output;
};

using Poisson = pcl::StructuralPoisson<pcl::PointStructure>;

pcl::PointCloud<pcl::PointStructure>::Ptr
load(const Settings& settings)
{
  const ToolCloud cloud = loadCloud(settings.input);
  for (const char* name : {"normal_x", "normal_y", "normal_z"})
    if (!findField(cloud.blob, name))
      throw ToolError(settings.input +
                          " has no normals (normal_x, normal_y, normal_z): refine " +
                          "the structure first",
                      NothingFound);
  auto points = std::make_shared<pcl::PointCloud<pcl::PointStructure>>();
  pcl::fromPCLPointCloud2(cloud.blob, *points);
  for (std::size_t i = 0; i < cloud.size(); ++i) { // whatever their types are
    (*points)[i].label = cloud.label[i];
    (*points)[i].room = cloud.room[i];
  }
  return points;
}

void
tell(const RoomPoissonReport& report)
{
  std::ostringstream line;
  line.precision(3);
  line << "room " << report.room << ": " << report.points << " points "
       << report.spacing << " m apart, depth " << report.depth << ", cells "
       << report.cell << " m, " << report.topology.triangles << " triangles, "
       << report.area << " m2, " << report.volume << " m3, "
       << (report.closed ? "closed" : report.problem);
  if (report.unsupported_share > 0.001)
    line << ", " << 100 * report.unsupported_share << " % of the area is a guess";
  say(line.str());
}

int
run(const Settings& settings, Poisson& poisson)
{
  checkOutput(settings.output, "a mesh", {".ply"});
  poisson.setInputCloud(load(settings));
  pcl::PolygonMesh mesh;
  {
    const Progress progress("solving");
    poisson.reconstruct(mesh);
  }
  for (const RoomPoissonReport& report : poisson.getReports())
    tell(report);
  if (poisson.getMesh().empty())
    throw ToolError(poisson.getErrorMessage(), NothingFound);
  writeWhole(settings.output, meshToPly(poisson.getMesh(),
                                        originComments(originOfModel(settings.input))));
  if (!poisson.getErrorMessage().empty())
    std::cerr << "pcl_structural_poisson: " << poisson.getErrorMessage() << std::endl;
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Poisson poisson;
  poisson.setNumberOfThreads(0);
  Settings settings;
  Options options(
      "pcl_structural_poisson",
      "Makes one closed mesh a room from oriented points, by screened Poisson.");
  options.file("INPUT", settings.input,
               "PCD or PLY cloud with normals into the room; its fields "
               "room and label are used if there");
  options.file("OUTPUT.ply", settings.output,
               "mesh to write, faces with room and label");
  options.parameter("depth", poisson, &Poisson::getDepth, &Poisson::setDepth, "",
                    "largest depth of the octree", Range::between(3, 14));
  return runTool(options, argc, argv, [&] { return run(settings, poisson); });
}
