// SPDX-License-Identifier: BSD-3-Clause
#include "ifc_parts.h"
#include "level_slab.h"

#include <algorithm>

namespace pcl::sedr::ifc {
namespace {

/** @brief Returns what is between bottom and top of a niche that is not level, in the
 * frame of a wall, with z from its bottom. */
TriangleMesh
meshOf(const PlanNiche& niche, const PlanLoop& loop, const WallFrame& frame, double z)
{
  TriangleMesh foot = triangulated({loop}, {});
  const auto heightAt = [&](const PlanSlab& slab, const Eigen::Vector3d& p) {
    return slab.heightAt(frame.toPlan(p.head<2>())) - z;
  };
  for (Eigen::Vector3d& p : foot.vertices)
    p.z() = heightAt(niche.bottom, p);
  constexpr double min_height = 0.001;
  return prismOn(foot, allTriangles(foot), [&](const Eigen::Vector3d& p) {
    return std::max(heightAt(niche.top, p), p.z() + min_height);
  });
}

/** @brief Returns whether a niche, such as a blind before a window makes one, lies in
 * a gap of its wall, up to the accuracy of both. */
bool
isInGap(const WrittenGap& gap, const PlanLoop& niche, double bottom, double top)
{
  constexpr double off = 0.05;
  Eigen::AlignedBox2d plan(gap.box.plan.min().array() - off,
                           gap.box.plan.max().array() + off);
  return plan.contains(boundsOf(inFrame(niche, gap.box.frame))) &&
         bottom > gap.box.bottom - off && top < gap.box.top + off;
}

} // namespace

void
writeNiches(IfcDocument& document,
            std::vector<WrittenWall>& walls,
            const std::vector<WrittenGap>& gaps)
{
  for (std::size_t r = 0; r < document.plan.rooms.size(); ++r) {
    const PlanRoom& room = document.plan.rooms[r];
    for (std::size_t n = 0; n < room.niches.size(); ++n) {
      const PlanNiche& niche = room.niches[n];
      const std::string name = nameIn(room, "niche_" + std::to_string(n + 1));
      const Eigen::Vector2d middle = boundsOf(niche.boundary).center();
      const double bottom = niche.bottom.heightAt(middle);
      const double height = niche.top.heightAt(middle) - bottom;
      const bool is_level = levelOf(niche.bottom, boundsOf(niche.boundary)) &&
                            levelOf(niche.top, boundsOf(niche.boundary));
      // A solid leaves out a niche without height or depth.
      const IfcRoom& written = document.rooms[r];
      const bool is_built =
          written.solid.empty() ||
          !trianglesOn(written, {name + "_bottom", name + "_top"}).empty();
      std::size_t count = 0;
      for (WrittenWall& wall : walls) {
        const PlanLoop loop = inFrame(niche.boundary, wall.frame);
        if (!is_built || height <= 0 || bottom >= wall.top ||
            bottom + height <= wall.bottom ||
            commonArea(wall.profile, {loop}) <= no_area)
          continue;
        const double low = bottom - wall.bottom;
        if (std::any_of(gaps.begin(), gaps.end(), [&](const WrittenGap& gap) {
              return gap.wall == &wall && isInGap(gap, loop, low, low + height);
            })) {
          ++count;
          continue;
        }
        const std::string part = count == 0 ? "" : "_part_" + std::to_string(count + 1);
        writeOpening(document, wall, name + part,
                     is_level ? document.shapes.extrusion(loop, {}, low, height)
                              : document.shapes.faceSet(
                                    meshOf(niche, loop, wall.frame, wall.bottom)),
                     {loop, niche.bottom, niche.top, true});
        ++count;
      }
      if (count == 0)
        document.model.warnings.push_back(
            warningOf(WarningKind::IfcLoss, name + " is in no wall of the IFC"));
    }
  }
}

} // namespace pcl::sedr::ifc
