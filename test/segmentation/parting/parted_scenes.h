// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_segmentation/src/parting/room_parting.h"

#include "segmentation/air/air_scene.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>

namespace sedr_test {

/** A scene with its air split into rooms. */
struct Parted : SceneAir {
  explicit Parted(const AirScene& of, unsigned threads = 1)
      : SceneAir(of, threads)
      , parted(pcl::sedr::partIntoRooms(gaps, {}))
  {}

  /** Returns the room at a place, -1 for none. */
  int roomAt(double x, double y, double z = 1) const
  {
    const std::uint32_t g = at(x, y, z);
    return g == pcl::sedr::AirGaps::none ? pcl::sedr::PartedAir::no_room
                                         : parted.room[g];
  }

  /** Returns the number of rooms larger than a square metre. */
  std::size_t rooms() const
  {
    std::map<std::int32_t, int> size;
    for (const std::int32_t r : parted.room)
      ++size[r];
    std::size_t n = 0;
    for (const auto& [room, columns_of_it] : size)
      n += room != pcl::sedr::PartedAir::no_room && columns_of_it > 100 ? 1 : 0;
    return n;
  }

  pcl::sedr::PartedAir parted;
};

/** Runs a test on a scene with and without a turn of 30 degrees. */
inline void
forBothTurns(const std::function<void(AirScene&)>& test)
{
  for (const double degrees : {0.0, 30.0}) {
    SCOPED_TRACE(degrees);
    AirScene scene(degrees);
    test(scene);
  }
}

/** A room of 6 m x 5 m, 4.3 m high, with cupboards of 3 m x 2 m in a corner. */
inline void
addRoomWithCupboards(AirScene& scene, double height)
{
  scene.slab(3.05, 0.05, 6.05, 5.05, 0.01); // the cupboards hide the floor
  scene.slab(0.05, 2.05, 3.05, 5.05, 0.01);
  scene.slab(0.05, 0.05, 6.05, 5.05, 4.31);
  scene.sides(0.05, 0.05, 6.05, 5.05, 0.01, 4.31);
  scene.slab(0.05, 0.05, 3.05, 2.05, height);
  scene.wall(3.05, 0.05, 3.05, 2.05, 0.01, height);
  scene.wall(0.05, 2.05, 3.05, 2.05, 0.01, height);
}

} // namespace sedr_test
