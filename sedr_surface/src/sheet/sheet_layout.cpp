// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_layout.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace pcl::sedr {
namespace {

using namespace sheet_measures;

struct Paper {
  const char* name;
  double across; ///< longer side, millimetres
  double up;
};

/** In the order of PaperSize. */
constexpr std::array<Paper, 5> papers{{{"A4", 297, 210},
                                       {"A3", 420, 297},
                                       {"A2", 594, 420},
                                       {"A1", 841, 594},
                                       {"A0", 1189, 841}}};

/** @brief Space around the plan's field. */
const Eigen::Vector2d surround(margin_left + margin + chain_room + chain_room_far,
                               2 * margin + title_height + chain_room + chain_room_far);

Eigen::Vector2d
sizeOf(const Paper& paper, bool is_vertical)
{
  return is_vertical ? Eigen::Vector2d(paper.up, paper.across)
                     : Eigen::Vector2d(paper.across, paper.up);
}

bool
fits(const Eigen::Vector2d& plan, double scale, const Eigen::Vector2d& paper)
{
  constexpr double hair = 1e-6;
  const Eigen::Vector2d needed = plan * 1000 / scale + surround;
  return needed.x() <= paper.x() + hair && needed.y() <= paper.y() + hair;
}

/** @brief Returns the k-th usual scale: those of a scale ruler, then 1000, 2000, 5000,
 * ... */
double
usualScale(std::size_t k)
{
  constexpr std::array<double, 12> ruler{10,  20,  25,  50,  75,  100,
                                         125, 200, 250, 300, 400, 500};
  constexpr std::array<double, 3> steps{1000, 2000, 5000};
  if (k < ruler.size())
    return ruler[k];
  k -= ruler.size();
  return steps[k % 3] * std::pow(10.0, static_cast<double>(k / 3));
}

/** @brief Chooses the first orientation of the paper that the plan fits on. */
bool
takePaper(SheetLayout& layout, const Eigen::Vector2d& plan, const Paper& paper)
{
  for (const bool is_vertical : {false, true})
    if (fits(plan, layout.scale, sizeOf(paper, is_vertical))) {
      layout.size = sizeOf(paper, is_vertical);
      layout.paper = paper.name;
      return true;
    }
  return false;
}

} // namespace

SheetLayout
layoutOf(const Floorplan& plan, double scale, PaperSize paper)
{
  SheetLayout layout;
  layout.frame.turn = -mainDirection(plan);
  Eigen::AlignedBox2d bounds = boundsOf(plan, layout.frame);
  if (bounds.isEmpty() || !bounds.sizes().allFinite())
    bounds = Eigen::AlignedBox2d(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
  const auto first = static_cast<std::size_t>(paper);
  bool is_placed = false;
  for (std::size_t k = 0; scale <= 0 && !is_placed && k < 50; ++k) {
    layout.scale = usualScale(k);
    is_placed = takePaper(layout, bounds.sizes(), papers[first]);
  }
  if (scale > 0)
    layout.scale = scale;
  for (std::size_t p = first; p < papers.size() && !is_placed; ++p)
    is_placed = takePaper(layout, bounds.sizes(), papers[p]);
  if (!is_placed)
    layout.size = bounds.sizes() * 1000 / layout.scale + surround;
  layout.field = Eigen::AlignedBox2d(
      Eigen::Vector2d(margin_left, margin + title_height),
      Eigen::Vector2d(layout.size.x() - margin, layout.size.y() - margin));
  // Centres the plan in the field without the dimensions.
  const Eigen::Vector2d middle =
      layout.field.center() +
      Eigen::Vector2d::Constant((chain_room - chain_room_far) / 2);
  layout.frame.scale = 1000 / layout.scale;
  layout.frame.shift = middle - layout.frame.scale * bounds.center();
  return layout;
}

} // namespace pcl::sedr
