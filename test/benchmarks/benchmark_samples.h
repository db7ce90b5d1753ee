// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/figures/scene_truth.h"
#include "benchmark/runs/run_row.h"

#include "simulator/sample_rooms.h"

#include <memory>
#include <string>
#include <utility>

/** @file Scenes and rows whose figures are known in closed form. */

namespace benchmark_test {

namespace sim = pcl::sedr::sim;
using namespace pcl::sedr::benchmark;
using pcl::sedr::TriangleMesh;

/** The truth of a scene of one room. */
inline SceneTruth
truthOfRoom(sim::Room room)
{
  return truthOf(sim::test::makeScene(std::move(room), {}, 1));
}

/** A room of 4 x 3 x 2.5 m with a soffit of 2 x 1 m in the middle of its ceiling,
 * `drop` metres below it. */
inline sim::Room
roomWithSoffit(double drop)
{
  sim::Room room = sim::test::makeBoxRoom(4.0, 3.0, 2.5);
  room.details.push_back({sim::rectangleLoop({1.0, 1.0}, {3.0, 2.0}), {2.5 - drop}});
  return room;
}

/** A run that reaches every bar. */
inline RunRow
goodRow(const std::string& scene = "sample",
        double noise = 0.01,
        std::uint64_t seed = 1)
{
  RunRow row;
  row.scene = scene;
  row.noise = noise;
  row.seed = seed;
  row.points = 1234567;
  row.rooms = {4, 4, 4, 0.001, 0.002, 0.003, 0.004};
  row.plan = {18, 18, 0, 0.0011, 2, 2, 0.0021, 0.0031};
  row.solid = {4, true, 0, 120, 0.0001, 0.001, 0.00015, 0.0015, 0.0012, 0.0013};
  row.mesh.components = 4;
  row.mesh.closed = true;
  row.mesh.edge_manifold = true;
  row.mesh.vertex_manifold = true;
  row.mesh.closed_manifold = true;
  row.mesh.truth_to_mesh_mean = 0.001;
  row.mesh.truth_to_mesh_rms = 0.0015;
  row.mesh.truth_to_mesh_p95 = 0.004;
  row.mesh.truth_to_mesh_max = 0.031;
  row.mesh.truth_within_1cm = 0.98;
  row.mesh.truth_within_5cm = 0.999;
  row.mesh.mesh_to_truth_mean = 0.0011;
  row.mesh.mesh_to_truth_p95 = 0.0041;
  row.mesh.mesh_to_truth_max = 0.032;
  row.mesh.mesh_beyond_5cm = 0.001;
  row.mesh.detail_within_1cm = 0.95;
  row.mesh.detail_within_5cm = 0.99;
  row.structure = {0.0005, 0.02, 0.0, 0.999};
  for (auto& label : row.labels)
    label = {0.99, 0.98};
  row.seconds = 12.5;
  row.stage_seconds = {{"ParallelVoxelGrid", 0.25}, {"StructuralPoisson", 12.25}};
  return row;
}

} // namespace benchmark_test
