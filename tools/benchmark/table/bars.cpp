// SPDX-License-Identifier: BSD-3-Clause
#include "bars.h"

#include "benchmark/runs/run_row.h"
#include "formatted.h"

#include <algorithm>
#include <array>

namespace pcl::sedr::benchmark {

namespace {

/** @brief Collects the misses of a row. An unknown figure misses its bar. */
class Misses {
public:
  void add(Bar bar, const std::string& text) { all_.push_back({bar, text}); }

  void atLeast(Bar bar, double share, double least, const char* what)
  {
    if (!(share >= least))
      add(bar, what + formatted(" %.2f %% < %.0f %%", 100 * share, 100 * least));
  }

  void atMost(Bar bar, double share, double most, const char* what)
  {
    if (!(share <= most))
      add(bar, what + formatted(" %.2f %% > %.1f %%", 100 * share, 100 * most));
  }

  const std::vector<Miss>& all() const { return all_; }

private:
  std::vector<Miss> all_;
};

void
checkRooms(const RoomFigures& rooms, Misses& misses)
{
  if (rooms.rooms_found != rooms.rooms_true)
    misses.add(Bar::Rooms, std::to_string(rooms.rooms_found) + " rooms of " +
                               std::to_string(rooms.rooms_true));
  else if (rooms.rooms_matched != rooms.rooms_true)
    misses.add(Bar::Rooms, std::to_string(rooms.rooms_matched) + " of " +
                               std::to_string(rooms.rooms_true) +
                               " rooms where they should be");
}

void
checkModel(const RunRow& row, Misses& misses)
{
  const ModelFigures& mesh = row.mesh;
  if (!mesh.closed_manifold.value_or(false))
    misses.add(Bar::Closed,
               mesh.closed.value_or(false) ? "not manifold" : "not closed");
  if (mesh.components != row.rooms.rooms_found)
    misses.add(Bar::Components, std::to_string(mesh.components.value_or(0)) +
                                    " components for " +
                                    std::to_string(row.rooms.rooms_found) + " rooms");
  const double limit = meanLimit(row.noise);
  if (!(mesh.truth_to_mesh_mean <= limit))
    misses.add(Bar::Mean, formatted("mean %.3f cm > %.3f cm",
                                    100 * mesh.truth_to_mesh_mean, 100 * limit));
  misses.atLeast(Bar::Within1cm, mesh.truth_within_1cm, min_within_1cm, "within 1 cm");
  misses.atLeast(Bar::Within5cm, mesh.truth_within_5cm, min_within_5cm, "within 5 cm");
  misses.atMost(Bar::ModelBeyond5cm, mesh.mesh_beyond_5cm, max_beyond_5cm,
                "model beyond 5 cm");
  if (mesh.detail_within_5cm < min_detail_within_5cm) // NaN without details
    misses.atLeast(Bar::DetailZone, mesh.detail_within_5cm, min_detail_within_5cm,
                   "details within 5 cm");
}

void
checkStructure(const StructureFigures& structure, Misses& misses)
{
  misses.atMost(Bar::PointsBeyond5cm, structure.points_beyond_5cm, max_beyond_5cm,
                "points beyond 5 cm");
  misses.atLeast(Bar::Covered, structure.truth_covered, min_within_5cm,
                 "truth covered");
}

void
checkSolid(const RunRow& row, Misses& misses)
{
  const SolidFigures& solid = row.solid;
  if (!solid.isMeasured())
    return misses.add(Bar::SolidClosed, "no solid");
  if (!solid.closed_manifold.value_or(false) ||
      solid.components < row.rooms.rooms_found)
    misses.add(Bar::SolidClosed, "solid not closed");
  if (solid.self_intersections != 0)
    misses.add(Bar::SolidCrossing,
               std::to_string(solid.self_intersections.value_or(0)) +
                   " pairs of the solid's triangles meet");
  const SolidLimits limits = solidLimits(row.noise);
  if (!(solid.truth_to_solid_mean <= limits.mean))
    misses.add(Bar::SolidMean,
               formatted("solid: mean %.4f cm > %.2f cm",
                         100 * solid.truth_to_solid_mean, 100 * limits.mean));
  if (!(solid.truth_to_solid_max <= limits.max))
    misses.add(Bar::SolidMax,
               formatted("solid: max %.3f cm > %.1f cm", 100 * solid.truth_to_solid_max,
                         100 * limits.max));
  misses.atMost(Bar::SolidVolume, solid.volume_error, max_volume_error,
                "solid's volume");
  misses.atMost(Bar::WallArea, solid.wall_area_error, max_wall_area_error,
                "wall surface");
  if (row.plan.arcs_true == 0 && solid.triangles > max_straight_triangles)
    misses.add(Bar::SolidTriangles,
               std::to_string(*solid.triangles) + " triangles of straight walls");
}

void
checkPlan(const RunRow& row, Misses& misses)
{
  misses.atMost(Bar::PlanArea, row.rooms.area_error, max_area_error, "area");
  const PlanFigures& plan = row.plan;
  if (plan.radius_error > max_radius_error) // NaN without arcs
    misses.atMost(Bar::Radius, plan.radius_error, max_radius_error, "radius");
  if (plan.rooms_with_other_corners != 0)
    misses.add(Bar::Corners, std::to_string(plan.corners_found.value_or(0)) +
                                 " corners of " +
                                 std::to_string(plan.corners_true.value_or(0)));
}

} // namespace

SolidLimits
solidLimits(double noise)
{
  if (noise <= 0.001)
    return {0.0001, 0.001};
  if (noise <= 0.01)
    return {0.0003, 0.005};
  return {0.001, 0.01};
}

double
meanLimit(double noise)
{
  constexpr double quiet = 0.001;
  constexpr double loud = 0.02;
  constexpr double limit_when_quiet = 0.002;
  constexpr double limit_when_loud = 0.004;
  const double share = std::clamp((noise - quiet) / (loud - quiet), 0.0, 1.0);
  return limit_when_quiet + share * (limit_when_loud - limit_when_quiet);
}

std::string
nameOf(Bar bar)
{
  static constexpr std::array<const char*, 21> names{
      "failed",    "rooms",        "closed",         "components",   "mean",
      "1 cm",      "5 cm",         "model > 5 cm",   "details",      "points > 5 cm",
      "covered",   "solid closed", "solid crossing", "solid mean",   "solid max",
      "triangles", "area",         "solid volume",   "wall surface", "radius",
      "corners"};
  return names[static_cast<std::size_t>(bar)];
}

std::vector<Miss>
missedBars(const RunRow& row)
{
  Misses misses;
  if (!row.failure.empty()) {
    misses.add(Bar::Done, "failed");
    return misses.all();
  }
  checkRooms(row.rooms, misses);
  if (row.with_mesh)
    checkModel(row, misses);
  else
    checkStructure(row.structure, misses);
  checkSolid(row, misses);
  checkPlan(row, misses);
  return misses.all();
}

} // namespace pcl::sedr::benchmark
