// SPDX-License-Identifier: BSD-3-Clause
// Brings a model back to where the scan was: adds the origin that its header tells.
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <fstream>
#include <iostream>
#include <string>

int
main(int argc, char** argv)
{
  if (argc != 3) {
    std::cerr << "usage: move_mesh MESH.ply MOVED.ply\n";
    return 1;
  }
  pcl::sedr::Origin origin;
  std::ifstream header(argv[1], std::ios::binary);
  for (std::string line; std::getline(header, line) && line != "end_header";)
    pcl::sedr::Origin::fromComment(line, origin);

  pcl::sedr::TriangleMesh mesh;
  std::string problem = pcl::sedr::loadMesh(argv[1], mesh);
  for (auto& vertex : mesh.vertices)
    vertex = origin.toGiven(vertex);
  if (problem.empty()) { // far from 0 it is written in double precision
    std::ofstream moved(argv[2], std::ios::binary);
    if (!(moved << pcl::sedr::meshToPly(mesh) << std::flush))
      problem = std::string(argv[2]) + " cannot be written";
  }
  std::cerr << problem;
  return problem.empty() ? 0 : 1;
}
