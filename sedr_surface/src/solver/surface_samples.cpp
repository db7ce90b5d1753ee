// SPDX-License-Identifier: BSD-3-Clause
#include "surface_samples.h"

#include "sedr_filters/src/base/quantiles.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <utility>

namespace pcl::sedr {

BandGrid::BandGrid(std::vector<Key> keys)
    : keys_(std::move(keys))
{
  std::sort(keys_.begin(), keys_.end());
  keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  neighbours_.resize(keys_.size());
  at_rim_.assign(keys_.size(), false);
  for (std::size_t b = 0; b < keys_.size(); ++b) {
    const Block block = at(b);
    for (std::size_t n = 0; n < 27; ++n) {
      const std::size_t other = find(around(block, n));
      neighbours_[b][n] = static_cast<std::uint32_t>(other);
      if (other == keys_.size())
        at_rim_[b] = true;
    }
  }
}

BandGrid::Key
BandGrid::keyOf(const Block& block)
{
  const auto part = [](std::int64_t c) { return static_cast<Key>(c + reach); };
  return part(block[2]) << 42 | part(block[1]) << 21 | part(block[0]);
}

BandGrid::Block
BandGrid::around(const Block& block, std::size_t n)
{
  const auto step = static_cast<std::int64_t>(n);
  return {block[0] + step % 3 - 1, block[1] + step / 3 % 3 - 1,
          block[2] + step / 9 - 1};
}

BandGrid::Block
BandGrid::blockOf(Key key)
{
  const auto part = [key](int shift) {
    return static_cast<std::int64_t>((key >> shift) & 0x1fffff) - reach;
  };
  return {part(0), part(21), part(42)};
}

std::size_t
BandGrid::find(const Block& block) const
{
  const Key key = keyOf(block);
  const auto found = std::lower_bound(keys_.begin(), keys_.end(), key);
  return found != keys_.end() && *found == key
             ? static_cast<std::size_t>(found - keys_.begin())
             : keys_.size();
}

bool
BandGrid::holdsCell(std::size_t b, int x, int y, int z) const
{
  for (int c = 0; at_rim_[b] && c < 8; ++c)
    if (blockAt(b, x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)) == size())
      return false;
  return true;
}

void
BandGrid::gatherHalo(const std::vector<float>& values, std::size_t b, float* halo) const
{
  const auto place = [](int i) { return i < 0 ? 0 : i > 7 ? 2 : 1; };
  for (int z = -1; z <= 8; ++z)
    for (int y = -1; y <= 8; ++y) {
      const std::size_t row = static_cast<std::size_t>(place(z) * 9 + place(y) * 3);
      const std::size_t offset = nodeIndex(0, y & 7, z & 7);
      const auto* blocks = &neighbours_[b][row];
      *halo++ = values[blocks[0] * nodes + offset + 7];
      std::memcpy(halo, &values[blocks[1] * nodes + offset], 8 * sizeof(float));
      halo += 8;
      *halo++ = values[blocks[2] * nodes + offset];
    }
}

namespace {

using Key = BandGrid::Key;

using KeyedSample = std::pair<Key, std::size_t>; ///< cube, index

Key
keyAt(const Eigen::Vector3d& position, double size)
{
  BandGrid::Block cube;
  for (int k = 0; k < 3; ++k)
    cube[static_cast<std::size_t>(k)] =
        static_cast<std::int64_t>(std::floor(position[k] / size));
  return BandGrid::keyOf(cube);
}

std::vector<KeyedSample>
sortedKeys(const std::vector<SurfaceSample>& samples, double size)
{
  std::vector<KeyedSample> order(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    order[i] = {keyAt(samples[i].position, size), i};
  std::sort(order.begin(), order.end());
  return order;
}

// Computes the weights of the three nodes around `place`; returns the first node.
int
splineWeights(float place, float* weights)
{
  const float nearest = std::floor(place + 0.5f);
  for (int i = 0; i < 3; ++i)
    weights[i] = quadraticSpline(nearest + static_cast<float>(i - 1) - place);
  return static_cast<int>(nearest) - 1;
}

// Calls visit(value, weight) for the places of the 27 values influenced by a sample of
// block `b`.
template <typename Visit>
void
forNodesAround(const BandGrid& grid, std::size_t b, const float* place, Visit visit)
{
  float w[3][3];
  int first[3];
  for (int k = 0; k < 3; ++k)
    first[k] = splineWeights(place[k], w[k]);
  for (int i = 0; i < 27; ++i) {
    const int step[3] = {i % 3, i / 3 % 3, i / 9};
    visit(grid.valueAt(b, first[0] + step[0], first[1] + step[1], first[2] + step[2]),
          w[0][step[0]] * w[1][step[1]] * w[2][step[2]]);
  }
}

// Adds the blocks around those that hold a sample.
BandGrid
widened(const BandGrid& grid)
{
  std::vector<Key> keys;
  for (std::size_t b = 0; b < grid.size(); ++b)
    for (std::size_t n = 0; n < 27; ++n)
      keys.push_back(BandGrid::keyOf(BandGrid::around(grid.at(b), n)));
  return BandGrid(std::move(keys));
}

// Returns the median spacing by area. Points twice as dense stand for a quarter of the
// area each. The weight of isolated points is limited.
double
medianByArea(const std::vector<double>& spacings)
{
  const double cap = 2 * middleValue(spacings);
  std::vector<Weighted> weighted;
  for (const double spacing : spacings)
    weighted.emplace_back(spacing, std::pow(std::min(spacing, cap), 2));
  return weightedQuantile(std::move(weighted), 0.5);
}

} // namespace

double
measureSpacing(const std::vector<OrientedPoint>& points)
{
  constexpr int neighbours = 8;
  if (points.size() < neighbours + 2)
    return 0;
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->reserve(points.size());
  for (const OrientedPoint& p : points)
    cloud->emplace_back(p.position.x(), p.position.y(), p.position.z());
  pcl::KdTreeFLANN<pcl::PointXYZ> tree(false);
  tree.setInputCloud(cloud);
  const std::size_t step = std::max<std::size_t>(1, points.size() / 2000);
  std::vector<double> spacings;
  pcl::Indices indices;
  std::vector<float> squared;
  for (std::size_t i = 0; i < points.size(); i += step) {
    tree.nearestKSearch((*cloud)[i], neighbours + 1, indices, squared);
    // The disc to the eighth neighbour counts as seven points: its rim counts half.
    spacings.push_back(std::sqrt(M_PI * squared.back() / (neighbours - 1)));
  }
  return medianByArea(spacings);
}

float
quadraticSpline(float t)
{
  t = std::abs(t);
  if (t < 0.5f)
    return 0.75f - t * t;
  return t < 1.5f ? 0.5f * (1.5f - t) * (1.5f - t) : 0.f;
}

void
SortedSamples::gather(const BandGrid::Block& block,
                      float reach,
                      std::vector<BlockSample>& around) const
{
  for (std::size_t n = 0; n < 27; ++n) {
    const BandGrid::Block step = BandGrid::around({0, 0, 0}, n);
    const std::size_t s = grid.find(BandGrid::around(block, n));
    for (std::size_t i = s < grid.size() ? starts[s] : 0;
         s < grid.size() && i < starts[s + 1]; ++i) {
      BlockSample sample = samples[i];
      bool is_near = true;
      for (std::size_t k = 0; k < 3; ++k) {
        sample.place[k] += static_cast<float>(BandGrid::edge * step[k]);
        sample.normal[k] /= sample.area;
        is_near = is_near && sample.place[k] > -reach && sample.place[k] < 8 + reach;
      }
      if (is_near)
        around.push_back(sample);
    }
  }
}

SortedSamples
sortSamples(const std::vector<SurfaceSample>& samples, double scale)
{
  const double size = scale * static_cast<double>(BandGrid::edge);
  SortedSamples sorted;
  std::vector<Key> keys;
  for (const auto& [key, index] : sortedKeys(samples, size)) {
    if (keys.empty() || keys.back() != key) {
      keys.push_back(key);
      sorted.starts.push_back(sorted.samples.size());
    }
    const SurfaceSample& sample = samples[index];
    const BandGrid::Block block = BandGrid::blockOf(key);
    BlockSample local;
    for (int k = 0; k < 3; ++k) {
      const double start =
          size * static_cast<double>(block[static_cast<std::size_t>(k)]);
      local.place[k] = std::min(
          static_cast<float>((sample.position[k] - start) / scale), 7.9999995f);
      local.normal[k] = sample.normal[k] / static_cast<float>(scale * scale);
    }
    local.area = sample.area / static_cast<float>(scale * scale);
    sorted.samples.push_back(local);
  }
  sorted.starts.push_back(sorted.samples.size());
  sorted.grid = BandGrid(std::move(keys));
  return sorted;
}

std::vector<SurfaceSample>
mergeSamples(const std::vector<SurfaceSample>& samples, double size)
{
  std::vector<SurfaceSample> merged;
  const auto order = sortedKeys(samples, size);
  for (std::size_t i = 0; i < order.size();) {
    SurfaceSample sum{Eigen::Vector3d::Zero(), Eigen::Vector3f::Zero(), 0};
    const Key key = order[i].first;
    for (; i < order.size() && order[i].first == key; ++i) {
      const SurfaceSample& sample = samples[order[i].second];
      sum.position += static_cast<double>(sample.area) * sample.position;
      sum.normal += sample.normal;
      sum.area += sample.area;
    }
    sum.position /= static_cast<double>(sum.area);
    merged.push_back(sum);
  }
  return merged;
}

void
setAreas(std::vector<SurfaceSample>& samples, double spacing)
{
  // A disc of four neighbours; a smaller one would pick up the sampling pattern.
  const double scale = 2 * spacing;
  const double size = scale * static_cast<double>(BandGrid::edge);
  // Mean density of a plane with one sample per square cell, over all its positions.
  constexpr float plane = 0.55f;
  const SortedSamples sorted = sortSamples(samples, scale);
  const BandGrid grid = widened(sorted.grid);
  std::vector<float> density(grid.valueCount(), 0.f);
  for (std::size_t s = 0; s < sorted.grid.size(); ++s) {
    const std::size_t own = grid.find(sorted.grid.at(s));
    for (std::size_t i = sorted.starts[s]; i < sorted.starts[s + 1]; ++i)
      forNodesAround(
          grid, own, sorted.samples[i].place,
          [&](std::size_t value, float weight) { density[value] += weight; });
  }
  for (SurfaceSample& sample : samples) {
    const BandGrid::Block block = BandGrid::blockOf(keyAt(sample.position, size));
    float place[3];
    for (int k = 0; k < 3; ++k)
      place[k] = static_cast<float>(
          sample.position[k] / scale -
          static_cast<double>(BandGrid::edge * block[static_cast<std::size_t>(k)]));
    float sum = 0;
    forNodesAround(grid, grid.find(block), place, [&](std::size_t value, float weight) {
      sum += weight * density[value];
    });
    sample.area = plane / sum * static_cast<float>(scale * scale);
    sample.normal *= sample.area;
  }
}

} // namespace pcl::sedr
