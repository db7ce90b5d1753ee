// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_writer.h"
#include "las_writer.h"
#include "tools/box_room.h"

namespace programs {

/** Returns the points as an E57 file of two scans, half of the points each.
 * @param grid where the origin of the scan is
 * @param stations where the two were taken from, in the frame of the scan */
inline std::string
asE57(const RoomScan& scan,
      const Eigen::Vector3d& grid = {0, 0, 0},
      const std::array<Eigen::Vector3d, 2>& stations = {
          {{1.5, 1.5, 1.4}, {2.5, 1.5, 1.4}}})
{
  E57Writer writer;
  writer.packet_bytes = 60000;
  const std::size_t half = scan.points.size() / 2;
  for (const std::size_t k : {0, 1}) {
    std::vector<double> local[3];
    for (std::size_t i = k * half; i < (k == 0 ? half : scan.points.size()); ++i) {
      local[0].push_back(scan.points[i].x - stations[k].x());
      local[1].push_back(scan.points[i].y - stations[k].y());
      local[2].push_back(scan.points[i].z - stations[k].z());
    }
    const Eigen::Vector3d place = grid + stations[k];
    writer.addScan("station",
                   {E57TestField::ofReals<double>("cartesianX", local[0]),
                    E57TestField::ofReals<double>("cartesianY", local[1]),
                    E57TestField::ofReals<double>("cartesianZ", local[2])},
                   E57Writer::pose(1, 0, 0, 0, place.x(), place.y(), place.z()));
  }
  return writer.file();
}

/** Returns the points as a LAS file in steps of a millimetre. */
inline std::string
asLas(const RoomScan& scan, const Eigen::Vector3d& grid = {0, 0, 0})
{
  const auto steps = [](float metres) {
    return static_cast<std::int32_t>(std::lround(metres * 1000));
  };
  LasSample las;
  las.shift = {grid.x(), grid.y(), grid.z()};
  for (const RoomPoint& p : scan.points)
    las.points.push_back({steps(p.x), steps(p.y), steps(p.z)});
  return las.bytes();
}

} // namespace programs
