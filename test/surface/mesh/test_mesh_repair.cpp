// SPDX-License-Identifier: BSD-3-Clause
#include "meshes.h"

#include <pcl/sedr_surface/mesh_repair.h>

#include <gtest/gtest.h>

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

bool
closedAlsoWhenWelded(TriangleMesh mesh)
{
  mesh.removeUnusedVertices();
  const bool closed = checkTopology(mesh).isClosedManifold();
  return closed && weldVertices(mesh) == 0;
}

// Two cubes over the same diagonal edge, its two vertices welded.
TriangleMesh
cubesAtAnEdge()
{
  TriangleMesh mesh = both(unitCube(), box({1, 1, 0}, {2, 2, 1}));
  weldVertices(mesh);
  return mesh;
}

// Seven blocks about the place of an eighth: a ring that is not closed, but whose ends
// touch in the vertical edge at (1, 2).
TriangleMesh
ringThatTouchesItself()
{
  const int blocks[][2] = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 1}};
  const auto solid = [&blocks](int x, int y, int z) {
    for (const auto& b : blocks)
      if (b[0] == x && b[1] == y && z == 0)
        return true;
    return false;
  };
  TriangleMesh mesh;
  const int sides[6][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                           {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  for (const auto& b : blocks) {
    const Eigen::Vector3d low(b[0], b[1], 0);
    const TriangleMesh cube = box(low, low + Eigen::Vector3d::Ones());
    std::vector<bool> keep;
    for (std::size_t t = 0; t < cube.triangles.size(); ++t) {
      const Eigen::Vector3i n = cube.scaledNormal(t).cast<int>();
      bool inside = false;
      for (const auto& side : sides)
        if (n == Eigen::Vector3i(side[0], side[1], side[2]))
          inside = solid(b[0] + side[0], b[1] + side[1], side[2]);
      keep.push_back(!inside);
    }
    TriangleMesh part = cube;
    part.keepTriangles(keep);
    mesh.append(part);
  }
  weldVertices(mesh);
  mesh.removeUnusedVertices();
  return mesh;
}

} // namespace

TEST(MeshRepair, welding_a_soup_of_triangles_closes_it)
{
  TriangleMesh mesh = sphere({1, 2, 3}, 1, 8);
  EXPECT_FALSE(checkTopology(mesh).isClosed());
  EXPECT_GT(weldVertices(mesh), 0u);
  mesh.removeUnusedVertices();
  EXPECT_TRUE(checkTopology(mesh).isClosedManifold());
  EXPECT_EQ(checkTopology(mesh).euler_characteristic, 2);
}

TEST(MeshRepair, welding_within_a_tolerance_joins_what_lies_within_it_only)
{
  TriangleMesh mesh = both(unitCube(), box({1.0004, 1.0004, 0}, {2, 2, 1}));
  TriangleMesh same = mesh;
  EXPECT_EQ(weldVertices(same, 0.0005), 0u); // the diagonal is 0.00057 long
  EXPECT_EQ(weldVertices(mesh, 0.0006), 2u);
  EXPECT_EQ(checkTopology(mesh).non_manifold_edges, 1u);
}

TEST(MeshRepair, welding_within_a_tolerance_finds_neighbours_in_every_direction)
{
  for (int direction = 0; direction < 27; ++direction) {
    const Eigen::Vector3d step(direction % 3 - 1, direction / 3 % 3 - 1,
                               direction / 9 - 1);
    TriangleMesh mesh;
    // The first vertex is where cells are counted from: the second lies on a corner of
    // them.
    mesh.vertices = {{0, 0, 0}, {5, 5, 5}, Eigen::Vector3d(5, 5, 5) + 0.01 * step};
    EXPECT_EQ(weldVertices(mesh, 0.05), 1u) << step.transpose();
  }
}

TEST(MeshRepair, sheets_back_to_back_go_and_doubles_stay_once)
{
  TriangleMesh mesh = unitCube();
  mesh.triangles.push_back({3, 0, 2}); // the first one again
  mesh.triangles.push_back({0, 1, 6});
  mesh.triangles.push_back({0, 6, 1}); // back to back
  mesh.triangles.push_back({4, 4, 5});
  EXPECT_EQ(dropDegenerateTriangles(mesh), 4u);
  EXPECT_TRUE(checkTopology(mesh).isClosedManifold());
}

TEST(MeshRepair, cubes_at_an_edge_come_apart_where_their_outside_is_joined)
{
  TriangleMesh mesh = cubesAtAnEdge();
  ASSERT_EQ(checkTopology(mesh).non_manifold_edges, 1u);
  MeshRepairReport report;
  cutNonManifold(mesh, KeepApart::Behind, report);
  EXPECT_EQ(report.cut_edges, 1u);
  EXPECT_EQ(report.cut_vertices, 2u);
  EXPECT_TRUE(closedAlsoWhenWelded(mesh));
  EXPECT_EQ(checkTopology(mesh).components.size(), 2u);
  EXPECT_NEAR(mesh.signedVolume(), 2, 0.05);
}

TEST(MeshRepair, cubes_at_an_edge_grow_together_where_their_outside_is_kept_apart)
{
  TriangleMesh mesh = cubesAtAnEdge();
  MeshRepairReport report;
  cutNonManifold(mesh, KeepApart::InFront, report);
  EXPECT_EQ(report.split_edges, 1u); // both sheets have both ends: one goes by a middle
  EXPECT_TRUE(closedAlsoWhenWelded(mesh)) << checkTopology(mesh).problem();
  EXPECT_EQ(checkTopology(mesh).components.size(), 1u);
  EXPECT_EQ(checkTopology(mesh).euler_characteristic, 2);
}

TEST(MeshRepair, sheets_that_follow_one_edge_get_vertices_of_their_own)
{
  // Closed and manifold as they are; a reader that welds would join them at an edge.
  for (const double far : {0.0, 3000.0}) {
    TriangleMesh mesh =
        both(box({far, 0, 0}, {far + 1, 1, 1}), box({far + 1, 1, 0}, {far + 2, 2, 1}));
    mesh.append(box({far + 1, 0, 1}, {far + 2, 1, 2})); // meets either at a vertex
    ASSERT_TRUE(checkTopology(mesh).isClosedManifold());
    ASSERT_FALSE(closedAlsoWhenWelded(mesh));
    EXPECT_EQ(partEqualPositions(mesh), 5u);
    EXPECT_TRUE(closedAlsoWhenWelded(mesh));
    EXPECT_EQ(checkTopology(mesh).components.size(), 3u);
    EXPECT_NEAR(mesh.signedVolume(), 3, 0.05);
    EXPECT_EQ(partEqualPositions(mesh), 0u);
  }
}

TEST(MeshRepair, vertices_that_a_float_does_not_tell_apart_get_different_floats)
{
  // At 100 km a float is 8 mm wide; these boxes are 1 cm.
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d low(1e5 + 0.005 * i, 1e5, 0);
    mesh.append(box(low, low + Eigen::Vector3d::Constant(0.01)));
  }
  EXPECT_GT(partEqualPositions(mesh), 0u);
  EXPECT_TRUE(closedAlsoWhenWelded(mesh));
  for (const auto& v : mesh.vertices)
    EXPECT_EQ(v, v.cast<float>().cast<double>());
}

TEST(MeshRepair, cubes_at_a_vertex_come_apart)
{
  TriangleMesh mesh = both(unitCube(), box({1, 1, 1}, {2, 2, 2}));
  weldVertices(mesh);
  MeshRepairReport report;
  cutNonManifold(mesh, KeepApart::InFront, report);
  EXPECT_EQ(report.cut_edges, 0u);
  EXPECT_EQ(report.cut_vertices, 1u);
  EXPECT_TRUE(closedAlsoWhenWelded(mesh));
}

TEST(MeshRepair, an_edge_at_which_a_ring_touches_itself_is_cut)
{
  for (const KeepApart apart : {KeepApart::InFront, KeepApart::Behind}) {
    TriangleMesh mesh = ringThatTouchesItself();
    ASSERT_EQ(checkTopology(mesh).non_manifold_edges, 1u);
    ASSERT_TRUE(checkTopology(mesh).isClosed());
    MeshRepairReport report;
    const MeshTopology topology = repairMesh(mesh, {}, report);
    EXPECT_TRUE(topology.isClosedManifold()) << topology.problem();
    EXPECT_TRUE(closedAlsoWhenWelded(mesh));
    MeshRepairReport cut;
    TriangleMesh again = ringThatTouchesItself();
    cutNonManifold(again, apart, cut);
    // Behind: the ring stays open, a ball. In front: it closes to a torus.
    EXPECT_EQ(checkTopology(again).euler_characteristic,
              apart == KeepApart::Behind ? 2 : 0);
    EXPECT_TRUE(closedAlsoWhenWelded(again)) << checkTopology(again).problem();
  }
}

TEST(MeshRepair, turned_triangles_are_turned_back)
{
  TriangleMesh mesh = torus();
  for (std::size_t t = 5; t < mesh.triangles.size(); t += 7)
    std::swap(mesh.triangles[t][0], mesh.triangles[t][2]);
  ASSERT_FALSE(checkTopology(mesh).isOriented());
  MeshRepairReport report;
  orientConsistently(mesh, report);
  EXPECT_EQ(report.orientation_conflicts, 0u);
  EXPECT_GT(report.flipped_triangles, 0u);
  EXPECT_TRUE(checkTopology(mesh).isClosedManifold());
}

TEST(MeshRepair, a_moebius_strip_cannot_be_oriented_and_says_so)
{
  TriangleMesh mesh;
  const std::uint32_t n = 12;
  for (std::uint32_t i = 0; i < n; ++i)
    for (int side = -1; side <= 1; side += 2) {
      const double u = 2 * M_PI * i / n;
      const double r = 2 + side * 0.5 * std::cos(u / 2);
      mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u),
                                 side * 0.5 * std::sin(u / 2));
    }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 * i;
    const std::uint32_t b = a + 1;
    const std::uint32_t c = i + 1 < n ? a + 2 : 1; // crosswise where the ends meet
    const std::uint32_t d = i + 1 < n ? a + 3 : 0;
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({b, c, d});
  }
  MeshRepairReport report;
  orientConsistently(mesh, report);
  EXPECT_EQ(report.orientation_conflicts, 1u);
  EXPECT_EQ(checkTopology(mesh).inconsistent_edges, 1u);
  EXPECT_EQ(checkTopology(mesh).euler_characteristic, 0);
}

TEST(MeshRepair, normals_point_to_the_side_that_is_asked_for)
{
  TriangleMesh other = box({5, 0, 0}, {6, 1, 1});
  other.flip();
  TriangleMesh mesh = both(unitCube(), other);
  EXPECT_EQ(orientNormals(mesh, NormalSide::Inward), 1u);
  EXPECT_NEAR(mesh.signedVolume(), -2, 1e-12);
  EXPECT_EQ(orientNormals(mesh, NormalSide::Outward), 2u);
  EXPECT_NEAR(mesh.signedVolume(), 2, 1e-12);
  EXPECT_EQ(orientNormals(mesh, NormalSide::Outward), 0u);
}

TEST(MeshRepair, small_holes_are_filled_and_large_ones_reported)
{
  TriangleMesh mesh = torus();
  mesh.rooms.assign(mesh.triangles.size(), 4);
  mesh.triangles.erase(mesh.triangles.begin() + 100); // three edges
  mesh.triangles.erase(mesh.triangles.begin() + 200, mesh.triangles.begin() + 204);
  mesh.rooms.resize(mesh.triangles.size());
  TriangleMesh partly = mesh;
  MeshRepairReport report;
  fillHoles(partly, 3, report);
  EXPECT_EQ(report.filled_holes, 1u);
  EXPECT_EQ(report.open_holes, 1u);
  EXPECT_EQ(checkTopology(partly).boundary_edges, 6u);

  report = {};
  fillHoles(mesh, 6, report);
  EXPECT_EQ(report.filled_holes, 2u);
  EXPECT_EQ(report.filled_edges, 9u);
  EXPECT_EQ(report.open_holes, 0u);
  EXPECT_TRUE(checkTopology(mesh).isClosedManifold());
  EXPECT_EQ(mesh.problem(), "");
  EXPECT_EQ(mesh.rooms.back(), 4u);
  EXPECT_NEAR(mesh.signedVolume(), torus().signedVolume(), 0.05);
}

TEST(MeshRepair, the_largest_components_stay)
{
  TriangleMesh mesh =
      both(both(box({9, 9, 9}, {9.1, 9.1, 9.1}), box({0, 0, 0}, {2, 2, 2})),
           box({5, 5, 5}, {6, 6, 6}));
  MeshRepairReport report;
  keepLargestComponents(mesh, 2, report);
  EXPECT_EQ(report.removed_components, 1u);
  EXPECT_EQ(report.removed_triangles, 12u);
  EXPECT_NEAR(mesh.signedVolume(), 9, 1e-12);
}

TEST(MeshRepair, short_edges_collapse_without_changing_topology_or_shape)
{
  TriangleMesh mesh = torus();
  // A sliver: a vertex next to another one, on the edge between triangles 0 and 1.
  const auto near = static_cast<std::uint32_t>(mesh.vertices.size());
  const Triangle t0 = mesh.triangles[0];
  const Triangle t1 = mesh.triangles[1];
  mesh.vertices.push_back(0.9999 * mesh.vertices[t0[0]] +
                          0.0001 * mesh.vertices[t0[2]]);
  mesh.triangles[0] = {t0[0], t0[1], near};
  mesh.triangles.push_back({t0[1], t0[2], near});
  mesh.triangles[1] = {t1[0], near, t1[2]};
  mesh.triangles.push_back({near, t1[1], t1[2]});
  ASSERT_TRUE(checkTopology(mesh).isClosedManifold());
  const double volume = mesh.signedVolume();
  EXPECT_EQ(collapseShortEdges(mesh, 0.001), 1u);
  EXPECT_TRUE(checkTopology(mesh).isClosedManifold());
  EXPECT_EQ(checkTopology(mesh).euler_characteristic, 0);
  EXPECT_EQ(mesh.triangles.size(), torus().triangles.size());
  EXPECT_NEAR(mesh.signedVolume(), volume, 1e-4);
}

TEST(MeshRepair, collapsing_never_tears_a_surface_however_long_the_edges)
{
  for (const double length : {0.1, 0.3, 1., 5.}) {
    TriangleMesh mesh = torus();
    collapseShortEdges(mesh, length);
    EXPECT_TRUE(checkTopology(mesh).isClosedManifold()) << length;
    EXPECT_EQ(checkTopology(mesh).euler_characteristic, 0) << length;
  }
}

TEST(MeshRepair, an_edge_stays_whose_collapse_would_turn_a_triangle_over)
{
  // A flat lid over an apex; the middle of the short edge 0-1 lies beyond the side 2-3
  // of 0-2-3.
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0},    {0.1, 0, 0},    {0.03, 0.3, 0},
                   {0.03, 1, 0}, {0.06, 1.2, 0}, {-1, 0, 0},
                   {0, -1, 0},   {1, 0, 0},      {0, 0, -1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {0, 5, 6}, {0, 6, 1},
                    {6, 7, 1}, {1, 7, 4}, {1, 4, 2}, {2, 4, 3}, {6, 5, 8},
                    {7, 6, 8}, {4, 7, 8}, {3, 4, 8}, {5, 3, 8}};
  ASSERT_TRUE(checkTopology(mesh).isClosedManifold());
  TriangleMesh harmless = mesh;
  harmless.vertices[2] = {0.0515, 0.3, 0};
  harmless.vertices[3] = {0.0545, 1, 0};
  EXPECT_EQ(collapseShortEdges(harmless, 0.11), 1u);
  EXPECT_TRUE(checkTopology(harmless).isClosedManifold());
  EXPECT_EQ(collapseShortEdges(mesh, 0.11), 0u);
}

TEST(MeshRepair, a_wreck_becomes_a_closed_manifold)
{
  TriangleMesh mesh = sphere({0, 0, 0}, 1, 12);
  mesh.append(box({3, 3, 3}, {3.2, 3.2, 3.2}));
  for (std::size_t t = 3; t < 200; t += 37)
    std::swap(mesh.triangles[t][0], mesh.triangles[t][2]);
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back(mesh.triangles[8]);
  mesh.triangles.erase(mesh.triangles.begin() + 300);
  MeshRepairOptions options;
  options.weld_tolerance = 1e-9;
  options.keep_components = 1;
  options.normals = NormalSide::Inward;
  MeshRepairReport report;
  const MeshTopology topology = repairMesh(mesh, options, report);
  EXPECT_TRUE(topology.isClosedManifold()) << topology.problem();
  EXPECT_EQ(topology.components.size(), 1u);
  EXPECT_EQ(topology.unused_vertices, 0u);
  EXPECT_NEAR(mesh.signedVolume(), -4. / 3 * M_PI, 0.1);
  EXPECT_EQ(report.filled_holes, 1u);
  EXPECT_EQ(report.removed_components, 1u);
}

TEST(MeshRepair, what_cannot_be_repaired_is_reported)
{
  TriangleMesh mesh = unitCube();
  mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
  MeshRepairOptions options;
  options.max_hole_edges = 3;
  MeshRepairReport report;
  const MeshTopology topology = repairMesh(mesh, options, report);
  EXPECT_FALSE(topology.isClosedManifold());
  EXPECT_EQ(topology.boundary_edges, 4u);
  EXPECT_EQ(report.open_holes, 1u);
}
