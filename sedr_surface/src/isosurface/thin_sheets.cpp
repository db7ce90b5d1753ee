// SPDX-License-Identifier: BSD-3-Clause
#include "dual_surface.h"

#include "sedr_filters/src/base/parallel.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::sedr {
namespace {

constexpr float thickest = 2.f;  // cells; thicker sheets hold a layer of nodes
constexpr float thinnest = 0.1f; // cells; thinner sheets have no distinct sides
constexpr float opposite =
    -0.9f;                       // cosine of the angle between the normals: 154 degrees
constexpr float certain = 0.25f; // half-way between surface and far field

// The sign that a sheet implies for a node.
struct Vote {
  std::size_t node;
  float off; // distance of the node from the middle of the sheet, cells
  bool above;

  bool operator<(const Vote& other) const
  {
    return node != other.node ? node < other.node
           : off != other.off ? off < other.off
                              : above < other.above;
  }
};

class SheetFinder {
public:
  SheetFinder(const BandGrid& grid, const SortedSamples& samples, float spacing)
      : grid_(grid)
      , samples_(samples)
      , spacing_(spacing)
      , reach_(thickest + spacing)
  {}

  // Collects the votes of the samples of block `s` of the samples' grid.
  void collect(std::size_t s, std::vector<Vote>& votes)
  {
    around_.clear();
    samples_.gather(samples_.grid.at(s), reach_, around_);
    const std::size_t b = grid_.find(samples_.grid.at(s));
    for (const BlockSample& sample : around_) {
      const Eigen::Map<const Eigen::Array3f> place(sample.place);
      if ((place >= 0).all() && (place < 8).all()) // in the block itself
        for (const BlockSample& other : around_)
          vote(sample, other, b, votes);
    }
  }

private:
  // Adds votes for the nodes between two samples that face opposite ways.
  void vote(const BlockSample& sample,
            const BlockSample& opposed,
            std::size_t b,
            std::vector<Vote>& votes) const
  {
    using Vector = Eigen::Map<const Eigen::Vector3f>;
    const Vector place(sample.place);
    const Vector along(sample.normal);
    const Vector back(opposed.normal);
    if (along.dot(back) > opposite)
      return;
    const Eigen::Vector3f normal = (along - back).normalized();
    const Eigen::Vector3f way = Vector(opposed.place) - place;
    const float apart = way.dot(normal);
    if (std::abs(apart) >= thickest || std::abs(apart) < thinnest ||
        (way - apart * normal).norm() > spacing_)
      return;
    const Eigen::Vector3f middle = place + way / 2;
    // Deep enough that no path leads between two such nodes.
    const float depth = normal.cwiseAbs().sum() / 2;
    const float radius = 0.75f * spacing_;
    const float farthest = std::max(depth, radius);
    std::array<int, 3> low;
    std::array<int, 3> high;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = static_cast<int>(std::ceil(middle[static_cast<int>(k)] - farthest));
      high[k] = static_cast<int>(std::floor(middle[static_cast<int>(k)] + farthest));
    }
    for (int z = low[2]; z <= high[2]; ++z)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int x = low[0]; x <= high[0]; ++x) {
          const Eigen::Vector3f from =
              Eigen::Vector3f(static_cast<float>(x), static_cast<float>(y),
                              static_cast<float>(z)) -
              middle;
          const float off = std::abs(from.dot(normal));
          if (off > depth || from.squaredNorm() - off * off > radius * radius)
            continue;
          if (grid_.blockAt(b, x, y, z) < grid_.size())
            votes.push_back({grid_.valueAt(b, x, y, z), from.norm(), apart > 0});
        }
  }

  const BandGrid& grid_;
  const SortedSamples& samples_;
  float spacing_;
  float reach_;
  std::vector<BlockSample> around_;
};

} // namespace

void
keepThinSheets(const BandGrid& grid,
               const SortedSamples& samples,
               double spacing,
               unsigned threads,
               std::vector<float>& values)
{
  const std::size_t blocks = samples.grid.size();
  std::vector<std::vector<Vote>> parts((blocks + BandGrid::blocks_at_once - 1) /
                                       BandGrid::blocks_at_once);
  parallelBlocks(blocks, BandGrid::blocks_at_once, threads,
                 [&](std::size_t begin, std::size_t end) {
                   SheetFinder finder(grid, samples, static_cast<float>(spacing));
                   for (std::size_t s = begin; s < end; ++s)
                     finder.collect(s, parts[begin / BandGrid::blocks_at_once]);
                 });
  std::vector<Vote> votes;
  for (const auto& part : parts)
    votes.insert(votes.end(), part.begin(), part.end());
  std::sort(votes.begin(), votes.end());
  std::size_t last = std::numeric_limits<std::size_t>::max();
  for (const Vote& vote : votes) {
    if (vote.node == last)
      continue;
    last = vote.node; // the nearest sheet decides
    float& value = values[vote.node];
    if ((value > 0) != vote.above)
      value = vote.above ? certain : -certain;
  }
}

} // namespace pcl::sedr
