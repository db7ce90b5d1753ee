// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_measures.h"
#include "simulator/sample_rooms.h"

#include <gtest/gtest.h>

namespace pcl::sedr::sim::test {

/** @brief Returns the truth of a scene with only this room. */
inline Mesh
meshOf(const Room& room, double chord_tolerance = kChordTolerance)
{
  return truthMesh(makeScene(room, {}, 1), chord_tolerance);
}

inline void
expectClosed(const Mesh& mesh, long euler_characteristic)
{
  EXPECT_TRUE(isClosedManifold(mesh));
  EXPECT_EQ(eulerCharacteristic(mesh), euler_characteristic);
}

} // namespace pcl::sedr::sim::test
