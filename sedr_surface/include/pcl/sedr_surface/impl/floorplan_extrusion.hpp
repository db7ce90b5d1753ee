// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/impl/mesh_reconstruction.hpp>
#include <pcl/sedr_surface/mesh_intersection.h>

#include <set>
#include <sstream>
#include <utility>

namespace pcl {

template <typename PointT>
void
FloorplanExtrusion<PointT>::collectWarnings()
{
  for (const sedr::RoomSolidReport& report : reports_)
    for (const std::string& warning : report.warnings)
      warnings_.push_back("room " + std::to_string(report.room) + ": " + warning);
  std::set<std::pair<std::uint32_t, std::uint32_t>> crossing;
  for (const auto& [t, u] : sedr::findSelfIntersections(mesh_))
    crossing.insert({mesh_.rooms[t], mesh_.rooms[u]});
  for (const auto& [room, other] : crossing)
    warnings_.push_back(room == other
                            ? "room " + std::to_string(room) + " meets itself"
                            : "rooms " + std::to_string(room) + " and " +
                                  std::to_string(other) + " run into each other");
}

template <typename PointT>
std::string
FloorplanExtrusion<PointT>::inputProblem() const
{
  const auto check = [](double value, double low, double high, const char* name) {
    std::ostringstream text;
    if (!(value >= low && value <= high))
      text << "the " << name << " tolerance must lie from " << low << " to " << high
           << " m, it is " << value << " m";
    return text.str();
  };
  if (!plan_)
    return "no floor plan is set";
  if (plan_->rooms.empty())
    return "the floor plan has 0 rooms";
  const std::string problem = check(parameters_.chord_tolerance, 1e-6, 1, "chord");
  return problem.empty() ? check(parameters_.snap_tolerance, 0, 0.5, "snap") : problem;
}

template <typename PointT>
bool
FloorplanExtrusion<PointT>::run()
{
  this->clearError();
  mesh_ = sedr::TriangleMesh();
  elements_.clear();
  reports_.clear();
  warnings_.clear();
  closed_ = false;
  const std::string problem = inputProblem();
  if (!problem.empty())
    return fail("FloorplanExtrusion", problem);
  std::string failures;
  for (const sedr::PlanRoom& room : plan_->rooms) {
    sedr::TriangleMesh solid;
    reports_.push_back(sedr::extrudeRoom(room, parameters_, solid, elements_));
    mesh_.append(solid);
    if (!reports_.back().problem.empty())
      failures += (failures.empty() ? "room " : "; room ") + std::to_string(room.id) +
                  ": " + reports_.back().problem;
  }
  collectWarnings();
  closed_ = failures.empty();
  return closed_ || fail("FloorplanExtrusion", failures);
}

} // namespace pcl
