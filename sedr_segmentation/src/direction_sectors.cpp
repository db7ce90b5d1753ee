// SPDX-License-Identifier: BSD-3-Clause
#include "direction_sectors.h"

#include <cmath>

namespace pcl {
namespace sedr {

namespace {

/** @brief Gaps that differ by less from the angle are not told by sectors, radians. */
constexpr float margin = 1e-3f;

} // namespace

DirectionSectors::DirectionSectors(float angle)
    : angle_(angle)
{
  // Where quarter turns grow by 1, the direction turns by 2 radians at the most.
  const float widest_sector = 2 * 4.f / sectors;
  const float runs = std::floor((angle - margin) / widest_sector) - 1;
  least_run_ = static_cast<unsigned>(std::clamp(runs, 0.f, float{sectors}));
  for (unsigned k = 0; k <= sectors; ++k) {
    const float turns = 4.f * static_cast<float>(k) / sectors;
    const float quadrant = std::floor(turns);
    const float part = turns - quadrant;
    from_[k] = quadrant * static_cast<float>(M_PI / 2) + std::atan2(part, 1 - part);
  }
}

Gap
DirectionSectors::gapOf(std::uint64_t seen) const
{
  if (seen == 0)
    return Gap::Unknown;
  if (areClose(seen))
    return Gap::None;
  constexpr auto two_pi = static_cast<float>(2 * M_PI);
  bool may_be = false;
  const auto first = static_cast<unsigned>(__builtin_ctzll(seen));
  for (unsigned at = first; at < first + sectors;) {
    unsigned next = at + 1;
    while (!(seen >> (next % sectors) & 1))
      ++next;
    const float turn = next >= sectors ? two_pi : 0;
    const float least = from_[next % sectors] + turn - from_[at + 1];
    const float most = from_[next % sectors + 1] + turn - from_[at];
    if (least > angle_ + margin)
      return Gap::Wide;
    may_be = may_be || most > angle_ - margin;
    at = next;
  }
  return may_be ? Gap::Unknown : Gap::None;
}

} // namespace sedr
} // namespace pcl
