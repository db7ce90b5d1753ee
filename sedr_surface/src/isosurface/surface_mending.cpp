// SPDX-License-Identifier: BSD-3-Clause
#include "dual_surface.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace pcl::sedr {
namespace {

constexpr int gentle_rounds = 8;

// Returns the corners that are connected along edges of a cell with the lowest one of
// `set`, a bit for each corner.
unsigned
connectedPart(unsigned set)
{
  unsigned part = set & (~set + 1);
  for (int step = 0; step < 8; ++step)
    part |= set & ((part & 0x55) << 1 | (part & 0xaa) >> 1 | (part & 0x33) << 2 |
                   (part & 0xcc) >> 2 | (part & 0x0f) << 4 | (part & 0xf0) >> 4);
  return part;
}

// Returns for each set of corners above zero whether a cell is well composed: both its
// corners above zero and the others are connected.
std::array<bool, 256>
wellComposedSets()
{
  std::array<bool, 256> is_good{};
  for (unsigned above = 0; above < 256; ++above)
    is_good[above] =
        connectedPart(above) == above && connectedPart(255 - above) == 255 - above;
  return is_good;
}

// Returns the corner of a cell whose sign must change, or -1: the one with the value
// nearest to zero, if possible of those that make the cell well composed.
int
findFlip(const float* lowest, bool gentle)
{
  static const std::array<bool, 256> is_good = wellComposedSets();
  unsigned above = 0;
  for (unsigned c = 0; c < 8; ++c)
    above |= lowest[corners[c]] > 0 ? 1u << c : 0u;
  if (is_good[above])
    return -1;
  int best = -1;
  std::pair<bool, float> least;
  for (unsigned c = 0; c < 8; ++c) {
    const std::pair<bool, float> cost(!is_good[above ^ 1u << c],
                                      std::abs(lowest[corners[c]]));
    if ((gentle || (above >> c & 1u) != 0) && (best < 0 || cost < least)) {
      best = static_cast<int>(c);
      least = cost;
    }
  }
  return best;
}

// Appends the places of the values of a block's cells whose sign must change.
void
findFlips(const BandGrid& grid,
          const std::vector<float>& values,
          std::size_t b,
          bool gentle,
          std::vector<std::size_t>& flips)
{
  float halo[BandGrid::halo_nodes];
  grid.gatherHalo(values, b, halo);
  if (!isHaloCrossed(halo, 0))
    return;
  for (int i = 0; i < static_cast<int>(BandGrid::nodes); ++i) {
    const int x = i & 7;
    const int y = i >> 3 & 7;
    const int z = i >> 6;
    const int flip = findFlip(halo + BandGrid::haloIndex(x, y, z), gentle);
    if (flip >= 0 && grid.holdsCell(b, x, y, z))
      flips.push_back(
          grid.valueAt(b, x + (flip & 1), y + (flip >> 1 & 1), z + (flip >> 2)));
  }
}

} // namespace

void
makeWellComposed(const BandGrid& grid, std::vector<float>& values, unsigned threads)
{
  constexpr std::size_t part = 64;
  std::vector<bool> is_suspect(grid.size(), true);
  for (int round = 0;; ++round) {
    std::vector<std::vector<std::size_t>> flips((grid.size() + part - 1) / part);
    parallelFor(grid.size(), part, threads, [&](std::size_t b) {
      if (is_suspect[b])
        findFlips(grid, values, b, round < gentle_rounds, flips[b / part]);
    });
    std::vector<std::size_t> all;
    for (const auto& list : flips)
      all.insert(all.end(), list.begin(), list.end());
    if (all.empty())
      return;
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    is_suspect.assign(grid.size(), false);
    for (const std::size_t place : all) {
      // Near zero, so that it may easily change again.
      values[place] = values[place] > 0 ? -1e-4f : 1e-4f;
      for (const std::size_t b : grid.neighbours(place / BandGrid::nodes))
        if (b < grid.size())
          is_suspect[b] = true;
    }
  }
}

namespace {

// Cosine between a triangle and its vertices' normals below which it is a fold.
constexpr double fold = 0.1;

class Mender {
public:
  Mender(TriangleMesh& mesh, std::vector<SurfaceVertex>& vertices, double min_height)
      : mesh_(mesh)
      , vertices_(vertices)
      , min_height_(min_height)
      , alive_(mesh.triangles.size(), true)
      , around_(mesh.vertices.size())
  {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      for (const auto v : mesh.triangles[t])
        around_[v].push_back(t);
  }

  // Collapses edges up to a length, and removes the triangles that vanish.
  void run(double longest)
  {
    constexpr int strict_rounds = 8;
    constexpr int max_rounds = 14;
    std::vector<std::uint32_t> bad;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      if (cost(t) > 0)
        bad.push_back(t);
    for (int round = 0; round < max_rounds && !bad.empty(); ++round) {
      strict_ = round < strict_rounds;
      std::vector<std::uint32_t> next;
      for (const auto t : bad)
        if (alive_[t] && cost(t) > 0 && !mend(t, longest, next))
          next.push_back(t);
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
      bad = std::move(next);
    }
    mesh_.keepTriangles(alive_);
  }

private:
  struct Step {
    int gain = 0;
    double length = 0;
    std::uint32_t kept = 0;
    std::uint32_t gone = 0;
  };

  // Improves the surroundings of triangle t by the best collapse. Appends the triangles
  // that changed.
  bool mend(std::uint32_t t, double longest, std::vector<std::uint32_t>& changed)
  {
    Step best;
    const Triangle triangle = mesh_.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      consider(triangle[i], triangle[(i + 1) % 3], longest, best);
      consider(triangle[(i + 1) % 3], triangle[i], longest, best);
    }
    if (best.gain <= 0)
      return false;
    collapse(best.kept, best.gone);
    const auto& ring = around_[best.kept];
    changed.insert(changed.end(), ring.begin(), ring.end());
    return true;
  }

  bool uses(std::uint32_t t, std::uint32_t v) const
  {
    const Triangle& triangle = mesh_.triangles[t];
    return triangle[0] == v || triangle[1] == v || triangle[2] == v;
  }

  // Returns the badness of a triangle with these corners.
  int cost(const Eigen::Vector3d* p, const Eigen::Vector3d& towards) const
  {
    const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
    const double longest =
        std::max({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
    const double size = normal.norm();
    return (size < min_height_ * longest ? 1 : 0) +
           (normal.dot(towards) < fold * size * towards.norm() ? 2 : 0);
  }

  int cost(std::uint32_t t) const { return cost(t, 0, 0); }

  // As above, with vertex `from` replaced by `to`.
  int cost(std::uint32_t t, std::uint32_t from, std::uint32_t to) const
  {
    Eigen::Vector3d p[3];
    Eigen::Vector3d towards = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t corner = mesh_.triangles[t][i];
      const std::uint32_t v = corner == from ? to : corner;
      p[i] = mesh_.vertices[v];
      towards += vertices_[v].normal.cast<double>();
    }
    return cost(p, towards);
  }

  // Returns the other vertices of the triangles at a vertex, increasing.
  std::vector<std::uint32_t> neighbours(std::uint32_t v) const
  {
    std::vector<std::uint32_t> found;
    for (const auto t : around_[v])
      for (const auto other : mesh_.triangles[t])
        if (other != v)
          found.push_back(other);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  // Returns whether an edge may collapse: its ends have just two common neighbours,
  // each with one neighbour to spare.
  bool keepsTopology(std::uint32_t a, std::uint32_t b) const
  {
    const auto of_a = neighbours(a);
    const auto of_b = neighbours(b);
    std::vector<std::uint32_t> common;
    std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                          std::back_inserter(common));
    return common.size() == 2 && around_[common[0]].size() > 3 &&
           around_[common[1]].size() > 3;
  }

  // Returns whether `v` stays on its face or edge when it moves to `other`.
  bool mayGoTo(std::uint32_t v, std::uint32_t other) const
  {
    const SurfaceVertex& from = vertices_[v];
    if (strict_ && from.sharpness > vertices_[other].sharpness)
      return false;
    const Eigen::Vector3d way = mesh_.vertices[other] - mesh_.vertices[v];
    double off = way.norm();
    if (from.sharpness == 0)
      off = std::abs(way.dot(from.normal.cast<double>()));
    else if (from.sharpness == 1)
      off = way.cross(from.line.cast<double>()).norm();
    return off < (strict_ ? 0.1 * std::max(way.norm(), 0.5) : 0.5);
  }

  // Considers collapsing `gone` into `kept`.
  void
  consider(std::uint32_t kept, std::uint32_t gone, double longest, Step& best) const
  {
    if (!mayGoTo(gone, kept))
      return;
    const double length = (mesh_.vertices[gone] - mesh_.vertices[kept]).norm();
    if (length > longest)
      return;
    int gain = 0;
    for (const auto t : around_[gone])
      gain += cost(t) - (uses(t, kept) ? 0 : cost(t, gone, kept));
    if (gain <= 0 || gain < best.gain || (gain == best.gain && length >= best.length) ||
        !keepsTopology(kept, gone))
      return;
    best = {gain, length, kept, gone};
  }

  void collapse(std::uint32_t kept, std::uint32_t gone)
  {
    const auto ring = around_[gone];
    for (const auto t : ring) {
      if (uses(t, kept)) {
        alive_[t] = false;
        for (const auto v : mesh_.triangles[t])
          around_[v].erase(std::find(around_[v].begin(), around_[v].end(), t));
        continue;
      }
      for (auto& v : mesh_.triangles[t])
        if (v == gone)
          v = kept;
      around_[kept].push_back(t);
    }
  }

  TriangleMesh& mesh_;
  std::vector<SurfaceVertex>& vertices_;
  double min_height_;
  std::vector<bool> alive_;
  std::vector<std::vector<std::uint32_t>> around_; // triangles, per vertex
  // Vertices must stay on their edge or face; otherwise they may move less than half a
  // cell off it.
  bool strict_ = true;
};

} // namespace

void
mendSurface(TriangleMesh& mesh,
            std::vector<SurfaceVertex>& vertices,
            double min_height,
            double longest)
{
  Mender(mesh, vertices, min_height).run(longest);
}

} // namespace pcl::sedr
