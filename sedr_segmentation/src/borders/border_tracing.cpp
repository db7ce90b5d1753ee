// SPDX-License-Identifier: BSD-3-Clause
#include "border_tracing.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace pcl::sedr {

namespace {

using Place = Eigen::Vector2d;

/** @brief Whether most around a vertex of a chain meet. */
std::vector<bool>
smoothed(const std::vector<std::optional<Place>>& met)
{
  constexpr std::ptrdiff_t around = 4; // vertices to each side
  std::vector<bool> meets;
  const auto count = static_cast<std::ptrdiff_t>(met.size());
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    int votes = 0;
    for (std::ptrdiff_t n = std::max<std::ptrdiff_t>(0, k - around);
         n <= std::min(count - 1, k + around); ++n)
      votes += met[static_cast<std::size_t>(n)] ? 1 : -1;
    meets.push_back(votes > 0);
  }
  return meets;
}

} // namespace

std::vector<BorderPart>
partsOf(const CrackChain& chain, const SheetCracks& cracks, const BorderSteps& steps)
{
  if (chain.left < 0 || chain.right < 0)
    return {};
  std::vector<Place> raw;
  std::vector<double> reach;
  for (const CrackVertex& v : chain.vertices)
    if (cracks.isInside(v)) {
      raw.push_back(cracks.placeOf(v));
      reach.push_back(cracks.reachAt(v));
    }
  const std::vector<bool> has_riser = steps.risersAlong(raw, chain);
  BorderPart meeting;
  meeting.one = &cracks.facetOf(chain.left);
  meeting.other = &cracks.facetOf(chain.right);
  std::vector<std::optional<Place>> met;
  for (std::size_t k = 0; k < raw.size(); ++k)
    met.push_back(has_riser[k] ? std::nullopt : meeting.project(raw[k], reach[k]));
  const std::vector<bool> meets = smoothed(met);
  std::vector<BorderPart> parts;
  for (std::size_t first = 0; first < raw.size();) {
    std::size_t last = first + 1;
    while (last < raw.size() && meets[last] == meets[first])
      ++last;
    if (meets[first]) {
      parts.push_back(meeting);
      for (std::size_t k = first; k < last; ++k)
        if (met[k])
          parts.back().samples.push_back(*met[k]);
    }
    else
      steps.append({raw.begin() + static_cast<std::ptrdiff_t>(first),
                    raw.begin() + static_cast<std::ptrdiff_t>(last)},
                   chain, parts);
    first = last;
  }
  parts.erase(std::remove_if(parts.begin(), parts.end(),
                             [](const BorderPart& p) { return p.samples.empty(); }),
              parts.end());
  return parts;
}

} // namespace pcl::sedr
