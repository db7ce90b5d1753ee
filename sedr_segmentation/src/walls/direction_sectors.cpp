// SPDX-License-Identifier: BSD-3-Clause
#include "direction_sectors.h"

#include "sedr_filters/src/base/exactness.h"

#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Gaps that differ by less from the angle are not told by sectors, radians. */
constexpr float margin = 1e-3f;

} // namespace

DirectionSectors::DirectionSectors(float angle)
    : angle_(angle)
{
  for (unsigned k = 0; k <= sectors; ++k) {
    const float turns = 4.f * static_cast<float>(k) / sectors;
    const float quadrant = std::floor(turns);
    const float part = turns - quadrant;
    from_[k] = quadrant * static_cast<float>(M_PI / 2) + std::atan2(part, 1 - part);
  }
  // A run of empty sectors and the seen ones around it, which are wider diagonally.
  const auto widest = [&](unsigned run) {
    float most = 0;
    for (unsigned k = 0; k < sectors; ++k)
      most = std::max(most, turnOver(k, run + 2));
    return most;
  };
  while (min_run_ < sectors && widest(min_run_) <= angle - margin)
    ++min_run_;
}

float
DirectionSectors::turnOver(unsigned first, unsigned count) const
{
  const unsigned end = first + count;
  return from_[end % sectors] + full_turn * static_cast<float>(end / sectors) -
         from_[first];
}

Gap
DirectionSectors::gapOf(std::uint64_t seen) const
{
  if (seen == 0)
    return Gap::Unknown;
  if (areClose(seen))
    return Gap::None;
  bool may_be = false;
  const auto first = static_cast<unsigned>(__builtin_ctzll(seen));
  for (unsigned at = first; at < first + sectors;) {
    unsigned next = at + 1;
    while (!(seen >> (next % sectors) & 1))
      ++next;
    if (turnOver(at + 1, next - at - 1) > angle_ + margin)
      return Gap::Wide;
    may_be = may_be || turnOver(at, next - at + 1) > angle_ - margin;
    at = next;
  }
  return may_be ? Gap::Unknown : Gap::None;
}

} // namespace pcl::sedr
