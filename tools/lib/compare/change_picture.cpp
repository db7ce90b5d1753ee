// SPDX-License-Identifier: BSD-3-Clause
#include "change_picture.h"

#include "sedr_filters/src/plan/plan_bounds.h"

#include <map>

namespace pcl::sedr::tools {
namespace {

constexpr Colour
colourOf(ChangeKind kind)
{
  return kind == ChangeKind::Appeared   ? 0x28a046
         : kind == ChangeKind::Vanished ? 0xd22828
                                        : 0xf0961e;
}

} // namespace

Picture
drawChanges(const Floorplan& before,
            const Floorplan& after,
            const std::vector<Change>& changes)
{
  const Eigen::Vector2d above(0, 0.35); // metres, from the named outline
  Panel panel("plan, the first one faint", viewOf({&before, &after}));
  panel.addPlan(before, 1.5, colours::faint);
  panel.addPlan(after, 1.5, colours::ink);
  std::map<ChangeKind, std::size_t> counts;
  for (const auto& change : changes) {
    ++counts[change.kind];
    panel.addLines(change.outlines, colourOf(change.kind), 3.5);
    if (!change.outlines.empty())
      panel.addLabel(boundsOf(change.outlines.back()).center() + above,
                     change.what + " " + toString(change.kind));
  }
  Picture picture(counted(changes.size(), "change"));
  picture.addMaps({panel});
  for (const auto kind :
       {ChangeKind::Appeared, ChangeKind::Vanished, ChangeKind::Moved})
    picture.addLegend(std::string(toString(kind)) + ": " + std::to_string(counts[kind]),
                      colourOf(kind));
  return picture;
}

} // namespace pcl::sedr::tools
