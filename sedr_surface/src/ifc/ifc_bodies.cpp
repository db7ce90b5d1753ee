// SPDX-License-Identifier: BSD-3-Clause
#include "ifc_bodies.h"

#include "../mesh/mesh_repair.h"
#include "../walls/wall_band.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "step_file.h"

#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace pcl::sedr::ifc {
namespace {

using Lines = std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>;

/** @brief Appends a line across a wall, in its frame.
 * @param along share of its length */
void
appendAcross(const Floorplan& plan, const WallBody& body, double along, Lines& lines)
{
  constexpr double beyond = 0.01;
  const auto& [wall, frame, heights, runs, profile] = body;
  const auto [place, inward] = faceAt(
      elementOf(plan, wall.face), wall.stretch.from + along * wall.stretch.length());
  lines.emplace_back(frame.toLocal(place + beyond * inward),
                     frame.toLocal(place - (2 * wall.thickness + beyond) * inward));
}

/** @brief Returns the height of a wall above its bottom at a place in its frame. */
double
heightAt(const Floorplan& plan, const WallBody& body, const Eigen::Vector2d& p)
{
  constexpr double min_height = 0.001;
  const Stretch& stretch = body.wall.stretch;
  const PlanElement& element = elementOf(plan, body.wall.face);
  const double s = element.isArc()
                       ? element.project(body.frame.toPlan(p)) - stretch.from
                       : p.x(); // stretches may go on beyond their element
  return std::max(body.heights.topAt(s / stretch.length()) - body.heights.bottom,
                  min_height);
}

/** @brief Returns the lines in plan between which the heights of a wall and its cuts
 * are linear: where its top bends or meets those of cuts, and the outlines of cuts. */
Lines
linesOf(const Floorplan& plan, const WallBody& body, const std::vector<WallCut>& cuts)
{
  Lines lines;
  const auto& tops = body.heights.tops;
  for (const WallHeights::Top& top : tops) // level beyond the first and last
    appendAcross(plan, body, top.along, lines);
  for (const WallCut& cut : cuts) {
    const std::vector<Eigen::Vector2d> corners =
        cut.plan.polygon(SolidParameters().chord_tolerance);
    for (std::size_t k = 0; k < corners.size(); ++k)
      lines.emplace_back(corners[k], corners[(k + 1) % corners.size()]);
    const Eigen::Vector2d middle = body.frame.toPlan(boundsOf(cut.plan).center());
    for (const PlanSlab* slab : {&cut.bottom, &cut.top})
      for (std::size_t k = 1; k < tops.size(); ++k) {
        const auto& [from, low] = tops[k - 1];
        const auto& [to, high] = tops[k];
        const double z = slab->heightAt(middle);
        if ((z - low) * (z - high) < 0)
          appendAcross(plan, body, from + (z - low) / (high - low) * (to - from),
                       lines);
      }
  }
  return lines;
}

} // namespace

WallRuns
runsOf(const Floorplan& plan, const PlanWall& wall)
{
  const auto runOfFace = [&](const WallFace& face) {
    return face.loop > 0 ? 0 : std::tan(elementOf(plan, face).tilt);
  };
  if (elementOf(plan, wall.face).isArc())
    return {};
  const double near = runOfFace(wall.face);
  return {near, wall.other ? -runOfFace(*wall.other) : near};
}

TriangleMesh
WallBody::mesh(const Floorplan& plan) const
{
  const TriangleMesh foot = triangulated(profile, linesOf(plan, *this, {}));
  TriangleMesh mesh = prismOn(foot, [&](const Eigen::Vector3d& p) {
    return heightAt(plan, *this, p.head<2>());
  });
  for (Eigen::Vector3d& p : mesh.vertices) {
    const double across = std::clamp(-p.y() / wall.thickness, 0.0, 1.0);
    p.y() += ((1 - across) * runs.near + across * runs.far) * p.z();
  }
  return mesh;
}

double
WallBody::volume(const Floorplan& plan, const std::vector<WallCut>& cuts) const
{
  const double taper = (runs.far - runs.near) / wall.thickness;
  const auto solidBetween = [&](double low, double high) {
    return std::max(high - low, 0.0) * (1 - taper * (low + high) / 2);
  };
  // Metres of wall above a place; a taper makes it count less further up.
  const auto solidAt = [&](const Eigen::Vector2d& p,
                           const std::vector<const WallCut*>& open) {
    std::vector<std::pair<double, double>> spans;
    for (const WallCut* cut : open)
      spans.emplace_back(cut->bottom.heightAt(frame.toPlan(p)) - heights.bottom,
                         cut->top.heightAt(frame.toPlan(p)) - heights.bottom);
    std::sort(spans.begin(), spans.end());
    const double top = heightAt(plan, *this, p);
    double end = 0;
    double solid = 0;
    for (const auto& [low, high] : spans) {
      solid += solidBetween(end, std::min(low, top));
      end = std::max(end, high);
    }
    return solid + solidBetween(end, top);
  };
  const TriangleMesh foot = triangulated(profile, linesOf(plan, *this, cuts));
  double volume = 0;
  for (std::size_t t = 0; t < foot.triangles.size(); ++t) {
    const Eigen::Vector3d middle =
        (foot.corner(t, 0) + foot.corner(t, 1) + foot.corner(t, 2)) / 3;
    std::vector<const WallCut*> open;
    for (const WallCut& cut : cuts)
      if (cut.plan.contains(middle.head<2>()))
        open.push_back(&cut);
    for (const int k : {0, 1, 2})
      volume += foot.scaledNormal(t).norm() / 2 *
                solidAt(foot.corner(t, k).head<2>(), open) / 3;
  }
  return volume;
}

namespace {

constexpr double same_height =
    0.001; ///< smaller height differences are ignored, metres

/** @brief Returns the range of a slab's heights over a box, from samples. */
double
spreadOf(const PlanSlab& slab, const Eigen::AlignedBox2d& box)
{
  constexpr int samples = 9; // a side
  Eigen::AlignedBox1d heights;
  for (int k = 0; k < samples * samples; ++k) {
    const Eigen::Vector2d share(k / samples, k % samples);
    heights.extend(Eigen::Matrix<double, 1, 1>(
        slab.heightAt(box.min() + share.cwiseProduct(box.sizes()) / (samples - 1))));
  }
  return heights.sizes().x();
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

TriangleMesh
prismOn(const TriangleMesh& mesh,
        const std::function<double(const Eigen::Vector3d&)>& height_at)
{
  std::vector<std::size_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return prismOn(mesh, all, height_at);
}

TriangleMesh
lowered(TriangleMesh mesh, double height)
{
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex.z() -= height;
  return mesh;
}

} // namespace pcl::sedr::ifc
