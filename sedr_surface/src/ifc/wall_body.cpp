// SPDX-License-Identifier: BSD-3-Clause
#include "wall_body.h"

#include "../walls/wall_band.h"
#include "level_slab.h"
#include "step_file.h"

#include "sedr_filters/src/plan/plan_geometry.h"

#include <algorithm>
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

PlanArea
profileOf(const WallSite& site)
{
  constexpr double rounding = 1e-5; // square metres
  std::vector<PlanArea> areas;
  for (const std::size_t r : site.near) {
    const PlanRoom& room = site.plan.rooms[r];
    const PlanArea area = site.areaOf(room);
    if (shareHeights(room, site.plan.rooms[site.wall.face.room]) &&
        commonArea(site.band, area) > rounding)
      areas.push_back(area);
  }
  return areas.empty() ? site.band : largestPartOutside(site.band, areas);
}

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
  TriangleMesh mesh = prismOn(foot, allTriangles(foot), [&](const Eigen::Vector3d& p) {
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

} // namespace pcl::sedr::ifc
