// SPDX-License-Identifier: BSD-3-Clause
#include "cell_mask.h"

#include <algorithm>
#include <limits>

namespace pcl::sedr {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/** @brief Lower envelope of the parabolas (x - i)^2 + f[i], sampled at the integers.
 * This is one pass of the distance transform along a row or column of n values,
 * `stride` apart. */
class ParabolaPass {
public:
  explicit ParabolaPass(std::size_t n)
      : values_(n)
      , apex_(n)
      , from_(n + 1)
  {}

  void run(float* f, std::size_t n, std::size_t stride)
  {
    std::size_t k = 0;
    bool has_any = false;
    for (std::size_t q = 0; q < n; ++q) {
      values_[q] = f[q * stride];
      if (values_[q] == infinite)
        continue;
      if (!has_any) {
        has_any = true;
        apex_[0] = q;
        from_[0] = -infinite;
        from_[1] = infinite;
        continue;
      }
      float crossing = crossingOf(q, apex_[k]);
      while (crossing <= from_[k])
        crossing = crossingOf(q, apex_[--k]);
      apex_[++k] = q;
      from_[k] = crossing;
      from_[k + 1] = infinite;
    }
    if (!has_any)
      return;
    k = 0;
    for (std::size_t q = 0; q < n; ++q) {
      while (from_[k + 1] < static_cast<float>(q))
        ++k;
      const float d = static_cast<float>(q) - static_cast<float>(apex_[k]);
      f[q * stride] = d * d + values_[apex_[k]];
    }
  }

private:
  float crossingOf(std::size_t q, std::size_t p) const
  {
    const double fq = values_[q] + static_cast<double>(q) * static_cast<double>(q);
    const double fp = values_[p] + static_cast<double>(p) * static_cast<double>(p);
    return static_cast<float>(
        (fq - fp) / (2.0 * (static_cast<double>(q) - static_cast<double>(p))));
  }

  std::vector<float> values_;
  std::vector<std::size_t> apex_;
  std::vector<float> from_;
};

} // namespace

std::uint64_t
CellBox::count() const
{
  if (high.x < low.x || high.y < low.y)
    return 0;
  const auto width =
      static_cast<std::uint64_t>(static_cast<std::int64_t>(high.x) - low.x + 1);
  const auto height =
      static_cast<std::uint64_t>(static_cast<std::int64_t>(high.y) - low.y + 1);
  return width * height;
}

CellBox
boxOf(const CellSet& cells)
{
  if (cells.empty())
    return {{0, 0}, {-1, -1}};
  CellBox box{cells[0], cells[0]};
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const Cell c = cells[i];
    box.low = {std::min(box.low.x, c.x), std::min(box.low.y, c.y)};
    box.high = {std::max(box.high.x, c.x), std::max(box.high.y, c.y)};
  }
  return box;
}

CellBox
grown(const CellBox& box, int margin)
{
  return {{box.low.x - margin, box.low.y - margin},
          {box.high.x + margin, box.high.y + margin}};
}

CellBox
overlapOf(const CellBox& a, const CellBox& b)
{
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

CellBox
around(const CellBox& a, const CellBox& b)
{
  if (a.count() == 0 || b.count() == 0)
    return a.count() == 0 ? b : a;
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

std::string
maskProblem(const CellBox& box)
{
  if (box.count() <= max_mask_cells)
    return {};
  const auto span = [](std::int32_t low, std::int32_t high) {
    return std::to_string(static_cast<std::int64_t>(high) - low + 1);
  };
  return "the region spans " + span(box.low.x, box.high.x) + " x " +
         span(box.low.y, box.high.y) + " cells, these are " +
         std::to_string(box.count()) + ", at most " + std::to_string(max_mask_cells) +
         " can be held: take larger cells or cut the scan";
}

CellMask::CellMask(const CellBox& box)
    : box_(box)
{
  if (box.count() == 0)
    return;
  width_ = box.high.x - box.low.x + 1;
  height_ = box.high.y - box.low.y + 1;
  values_.assign(box.count(), 0);
}

CellMask::CellMask(const CellSet& cells, const CellBox& box)
    : CellMask(box)
{
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (isInside(cells[i]))
      set(cells[i], 1);
}

std::size_t
CellMask::count() const
{
  return values_.size() -
         static_cast<std::size_t>(std::count(values_.begin(), values_.end(), 0));
}

CellSet
CellMask::toSet() const
{
  std::vector<CellKey> keys;
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (values_[i])
      keys.push_back(keyOf(cellAt(i)));
  return CellSet::fromSorted(
      std::move(keys)); // cells are visited in the order of the keys
}

CellMask
inverted(const CellMask& mask)
{
  CellMask result(mask.box());
  std::transform(mask.values().begin(), mask.values().end(), result.values().begin(),
                 [](std::uint8_t value) { return value == 0 ? 1 : 0; });
  return result;
}

namespace {

/** @brief Returns `op(a, b)` for each cell in the box of `a`. */
template <typename Op>
CellMask
combined(const CellMask& a, const CellMask& b, Op op)
{
  CellMask result(a.box());
  std::size_t i = 0;
  for (std::int32_t y = a.box().low.y; y <= a.box().high.y; ++y)
    for (std::int32_t x = a.box().low.x; x <= a.box().high.x; ++x, ++i)
      result.values()[i] = op(a.values()[i] != 0, b.at({x, y}) != 0) ? 1 : 0;
  return result;
}

} // namespace

CellMask
unite(const CellMask& a, const CellMask& b)
{
  return combined(a, b, [](bool in_a, bool in_b) { return in_a || in_b; });
}

void
addCells(const CellMask& mask, CellMask& sum)
{
  const CellBox shared = overlapOf(sum.box(), mask.box());
  for (int y = shared.low.y; y <= shared.high.y; ++y)
    for (int x = shared.low.x; x <= shared.high.x; ++x)
      if (mask.at({x, y}))
        sum.set({x, y}, 1);
}

CellMask
subtract(const CellMask& a, const CellMask& b)
{
  return combined(a, b, [](bool in_a, bool in_b) { return in_a && !in_b; });
}

CellMask
intersect(const CellMask& a, const CellMask& b)
{
  return combined(a, b, [](bool in_a, bool in_b) { return in_a && in_b; });
}

CellMask
cropped(const CellMask& mask, const CellBox& box)
{
  return combined(CellMask(box), mask, [](bool, bool in_mask) { return in_mask; });
}

MaskRegions
labelRegions(const CellMask& mask, bool eight_connected)
{
  MaskRegions regions;
  regions.label.assign(mask.values().size(), -1);
  std::vector<std::size_t> stack;
  for (std::size_t start = 0; start < mask.values().size(); ++start) {
    if (!mask.values()[start] || regions.label[start] >= 0)
      continue;
    const auto region = static_cast<std::int32_t>(regions.sizes.size());
    regions.sizes.push_back(0);
    regions.label[start] = region;
    stack.push_back(start);
    while (!stack.empty()) {
      const Cell cell = mask.cellAt(stack.back());
      stack.pop_back();
      ++regions.sizes.back();
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const Cell next{cell.x + dx, cell.y + dy};
          if ((!eight_connected && dx != 0 && dy != 0) || !mask.at(next))
            continue;
          const std::size_t i = mask.indexOf(next);
          if (regions.label[i] >= 0)
            continue;
          regions.label[i] = region;
          stack.push_back(i);
        }
    }
  }
  return regions;
}

CellMask
regionMask(const CellMask& mask, const MaskRegions& regions, std::int32_t region)
{
  CellMask result(mask.box());
  for (std::size_t i = 0; i < result.values().size(); ++i)
    result.values()[i] = regions.label[i] == region ? 1 : 0;
  return result;
}

CellMask
enclosedCells(const CellMask& mask)
{
  // The cells around the box are in the first region.
  const CellMask empty = inverted(cropped(mask, grown(mask.box(), 1)));
  const CellMask outside = regionMask(empty, labelRegions(empty, false), 0);
  return cropped(subtract(empty, outside), mask.box());
}

std::vector<float>
squaredDistances(const CellMask& mask)
{
  const auto width = static_cast<std::size_t>(mask.width());
  const auto height = static_cast<std::size_t>(mask.height());
  std::vector<float> distances(mask.values().size());
  for (std::size_t i = 0; i < distances.size(); ++i)
    distances[i] = mask.values()[i] ? 0.f : infinite;
  ParabolaPass pass(std::max(width, height));
  for (std::size_t x = 0; x < width; ++x)
    pass.run(distances.data() + x, height, width);
  for (std::size_t y = 0; y < height; ++y)
    pass.run(distances.data() + y * width, width, 1);
  return distances;
}

CellMask
dilated(const CellMask& mask, double radius)
{
  const std::vector<float> distances = squaredDistances(mask);
  CellMask result(mask.box());
  for (std::size_t i = 0; i < distances.size(); ++i)
    result.values()[i] = distances[i] <= radius * radius ? 1 : 0;
  return result;
}

CellMask
eroded(const CellMask& mask, double radius)
{
  if (mask.values().empty())
    return mask;
  // The cells around the box count as not set.
  const CellMask outside =
      dilated(inverted(cropped(mask, grown(mask.box(), 1))), radius);
  return inverted(cropped(outside, mask.box()));
}

} // namespace pcl::sedr
