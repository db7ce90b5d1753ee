// SPDX-License-Identifier: BSD-3-Clause
#include "../mesh/mesh_repair.h"
#include "opening_reveals.h"

#include <pcl/sedr_surface/mesh_topology.h>

#include <algorithm>
#include <map>
#include <numeric>
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

} // namespace

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

} // namespace pcl::sedr
