// SPDX-License-Identifier: BSD-3-Clause
#include "cell_mask.h"

#include <algorithm>

namespace pcl::sedr {

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
  const auto combine = [&](Cell first, std::size_t cells, auto in_b) {
    const std::uint8_t* const of_a = a.values().data() + a.indexOf(first);
    std::uint8_t* const of_result = result.values().data() + a.indexOf(first);
    for (std::size_t k = 0; k < cells; ++k)
      of_result[k] = op(of_a[k] != 0, in_b(k)) ? 1 : 0;
  };
  if (a.box().count() > 0)
    combine(a.box().low, a.values().size(), [](std::size_t) { return false; });
  const CellBox both = overlapOf(a.box(), b.box());
  if (both.count() == 0)
    return result;
  const auto width = static_cast<std::size_t>(both.high.x - both.low.x + 1);
  for (std::int32_t y = both.low.y; y <= both.high.y; ++y) {
    const Cell first{both.low.x, y};
    const std::uint8_t* const of_b = b.values().data() + b.indexOf(first);
    combine(first, width, [&](std::size_t k) { return of_b[k] != 0; });
  }
  return result;
}

} // namespace

CellMask
unite(const CellMask& a, const CellMask& b)
{
  return combined(a, b, [](bool in_a, bool in_b) { return in_a || in_b; });
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

} // namespace pcl::sedr
