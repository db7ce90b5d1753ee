// SPDX-License-Identifier: BSD-3-Clause
#include "line_parts.h"

#include <cstddef>
#include <cstdint>
#include <map>

namespace pcl::sedr {

std::vector<std::vector<Eigen::Vector2d>>
chained(const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& segments)
{
  constexpr double same = 1e-4;
  using Place = std::pair<std::int64_t, std::int64_t>;
  const auto placeOf = [](const Eigen::Vector2d& p) {
    return Place(std::llround(p.x() / same), std::llround(p.y() / same));
  };
  std::map<Place, std::vector<std::size_t>> at;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    at[placeOf(segments[k].first)].push_back(k);
    at[placeOf(segments[k].second)].push_back(k);
  }
  std::vector<bool> is_used(segments.size(), false);
  std::vector<std::vector<Eigen::Vector2d>> lines;
  const auto follow = [&](std::size_t k, bool is_forward) {
    std::vector<Eigen::Vector2d> line{is_forward ? segments[k].first
                                                 : segments[k].second};
    while (!is_used[k]) {
      is_used[k] = true;
      line.push_back(is_forward ? segments[k].second : segments[k].first);
      const Place end = placeOf(line.back());
      const std::vector<std::size_t>& beside = at[end];
      if (beside.size() != 2)
        break;
      k = beside[0] == k ? beside[1] : beside[0];
      is_forward = placeOf(segments[k].first) == end;
    }
    lines.push_back(line);
  };
  // Open lines from their ends, then closed ones.
  for (const bool is_closed : {false, true})
    for (std::size_t k = 0; k < segments.size(); ++k)
      for (const bool is_forward : {true, false}) {
        const Eigen::Vector2d& start =
            is_forward ? segments[k].first : segments[k].second;
        if (!is_used[k] && (is_closed || at[placeOf(start)].size() != 2))
          follow(k, is_forward);
      }
  return lines;
}

} // namespace pcl::sedr
