// SPDX-License-Identifier: BSD-3-Clause
#include "level_slab.h"

#include "../mesh/mesh_repair.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace pcl::sedr::ifc {
namespace {

constexpr double same_height =
    0.001; ///< smaller height differences are ignored, metres

/** @brief Returns the range of a slab's heights over a box, from samples. */
double
spreadOf(const PlanSlab& slab, const Eigen::AlignedBox2d& box)
{
  constexpr int samples = 8;
  double low = slab.heightAt(box.center());
  double high = low;
  for (int i = 0; i <= samples; ++i)
    for (int j = 0; j <= samples; ++j) {
      const Eigen::Vector2d share(static_cast<double>(i) / samples,
                                  static_cast<double>(j) / samples);
      const double height = slab.heightAt(box.min() + share.cwiseProduct(box.sizes()));
      low = std::min(low, height);
      high = std::max(high, height);
    }
  return high - low;
}

} // namespace

std::optional<double>
levelOf(const PlanSlab& slab, const Eigen::AlignedBox2d& box)
{
  if (box.isEmpty() || !(spreadOf(slab, box) < same_height))
    return std::nullopt;
  return slab.heightAt(box.center());
}

bool
hasSlopingCeiling(const PlanRoom& room)
{
  // Fitted planes may tilt by some millimetres without being a roof.
  constexpr double sloping = 0.03; // metres
  const auto slopes = [](const PlanSlab& slab, const PlanLoop& loop) {
    const Eigen::AlignedBox2d box = boundsOf(loop);
    return !box.isEmpty() && spreadOf(slab, box) > sloping;
  };
  return slopes(room.ceiling, room.boundary) ||
         std::any_of(room.details.begin(), room.details.end(),
                     [&](const PlanDetail& detail) {
                       return slopes(detail.slab, detail.boundary);
                     });
}

int
sideOf(const PlanDetail& detail, const PlanSlab& slab)
{
  const Eigen::Vector2d middle = boundsOf(detail.boundary).center();
  const double above = detail.slab.heightAt(middle) - slab.heightAt(middle);
  return above > same_height ? 1 : above < -same_height ? -1 : 0;
}

TriangleMesh
prismOn(const TriangleMesh& mesh,
        const std::vector<std::size_t>& triangles,
        const std::function<double(const Eigen::Vector3d&)>& height_at)
{
  TriangleMesh prism;
  std::map<std::uint32_t, std::uint32_t> taken;
  for (const std::size_t t : triangles) {
    Triangle own;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh.triangles[t][k];
      const auto [at, is_new] =
          taken.emplace(v, static_cast<std::uint32_t>(prism.vertices.size()));
      if (is_new)
        prism.vertices.push_back(mesh.vertices[v]);
      own[k] = at->second;
    }
    prism.triangles.push_back(own);
  }
  const std::set<MeshEdge> rim = rimOf(prism.triangles);
  const auto n = static_cast<std::uint32_t>(prism.vertices.size());
  for (std::uint32_t v = 0; v < n; ++v) {
    const Eigen::Vector3d p = prism.vertices[v];
    prism.vertices.emplace_back(p.x(), p.y(), height_at(p));
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Triangle own = prism.triangles[t];
    prism.triangles.push_back({own[0] + n, own[2] + n, own[1] + n});
  }
  for (const auto& [a, b] : rim) {
    prism.triangles.push_back({b, a, a + n});
    prism.triangles.push_back({b, a + n, b + n});
  }
  if (prism.signedVolume() < 0)
    prism.flip();
  return prism;
}

std::vector<std::size_t>
allTriangles(const TriangleMesh& mesh)
{
  std::vector<std::size_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

TriangleMesh
lowered(TriangleMesh mesh, double height)
{
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex.z() -= height;
  return mesh;
}

} // namespace pcl::sedr::ifc
