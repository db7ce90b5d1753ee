// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/region_selection.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

constexpr std::size_t unlabelled = CellSet::npos;

/** @brief Where the eight neighbours of each cell stand in the set, npos for the absent. */
using Neighbours = std::vector<std::array<std::size_t, 8>>;

Neighbours
neighboursOf(const CellSet& cells)
{
  constexpr std::array<Cell, 8> steps{
      Cell{-1, -1}, Cell{0, -1}, Cell{1, -1}, Cell{-1, 0}, Cell{1, 0}, Cell{-1, 1}, Cell{0, 1},
      Cell{1, 1}};
  Neighbours neighbours(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t k = 0; k < steps.size(); ++k)
      neighbours[i][k] = cells.find({cells[i].x + steps[k].x, cells[i].y + steps[k].y});
  return neighbours;
}

/** @brief Which cells have nothing but cells of the set within `radius` of them. */
std::vector<bool>
erode(const Neighbours& neighbours, int radius)
{
  std::vector<bool> in(neighbours.size(), true);
  for (int step = 0; step < radius; ++step) {
    std::vector<bool> next = in;
    for (std::size_t i = 0; i < in.size(); ++i)
      next[i] = in[i] && std::all_of(neighbours[i].begin(),
                                     neighbours[i].end(),
                                     [&](std::size_t n) {
                                       return n != CellSet::npos && in[n];
                                     });
    in.swap(next);
  }
  return in;
}

/** @brief Grows labels over the unlabelled cells, ring by ring; where rings of several labels meet
 * the smallest label wins. */
void
growRings(const Neighbours& neighbours, std::vector<std::size_t>& label)
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
        if (n != CellSet::npos && label[n] == unlabelled)
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

/** @brief Labels the unlabelled cells by the regions of `part`, numbered on from `count`. */
void
labelPart(const CellSet& cells,
          const CellSet& part,
          const CellRegions& regions,
          std::size_t count,
          std::vector<std::size_t>& label)
{
  for (std::size_t i = 0; i < part.size(); ++i) {
    std::size_t& of_cell = label[cells.find(part[i])];
    if (of_cell == unlabelled)
      of_cell = count + regions.label[i];
  }
}

/** @brief Whether some cells that touch each other reach over `width` cells in x or y. */
bool
hasFront(const CellSet& cells, std::int32_t width)
{
  struct Box {
    Cell low{std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::max()};
    Cell high{std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::min()};
  };
  const CellRegions pieces = labelRegions(cells);
  std::vector<Box> boxes(pieces.sizes.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Box& box = boxes[pieces.label[i]];
    box.low = {std::min(box.low.x, cells[i].x), std::min(box.low.y, cells[i].y)};
    box.high = {std::max(box.high.x, cells[i].x), std::max(box.high.y, cells[i].y)};
  }
  return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) {
    return std::max(box.high.x - box.low.x, box.high.y - box.low.y) + 1 >= width;
  });
}

/** @brief Joins labels whose cells touch along a front of `width` cells: no neck parts them, but
 * holes in what was measured. */
void
joinAlongFronts(const CellSet& cells,
                const Neighbours& neighbours,
                std::int32_t width,
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

CellSet
unlabelledCells(const CellSet& cells, const std::vector<std::size_t>& label)
{
  std::vector<CellKey> keys;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (label[i] == unlabelled)
      keys.push_back(cells.keys()[i]);
  return CellSet(std::move(keys));
}

/** @brief Regions numbered by decreasing size, equal ones by their first cell. */
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
  std::stable_sort(met.begin(), met.end(), [&](std::size_t a, std::size_t b) {
    return sizes[a] > sizes[b];
  });
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
labelOpenedRegions(const CellSet& cells, int radius, std::size_t minimum_core)
{
  if (radius <= 0)
    return labelRegions(cells);
  const Neighbours neighbours = neighboursOf(cells);
  const std::vector<bool> in_core = erode(neighbours, radius);
  std::vector<CellKey> core_keys;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (in_core[i])
      core_keys.push_back(cells.keys()[i]);
  const CellSet core(std::move(core_keys));
  const CellRegions cores = labelRegions(core);

  // Large cores first; small ones seed only what is left, and the rest keeps its own regions.
  std::vector<std::size_t> label(cells.size(), unlabelled);
  for (std::size_t i = 0; i < core.size(); ++i)
    if (cores.sizes[cores.label[i]] >= minimum_core)
      label[cells.find(core[i])] = cores.label[i];
  growRings(neighbours, label);
  labelPart(cells, core, cores, 0, label);
  growRings(neighbours, label);
  joinAlongFronts(cells, neighbours, 2 * (2 * radius + 1), label);
  const CellSet rest = unlabelledCells(cells, label);
  labelPart(cells, rest, labelRegions(rest), cores.sizes.size(), label);
  return rankBySize(label);
}

void
growLabels(const CellSet& cells, std::vector<std::size_t>& label)
{
  growRings(neighboursOf(cells), label);
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

} // namespace sedr
} // namespace pcl
