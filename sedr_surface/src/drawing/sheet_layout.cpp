// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_layout.h"

#include "dimension_rows.h"

#include <pcl/sedr_filters/plan_measures.h>

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

/** @brief Finds the scale and the paper of a plan. */
class LayoutFinder {
public:
  LayoutFinder(const Floorplan& plan, const DrawingSettings& settings)
      : settings_(settings)
  {
    for (const PlanStorey& storey : storeysOf(plan))
      storeys_.push_back(partOf(plan, storey));
    layout_.frame.turn = -mainDirection(plan);
    bounds_ = boundsOf(plan, layout_.frame);
    if (bounds_.isEmpty() || !bounds_.sizes().allFinite())
      bounds_ = Eigen::AlignedBox2d(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
  }

  SheetLayout find()
  {
    constexpr std::size_t scales = 50;
    const auto first = static_cast<std::size_t>(settings_.paper);
    for (std::size_t k = 0; settings_.scale <= 0 && k < scales; ++k) {
      setScale(usualScale(k));
      if (takePaper(papers[first]))
        return layout_;
    }
    if (settings_.scale > 0)
      setScale(settings_.scale);
    for (std::size_t p = first; p < papers.size(); ++p)
      if (takePaper(papers[p]))
        return layout_;
    findSpace();
    place(needed());
    return layout_;
  }

private:
  void setScale(double scale)
  {
    layout_.scale = scale;
    layout_.frame.scale = 1000 / scale;
    layout_.frame.shift = Eigen::Vector2d::Zero();
    space_ = spaceOf({}, {});
  }

  Eigen::Vector2d needed() const
  {
    return bounds_.sizes() * 1000 / layout_.scale + space_.min() + space_.max() +
           Eigen::Vector2d(margin_left + margin, 2 * margin + title_height);
  }

  bool fits(const Eigen::Vector2d& paper) const
  {
    constexpr double hair = 1e-6;
    return (needed().array() <= paper.array() + hair).all();
  }

  /** @brief Finds the space of the dimensions, which depends on the scale. */
  void findSpace()
  {
    for (const Floorplan& storey : storeys_) {
      const Eigen::AlignedBox2d of_rows =
          spaceOf(rowsAround(storey, layout_.frame, settings_.max_wall),
                  boundsOf(storey, layout_.frame));
      space_.min() = space_.min().cwiseMax(of_rows.min());
      space_.max() = space_.max().cwiseMax(of_rows.max());
    }
  }

  /** @brief Chooses the first orientation of a paper that the plan fits on. */
  bool takePaper(const Paper& paper)
  {
    const Eigen::Vector2d sizes[] = {{paper.across, paper.up},
                                     {paper.up, paper.across}};
    if (!fits(sizes[0]) && !fits(sizes[1]))
      return false; // even without dimensions
    findSpace();
    for (const Eigen::Vector2d& size : sizes)
      if (fits(size)) {
        layout_.paper = paper.name;
        place(size);
        return true;
      }
    return false;
  }

  /** @brief Centres the plan with its dimensions in what the title leaves. */
  void place(const Eigen::Vector2d& size)
  {
    layout_.size = size;
    const Eigen::Vector2d low(margin_left, margin + title_height);
    const Eigen::Vector2d high = size - Eigen::Vector2d::Constant(margin);
    const Eigen::Vector2d middle = (low + space_.min() + high - space_.max()) / 2;
    layout_.frame.shift = middle - layout_.frame.scale * bounds_.center();
  }

  const DrawingSettings& settings_;
  std::vector<Floorplan> storeys_;
  Eigen::AlignedBox2d bounds_; ///< of all storeys, in the frame of the walls, metres
  Eigen::AlignedBox2d space_;  ///< around it: left and below, right and above
  SheetLayout layout_;
};

} // namespace

SheetLayout
layoutOf(const Floorplan& plan, const DrawingSettings& settings)
{
  return LayoutFinder(plan, settings).find();
}

} // namespace pcl::sedr
