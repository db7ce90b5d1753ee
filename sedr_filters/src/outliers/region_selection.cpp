// SPDX-License-Identifier: BSD-3-Clause
#include "region_selection.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr std::size_t unlabelled = CellSet::npos;

/** @brief Positions of the eight neighbours of each cell in the set, npos if absent. */
using Neighbours = std::vector<std::array<std::size_t, 8>>;

Neighbours
neighboursOf(const CellSet& cells)
{
  constexpr std::array<Cell, 8> steps{Cell{-1, -1}, Cell{0, -1}, Cell{1, -1},
                                      Cell{-1, 0},  Cell{1, 0},  Cell{-1, 1},
                                      Cell{0, 1},   Cell{1, 1}};
  Neighbours neighbours(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t k = 0; k < steps.size(); ++k)
      neighbours[i][k] = cells.find({cells[i].x + steps[k].x, cells[i].y + steps[k].y});
  return neighbours;
}

/** @brief Returns for each cell how many erosions of the set it survives, up to `most`:
 * the square of 2 depth + 1 cells around it is full. */
std::vector<int>
depthsOf(const Neighbours& neighbours, int most)
{
  std::vector<int> depth(neighbours.size(), 0);
  for (int step = 1; step <= most; ++step) {
    const std::vector<int> before = depth;
    for (std::size_t i = 0; i < depth.size(); ++i)
      if (std::all_of(neighbours[i].begin(), neighbours[i].end(), [&](std::size_t n) {
            return n != CellSet::npos && before[n] == step - 1;
          }))
        depth[i] = before[i] == step - 1 ? step : before[i];
  }
  return depth;
}

/** @brief Grows labels over unlabelled cells at least `least` deep, ring by ring; where
 * several labels meet, the smallest wins. */
void
growRings(const Neighbours& neighbours,
          const std::vector<int>& depth,
          int least,
          std::vector<std::size_t>& label)
{
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < label.size(); ++i)
    if (label[i] != unlabelled)
      front.push_back(i);
  while (!front.empty()) {
    std::vector<std::size_t> next;
    std::vector<std::size_t> claims;
    for (const std::size_t i : front)
      for (const std::size_t n : neighbours[i])
        if (n != CellSet::npos && label[n] == unlabelled && depth[n] >= least)
          next.push_back(n);
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    for (const std::size_t i : next) {
      std::size_t smallest = unlabelled;
      for (const std::size_t n : neighbours[i])
        if (n != CellSet::npos)
          smallest = std::min(smallest, label[n]);
      claims.push_back(smallest);
    }
    for (std::size_t k = 0; k < next.size(); ++k)
      label[next[k]] = claims[k];
    front.swap(next);
  }
}

/** @brief Labels each eight-connected region of the unlabelled cells at least `least`
 * deep, from `count` on. */
void
seedRegions(const CellSet& cells,
            const std::vector<int>& depth,
            int least,
            std::size_t& count,
            std::vector<std::size_t>& label)
{
  std::vector<std::size_t> positions;
  std::vector<CellKey> keys;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (label[i] == unlabelled && depth[i] >= least) {
      positions.push_back(i);
      keys.push_back(cells.keys()[i]);
    }
  const CellRegions regions = labelRegions(CellSet(std::move(keys)));
  for (std::size_t k = 0; k < positions.size(); ++k)
    label[positions[k]] = count + regions.label[k];
  count += regions.sizes.size();
}

/** @brief Checks for a connected part of at least `width` cells in x or y. */
bool
hasFront(const CellSet& cells, int width)
{
  const CellRegions pieces = labelRegions(cells);
  std::vector<Eigen::AlignedBox2i> boxes(pieces.sizes.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    boxes[pieces.label[i]].extend(Eigen::Vector2i(cells[i].x, cells[i].y));
  return std::any_of(boxes.begin(), boxes.end(), [&](const Eigen::AlignedBox2i& box) {
    return box.sizes().maxCoeff() + 1 >= width;
  });
}

/** @brief Joins labels whose cells touch along a front of `width` cells: they were
 * separated by holes in the scan, not by a neck. */
void
joinAlongFronts(const CellSet& cells,
                const Neighbours& neighbours,
                int width,
                std::vector<std::size_t>& label)
{
  std::map<std::pair<std::size_t, std::size_t>, std::vector<CellKey>> contacts;
  for (std::size_t i = 0; i < label.size(); ++i)
    for (const std::size_t n : neighbours[i])
      if (n != CellSet::npos && label[n] != label[i])
        contacts[std::minmax(label[n], label[i])].push_back(cells.keys()[i]);
  std::map<std::size_t, std::size_t> joined;
  const auto root = [&](std::size_t l) {
    for (auto it = joined.find(l); it != joined.end(); it = joined.find(l))
      l = it->second;
    return l;
  };
  for (const auto& contact : contacts) {
    const std::size_t a = root(contact.first.first);
    const std::size_t b = root(contact.first.second);
    if (a != b && hasFront(CellSet(contact.second), width))
      joined[std::max(a, b)] = std::min(a, b);
  }
  for (auto& l : label)
    l = root(l);
}

/** @brief Assigns parts under `minimum_part` cells to the larger parts around them. */
void
absorbSmallParts(const Neighbours& neighbours,
                 const std::vector<int>& depth,
                 std::size_t minimum_part,
                 std::vector<std::size_t>& label)
{
  std::map<std::size_t, std::size_t> sizes;
  for (const std::size_t l : label)
    ++sizes[l];
  std::vector<std::size_t> large = label;
  for (auto& l : large)
    if (sizes[l] < minimum_part)
      l = unlabelled;
  growRings(neighbours, depth, 0, large);
  for (std::size_t i = 0; i < label.size(); ++i)
    if (large[i] != unlabelled)
      label[i] = large[i];
}

/** @brief Numbers the regions by decreasing size, equal ones by their first cell. */
CellRegions
rankBySize(const std::vector<std::size_t>& label)
{
  std::vector<std::size_t> sizes;
  std::vector<std::size_t> met; // labels in the order of their first cells
  for (const std::size_t l : label) {
    if (l >= sizes.size())
      sizes.resize(l + 1, 0);
    if (sizes[l]++ == 0)
      met.push_back(l);
  }
  std::stable_sort(met.begin(), met.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  std::vector<std::size_t> rank(sizes.size(), 0);
  CellRegions regions;
  for (const std::size_t l : met) {
    rank[l] = regions.sizes.size();
    regions.sizes.push_back(sizes[l]);
  }
  regions.label.reserve(label.size());
  for (const std::size_t l : label)
    regions.label.push_back(rank[l]);
  return regions;
}

} // namespace

std::size_t
largestGapThreshold(const std::vector<std::size_t>& sizes)
{
  std::size_t threshold = 0;
  std::size_t largest = 1;
  for (std::size_t i = 1; i < sizes.size(); ++i) {
    const std::size_t difference = sizes[i - 1] - sizes[i];
    if (difference >= largest) {
      largest = difference;
      threshold = sizes[i];
    }
  }
  return threshold;
}

CellRegions
labelOpenedRegions(const CellSet& cells, int radius, std::size_t minimum_part)
{
  if (radius <= 0)
    return labelRegions(cells);
  const Neighbours neighbours = neighboursOf(cells);
  const std::vector<int> depth = depthsOf(neighbours, radius);
  std::vector<std::size_t> label(cells.size(), unlabelled);
  std::size_t count = 0;
  seedRegions(cells, depth, radius, count, label);
  // Deepest cells first, so no label passes a neck before the labels beyond have grown
  // up to it.
  for (int least = radius; least >= 0; --least)
    growRings(neighbours, depth, least, label);
  // The front of a neck may extend one cell beyond it at either end.
  joinAlongFronts(cells, neighbours, 2 * radius + 3, label);
  absorbSmallParts(neighbours, depth, minimum_part, label);
  seedRegions(cells, depth, 0, count, label);
  return rankBySize(label);
}

void
growLabels(const CellSet& cells, std::vector<std::size_t>& label)
{
  growRings(neighboursOf(cells), std::vector<int>(cells.size(), 0), 0, label);
}

std::vector<std::size_t>
supportedCells(const CellSet& cells, const CellRegions& regions, const CellSet& support)
{
  std::vector<std::size_t> supported(regions.sizes.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    bool found = false;
    for (std::int32_t dy = -1; dy <= 1 && !found; ++dy)
      for (std::int32_t dx = -1; dx <= 1 && !found; ++dx)
        found = support.contains({cells[i].x + dx, cells[i].y + dy});
    supported[regions.label[i]] += found ? 1 : 0;
  }
  return supported;
}

} // namespace pcl::sedr
