// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "model/solid_files.h"
#include "picture_file.h"
#include "progress.h"
#include "run_tool.h"
#include "scan_options.h"
#include "stage_pictures.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include <pcl/sedr_surface/mesh_io.h>
#include <pcl/sedr_surface/structural_poisson.h>

#include <iostream>
#include <sstream>

using namespace pcl::sedr::tools;
using pcl::sedr::RoomPoissonReport;

namespace {

struct Settings {
  std::string input;
  std::string output;
  PictureFile picture;
};

using Poisson = pcl::StructuralPoisson<pcl::PointStructure>;

pcl::PointCloud<pcl::PointStructure>::Ptr
load(const Settings& settings)
{
  const ToolCloud cloud = loadCloud(settings.input);
  const std::vector<float> normals[3] = {floatField(cloud.blob, "normal_x"),
                                         floatField(cloud.blob, "normal_y"),
                                         floatField(cloud.blob, "normal_z")};
  for (const auto& component : normals)
    if (component.size() != cloud.size())
      throw ToolError(settings.input +
                          " has no normals (normal_x, normal_y, normal_z): refine " +
                          "the structure first",
                      NothingFound);
  auto points = std::make_shared<pcl::PointCloud<pcl::PointStructure>>();
  points->resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    pcl::PointStructure& point = (*points)[i];
    point.getVector3fMap() = (*cloud.points)[i].getVector3fMap();
    for (int k = 0; k < 3; ++k)
      point.normal[k] = normals[k][i];
    point.label = cloud.label[i];
    point.room = cloud.room[i];
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
  settings.picture.check();
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
  writeWhole(settings.output, [&](std::ostream& stream) {
    stream << pcl::sedr::meshToPly(poisson.getMesh(),
                                   originComments(originOfModel(settings.input)));
  });
  settings.picture.write([&] { return drawMesh(poisson.getMesh()); });
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
  settings.picture.declare(options);
  return runTool(options, argc, argv, [&] { return run(settings, poisson); });
}
