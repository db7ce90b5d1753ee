// SPDX-License-Identifier: BSD-3-Clause
#include "../mesh/mesh_repair.h"
#include "room_layers.h"
#include "sedr_filters/src/base/number_text.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_surface/impl/floorplan_extrusion.hpp>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief Joins pairs of caps of a mesh: the faces at which reveals end in the middle
 * of their wall. */
class Joints {
public:
  explicit Joints(TriangleMesh& mesh)
      : mesh_(mesh)
      , joined_(mesh.vertices.size())
      , is_kept_(mesh.triangles.size(), true)
  {
    std::iota(joined_.begin(), joined_.end(), 0u);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      faces_[mesh.elements[t]].push_back(t);
  }

  bool has(std::uint32_t element) const { return faces_.count(element) > 0; }

  /** @brief Joins two caps if they have the same rim. */
  bool join(std::uint32_t element, std::uint32_t other)
  {
    if (!has(element) || !has(other))
      return false;
    const std::set<MeshEdge> a = rimOfFace(element);
    const std::set<MeshEdge> b = rimOfFace(other);
    std::map<std::uint32_t, std::uint32_t> mate; // of b's corners
    std::set<std::uint32_t> taken;
    for (const MeshEdge& edge : b) {
      const std::uint32_t v = edge.first;
      const std::uint32_t nearest =
          std::min_element(a.begin(), a.end(),
                           [&](const MeshEdge& p, const MeshEdge& q) {
                             return distance(p.first, v) < distance(q.first, v);
                           })
              ->first;
      if (distance(nearest, v) > near || !taken.insert(nearest).second)
        return false;
      mate[v] = nearest;
    }
    if (a.size() != b.size() ||
        std::any_of(b.begin(), b.end(), [&](const MeshEdge& edge) {
          return a.count({mate[edge.second], mate[edge.first]}) == 0;
        }))
      return false;
    for (const auto& [from, to] : mate)
      joined_[find(from)] = find(to);
    for (const std::uint32_t face : {element, other})
      for (const std::size_t t : faces_[face])
        is_kept_[t] = false;
    return true;
  }

  void apply()
  {
    for (Triangle& triangle : mesh_.triangles)
      for (std::uint32_t& v : triangle)
        v = find(v);
    mesh_.keepTriangles(is_kept_);
    mesh_.removeUnusedVertices();
  }

private:
  static constexpr double near = 0.005; ///< of two corners that are one, metres

  double distance(std::uint32_t a, std::uint32_t b) const
  {
    return (mesh_.vertices[a] - mesh_.vertices[b]).norm();
  }

  std::set<MeshEdge> rimOfFace(std::uint32_t element) const
  {
    std::vector<Triangle> face;
    for (const std::size_t t : faces_.at(element))
      face.push_back(mesh_.triangles[t]);
    return rimOf(face);
  }

  std::uint32_t find(std::uint32_t v) const
  {
    while (joined_[v] != v)
      v = joined_[v];
    return v;
  }

  TriangleMesh& mesh_;
  std::map<std::uint32_t, std::vector<std::size_t>> faces_; ///< triangles by element
  std::vector<std::uint32_t> joined_; ///< vertex that each has become
  std::vector<bool> is_kept_;         ///< triangles
};

/** @brief Removes the faces at which the two reveals of an opening end, and joins their
 * rims, so that a door joins the solids of two rooms. Does nothing if that would not
 * leave a closed manifold.
 * @param elements with names from RevealedPlan::named()
 * @param[in,out] solids of all rooms
 * @param[in,out] warnings the openings that stay closed */
void
joinReveals(const RevealedPlan& plan,
            const std::vector<SolidElement>& elements,
            TriangleMesh& solids,
            std::vector<PlanWarning>& warnings)
{
  std::map<std::string, std::uint32_t> number;
  for (std::size_t e = 0; e < elements.size(); ++e)
    number[elements[e].name] = static_cast<std::uint32_t>(e + 1);
  TriangleMesh joined = solids;
  Joints joints(joined);
  const std::size_t openings = plan.is_open.size();
  std::vector<bool> is_cut = plan.is_open;
  const auto faceOf = [&](const OpeningReveal& reveal, const char* face) {
    return number["room_" + std::to_string(plan.rooms[reveal.room].id) + "_opening_" +
                  std::to_string(reveal.opening + 1) + face];
  };
  std::map<std::size_t, OpeningReveal> first; // of two that are joined
  for (const OpeningReveal& reveal : plan.reveals) {
    const std::uint32_t cap = faceOf(reveal, "_side_1");
    const auto [known, is_new] = first.emplace(reveal.opening, reveal);
    if (!reveal.is_joined)
      is_cut[reveal.opening] = joints.has(cap);
    else if (!is_new && known->second.room == reveal.room) // no face between them
      is_cut[reveal.opening] = joints.has(faceOf(reveal, "_bottom"));
    else if (!is_new)
      is_cut[reveal.opening] = joints.join(faceOf(known->second, "_side_1"), cap);
  }
  joints.apply();
  if (!solids.empty() && checkTopology(joined).isClosedManifold())
    solids = std::move(joined);
  else
    for (const OpeningReveal& reveal : plan.reveals)
      is_cut[reveal.opening] = is_cut[reveal.opening] && !reveal.is_joined;
  std::string closed;
  for (std::size_t k = 0; k < openings; ++k)
    if (!is_cut[k])
      closed += (closed.empty() ? "" : ", ") + std::to_string(k + 1);
  if (!closed.empty())
    warnings.push_back(
        warningOf(WarningKind::OpeningClosed, closed,
                  {static_cast<double>(std::count(is_cut.begin(), is_cut.end(), false)),
                   static_cast<double>(openings)}));
}

/** @brief Adds a warning for each pair of rooms that overlap. Rooms without a wall
 * between them, as of one that was split, lie back to back. */
void
warnOfCrossings(const TriangleMesh& mesh, std::vector<PlanWarning>& warnings)
{
  std::set<std::pair<std::uint32_t, std::uint32_t>> crossing;
  const auto areBackToBack = [&](std::uint32_t t, std::uint32_t u) {
    return mesh.rooms[t] != mesh.rooms[u] &&
           mesh.scaledNormal(t).normalized().dot(mesh.scaledNormal(u).normalized()) <
               -1 + 1e-9;
  };
  for (const auto& [t, u] : findSelfIntersections(mesh))
    if (!areBackToBack(t, u))
      crossing.insert({mesh.rooms[t], mesh.rooms[u]});
  for (const auto& [room, other] : crossing)
    warnings.push_back({WarningKind::Crossing, {static_cast<double>(other)}, room});
}

} // namespace

std::string
extrudePlan(const Floorplan* plan, const SolidParameters& parameters, PlanSolids solids)
{
  if (!plan)
    return "no floor plan is set";
  if (plan->rooms.empty())
    return "the floor plan has 0 rooms";
  const double tolerance = parameters.chord_tolerance;
  if (!(tolerance >= 1e-6 && tolerance <= 1))
    return "the chord tolerance must lie from 1e-06 to 1 m, it is " +
           numberText(tolerance) + " m";
  std::string problem;
  std::optional<RevealedPlan> cut;
  if (parameters.cut_openings)
    cut.emplace(*plan);
  for (const PlanRoom& room : cut ? cut->rooms : plan->rooms) {
    TriangleMesh solid;
    const RoomSolidReport report =
        extrudeRoom(room, parameters, solid, solids.elements);
    const std::string name = "room " + std::to_string(room.id) + ": ";
    solids.mesh.append(solid);
    if (!report.problem.empty())
      problem += (problem.empty() ? "" : "; ") + name + report.problem;
    for (PlanWarning warning : report.warnings) {
      warning.room = room.id;
      if (cut)
        warning.reason = cut->named(warning.reason);
      solids.warnings.push_back(warning);
    }
    solids.reports.push_back(report);
  }
  if (cut) {
    for (SolidElement& element : solids.elements)
      element.name = cut->named(element.name);
    joinReveals(*cut, solids.elements, solids.mesh, solids.warnings);
  }
  warnOfCrossings(solids.mesh, solids.warnings);
  return problem;
}

} // namespace pcl::sedr

PCL_INSTANTIATE(FloorplanExtrusion, SEDR_POINT_TYPES)
