// SPDX-License-Identifier: BSD-3-Clause
#include "detail_extension.h"

#include "strip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::sedr {

namespace {

/** @brief Content of a cross-section of a beam's extension. */
enum class Across { Unseen, MainSlab, End };

class Extender {
public:
  Extender(const CellMask& room,
           const std::vector<PlanSlab>& details,
           const CellGrid& grid,
           std::vector<std::int32_t>& label,
           const Priors& priors)
      : room_(room)
      , details_(details)
      , grid_(grid)
      , label_(label)
      , priors_(priors)
  {}

  /** @brief Extends a detail beyond both ends. */
  void extend(std::int32_t of)
  {
    const CellMask cells = cellsOf(of);
    const Strip strip = stripOf(cells, grid_);
    if (!isBeam(strip, cells))
      return;
    for (const double side : {-1.0, 1.0})
      follow(strip, side, of);
  }

private:
  CellMask cellsOf(std::int32_t of) const
  {
    CellMask cells(room_.box());
    for (std::size_t i = 0; i < label_.size(); ++i)
      cells.values()[i] = label_[i] == of ? 1 : 0;
    return cells;
  }

  /** @brief Returns whether cells fill a strip at least twice as long as wide. */
  bool isBeam(const Strip& strip, const CellMask& cells) const
  {
    const double area =
        static_cast<double>(cells.count()) * grid_.size() * grid_.size();
    return strip.width > 0 && strip.length >= 2 * strip.width &&
           area >= 0.75 * strip.length * strip.width;
  }

  /** @brief Returns the cells across a strip `s` metres from its centre, without edges.
   */
  std::vector<Cell> cellsAcross(const Strip& strip, double s) const
  {
    const Eigen::Vector2d across(-strip.direction.y(), strip.direction.x());
    const double half = std::max(0.0, strip.width / 2 - grid_.size());
    const int steps = std::max(1, static_cast<int>(std::ceil(half / grid_.size())));
    std::vector<Cell> cells;
    for (int k = -steps; k <= steps; ++k) {
      const Eigen::Vector2d p =
          strip.middle + s * strip.direction + half * k / steps * across;
      cells.push_back(grid_.at(p.x(), p.y()));
    }
    return cells;
  }

  /** @brief Returns the content of a cross-section; `met` is a detail in it, if any. */
  Across
  lookAcross(const std::vector<Cell>& cells, std::int32_t of, std::int32_t& met) const
  {
    std::size_t main = 0;
    std::size_t end = 0;
    for (const Cell cell : cells) {
      if (!room_.at(cell)) {
        ++end;
        continue;
      }
      const std::int32_t other = label_[room_.indexOf(cell)];
      main += other == 0 ? 1 : 0;
      if (other > 0 && other != of) {
        ++end;
        met = other;
      }
    }
    if (5 * main > cells.size())
      return Across::MainSlab;
    return 2 * end >= cells.size() ? Across::End : Across::Unseen;
  }

  /** @brief Returns the distance of the detail's last cell from its centre. */
  double endOf(const Strip& strip, double side, std::int32_t of) const
  {
    double farthest = 0;
    for (std::size_t i = 0; i < label_.size(); ++i)
      if (label_[i] == of)
        farthest = std::max(
            farthest,
            side * strip.direction.dot(grid_.centre(room_.cellAt(i)) - strip.middle));
    return farthest;
  }

  void follow(const Strip& strip, double side, std::int32_t of)
  {
    const double start = endOf(strip, side, of);
    for (double s = start; s < start + strip.length / 2; s += grid_.size() / 2) {
      std::int32_t met = 0;
      const Across across = lookAcross(cellsAcross(strip, side * s), of, met);
      if (across == Across::MainSlab)
        return;
      if (across == Across::Unseen)
        continue;
      claim(strip, side, start, s, of);
      if (met > 0 && isSameStrip(strip, of, met)) {
        std::replace(label_.begin(), label_.end(), met, of);
        follow(strip, side, of);
      }
      return;
    }
  }

  /** @brief Assigns unlabelled cells of the strip between two positions to a detail. */
  void claim(const Strip& strip, double side, double from, double to, std::int32_t of)
  {
    const Eigen::Vector2d across(-strip.direction.y(), strip.direction.x());
    for (std::size_t i = 0; i < label_.size(); ++i) {
      if (!room_.values()[i] || label_[i] >= 0)
        continue;
      const Eigen::Vector2d d = grid_.centre(room_.cellAt(i)) - strip.middle;
      const double s = side * strip.direction.dot(d);
      if (std::abs(across.dot(d)) <= strip.width / 2 && s >= from - grid_.size() &&
          s <= to + grid_.size())
        label_[i] = of;
    }
  }

  /** @brief Returns whether another detail is a part of the same beam. */
  bool isSameStrip(const Strip& strip, std::int32_t of, std::int32_t other) const
  {
    const Strip there = stripOf(cellsOf(other), grid_);
    const Eigen::Vector2d across(-strip.direction.y(), strip.direction.x());
    const Eigen::Vector2d between = there.middle - strip.middle;
    const double step =
        slabOf(of).heightAt(there.middle) - slabOf(other).heightAt(there.middle);
    // The direction of a short part is undefined.
    const bool is_parallel =
        there.length < 2 * there.width || std::abs(across.dot(there.direction)) < 0.1;
    return is_parallel && std::abs(step) < priors_.min_ceiling_step &&
           std::abs(across.dot(between)) < 2 * grid_.size() &&
           there.width < strip.width + 3 * grid_.size();
  }

  const PlanSlab& slabOf(std::int32_t of) const
  {
    return details_[static_cast<std::size_t>(of - 1)];
  }

  const CellMask& room_;
  const std::vector<PlanSlab>& details_;
  const CellGrid& grid_;
  std::vector<std::int32_t>& label_;
  const Priors& priors_;
};

} // namespace

void
extendDetails(const CellMask& room,
              const std::vector<PlanSlab>& details,
              const CellGrid& grid,
              std::vector<std::int32_t>& label,
              const Priors& priors)
{
  Extender extender(room, details, grid, label, priors);
  for (std::size_t k = 1; k <= details.size(); ++k)
    extender.extend(static_cast<std::int32_t>(k));
}

} // namespace pcl::sedr
