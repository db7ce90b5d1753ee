// SPDX-License-Identifier: BSD-3-Clause
#include "ceiling_beside.h"
#include "opening_weights.h"

#include <pcl/sedr_filters/priors.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief Returns how far behind a surface points of a ceiling go on, metres, without
 * an interruption that may be a wall: as wide as the thinnest one, and half as wide
 * again as all before the surface. */
double
wayBehind(std::vector<float> offsets)
{
  std::sort(offsets.begin(), offsets.end(), std::greater<>());
  double widest = Priors().min_wall;
  double last = opening_numbers.ceiling_before;
  for (const float offset : offsets) {
    if (offset > opening_numbers.ceiling_before)
      continue;
    const double gap = last - static_cast<double>(offset);
    if (offset >= 0)
      widest = std::max(widest, 1.5 * gap);
    else if (gap > widest)
      break;
    last = offset;
  }
  return widest < opening_numbers.usual_wall ? std::max(0.0, -last) : 0;
}

} // namespace

CeilingBeside::CeilingBeside(std::size_t columns, double edge)
    : edge_(edge)
    , offsets_(columns)
    , behind_(columns, 0)
    , before_(columns, std::numeric_limits<float>::infinity())
{}

void
CeilingBeside::add(std::size_t column, float offset)
{
  offsets_[column].push_back(offset);
  if (offset > edge_)
    before_[column] = std::min(before_[column], offset);
}

void
CeilingBeside::measure(double noise)
{
  for (std::size_t c = 0; c < offsets_.size(); ++c) {
    std::vector<float> near; // a column may be sparse
    for (std::size_t k = c - std::min<std::size_t>(c, 1);
         k < std::min(c + 2, offsets_.size()); ++k)
      near.insert(near.end(), offsets_[k].begin(), offsets_[k].end());
    const double way = wayBehind(std::move(near));
    behind_[c] = way > std::max(Priors().min_wall, noise) ? static_cast<float>(way) : 0;
  }
  offsets_.clear();
}

} // namespace pcl::sedr
