// SPDX-License-Identifier: BSD-3-Clause
#include "storey_plan.h"

#include "../labelling/minimum_cut.h"
#include "air_bounds.h"
#include "label_loops.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns the straight pieces of lines and arcs, numbered by their line. */
std::vector<PlanDivider>
dividersOf(const std::vector<StoreyLine>& lines,
           double max_wall,
           std::vector<std::size_t>& line_of)
{
  constexpr double longest = 0.2; // metres, of a chord of an arc,
  constexpr double share = 0.5;   // of its radius
  std::vector<PlanDivider> dividers;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const StoreyLine& line = lines[k];
    if (!line.is_end && !(line.support() > 0))
      continue;
    const auto pieces =
        line.curve.isCircle()
            ? static_cast<std::size_t>(std::ceil(
                  (line.to - line.from) / std::min(longest, share * line.curve.radius)))
            : std::size_t{1};
    const double step = (line.to - line.from) / static_cast<double>(pieces);
    for (std::size_t i = 0; i < pieces; ++i) {
      const double from = line.from + static_cast<double>(i) * step;
      dividers.push_back({line.at(from), line.at(from + step),
                          static_cast<std::uint32_t>(line_of.size()),
                          line.curve.isCircle() ? 0 : max_wall});
      line_of.push_back(k);
    }
  }
  return dividers;
}

/** @brief Gives each border, of the lines on which it lies, the number of that of which
 * most was seen there: a divider goes on up to the next one, where another in line with
 * it may be. */
void
nameBorders(const std::vector<StoreyLine>& lines,
            const std::vector<std::size_t>& line_of,
            std::vector<CellBorder>& borders)
{
  constexpr double same = 0.003; // metres
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const StoreyLine& line : lines)
    boxes.push_back(line.box());
  for (CellBorder& border : borders) {
    const auto seenOn = [&](const StoreyLine& line) {
      double seen = 0;
      for (const double t : {0.1, 0.3, 0.5, 0.7, 0.9})
        seen += line.seenAt(border.start + t * (border.end - border.start));
      return seen;
    };
    std::size_t best = line_of[border.line];
    double most = seenOn(lines[best]);
    Eigen::AlignedBox2d box(border.start);
    box.extend(border.end);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const PlanCurve& curve = lines[k].curve;
      if (!boxes[k].intersects(box) || curve.isCircle() ||
          curve.distance(border.start) > same || curve.distance(border.end) > same)
        continue;
      if (const double seen = seenOn(lines[k]); seen > most) {
        most = seen;
        best = k;
      }
    }
    border.line = static_cast<std::uint32_t>(best);
  }
}

/** @brief The search for the labels that cost least. */
class StoreyLabelling {
public:
  StoreyLabelling(const StoreyCosts& costs,
                  const std::vector<StoreyLine>& lines,
                  const std::vector<CellBorder>& borders,
                  double price)
      : costs_(costs)
      , lines_(lines)
      , borders_(borders)
      , price_(price)
      , may_use_(lines.size(), 1)
      , uses_(lines.size())
      , of_line_(lines.size())
      , of_cell_(costs.cells())
      , local_(costs.cells(), none)
      , labels_(costs.cells(), 0)
  {
    for (std::size_t b = 0; b < borders_.size(); ++b) {
      of_line_[borders_[b].line].push_back(b);
      of_cell_[borders_[b].left].push_back(b);
      of_cell_[borders_[b].right].push_back(b);
    }
    for (int l = 1; l < static_cast<int>(costs.labels()); ++l)
      for (const std::size_t c : costs.cellsNear(l))
        if (costs.ofCell(c, l) < costs.ofCell(c, labels_[c]))
          labels_[c] = l;
    for (std::size_t b = 0; b < borders_.size(); ++b)
      if (isWall(b)) {
        ++uses_[borders_[b].line].borders;
        uses_[borders_[b].line].length += borders_[b].length();
      }
    std::vector<int> every(costs.labels());
    std::iota(every.begin(), every.end(), 0);
    for (half_price_ = 2; half_price_ > 0.05; half_price_ /= 2) // metres
      expand(every, nullptr, 4);
    half_price_ = 0;
    for (std::size_t line = 0; line < uses_.size(); ++line)
      may_use_[line] = uses_[line].borders > 0 ? 1 : 0;
    expand(every, nullptr, 4);
    while (prune())
      expand(every, nullptr, 4);
  }

  const std::vector<int>& labels() const { return labels_; }

private:
  /** @brief The borders of a line that are walls. */
  struct LineUse {
    std::size_t borders = 0;
    double length = 0; ///< metres
  };

  using Changes = std::vector<std::pair<std::size_t, int>>; ///< labels of cells

  double borderCost(std::size_t b, int left, int right) const
  {
    return left == right
               ? 0
               : costs_.ofBorder(b, left, right, may_use_[borders_[b].line] != 0);
  }

  bool isWall(std::size_t b) const
  {
    return labels_[borders_[b].left] != labels_[borders_[b].right];
  }

  /** @brief Returns what the use of a line costs: all or nothing, or, while
   * `half_price_` is above zero, the more the more of the line is in use. Lines then
   * compete all at once, in cuts that know the slope of this concave price, see
   * rateOf() (majorisation). */
  double priceOf(std::size_t line) const
  {
    const LineUse& use = uses_[line];
    return use.borders == 0 ? 0
                            : price_ * lines_[line].parameters * use.length /
                                  (use.length + half_price_);
  }

  /** @brief Returns what a metre more of a line would cost. */
  double rateOf(std::size_t line) const
  {
    const double length = uses_[line].length + half_price_;
    return half_price_ > 0
               ? price_ * lines_[line].parameters * half_price_ / (length * length)
               : 0;
  }

  /** @brief Returns what a border costs in a cut. */
  double cutCost(std::size_t b, int left, int right) const
  {
    return borderCost(b, left, right) +
           (left == right ? 0 : rateOf(borders_[b].line) * borders_[b].length());
  }

  /** @brief Sets labels. Returns by how much the energy rises. */
  double set(const Changes& changes)
  {
    double rise = 0;
    for (const auto& [cell, label] : changes) {
      const auto add = [&, c = cell](int sign) {
        rise += sign * costs_.ofCell(c, labels_[c]);
        for (const std::size_t b : of_cell_[c]) {
          const CellBorder& border = borders_[b];
          rise += sign * borderCost(b, labels_[border.left], labels_[border.right]);
          if (!isWall(b))
            continue;
          LineUse& use = uses_[border.line];
          rise -= priceOf(border.line);
          use.borders += static_cast<std::size_t>(sign);
          use.length = use.borders > 0 ? use.length + sign * border.length() : 0;
          rise += priceOf(border.line);
        }
      };
      add(-1);
      labels_[cell] = label;
      add(1);
    }
    return rise;
  }

  /** @brief Lets each of some labels take of some cells what lowers the energy. Returns
   * by how much it rises, and what the labels were before.
   * @param cells null: those near each label */
  std::pair<double, Changes> expand(const std::vector<int>& alphas,
                                    const std::vector<std::size_t>* cells,
                                    int sweeps)
  {
    double rise = 0;
    Changes before;
    for (bool goes_on = true; goes_on && sweeps-- > 0;) {
      goes_on = false;
      for (const int alpha : alphas) {
        Changes changes = taken(alpha, cells ? *cells : costs_.cellsNear(alpha));
        Changes old;
        for (const auto& [cell, label] : changes)
          old.emplace_back(cell, labels_[cell]);
        const double change = set(changes);
        if (change < -1e-6) {
          rise += change;
          before.insert(before.end(), old.begin(), old.end());
          goes_on = true;
        }
        else
          set(old);
      }
    }
    std::reverse(before.begin(), before.end());
    return {rise, std::move(before)};
  }

  /** @brief Returns what a label takes of some cells; the others keep theirs. */
  Changes taken(int alpha, const std::vector<std::size_t>& cells)
  {
    BinaryEnergy cut(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
      local_[cells[i]] = i;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::size_t c = cells[i];
      double no = costs_.ofCell(c, labels_[c]);
      double yes = costs_.ofCell(c, alpha);
      for (const std::size_t b : of_cell_[c]) {
        const CellBorder& border = borders_[b];
        const int left = labels_[border.left];
        const int right = labels_[border.right];
        const std::size_t other = border.left == c ? border.right : border.left;
        if (local_[other] == none) {
          no += cutCost(b, left, right);
          yes += border.left == c ? cutCost(b, alpha, right) : cutCost(b, left, alpha);
          continue;
        }
        if (border.left != c)
          continue;
        const double no_yes = cutCost(b, left, alpha);
        const double yes_no = cutCost(b, alpha, right);
        // A thin part of `alpha` between two others may cost less than their border.
        const double no_no = std::min(cutCost(b, left, right), no_yes + yes_no);
        if (no_yes + yes_no > 0)
          cut.addPair(i, local_[other], no_no, no_yes, yes_no, 0);
      }
      cut.addTerm(i, no, yes);
    }
    const std::vector<std::uint8_t> takes = cut.minimise();
    Changes changes;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      local_[cells[i]] = none;
      if (takes[i] && labels_[cells[i]] != alpha)
        changes.emplace_back(cells[i], alpha);
    }
    return changes;
  }

  /** @brief Leaves lines out, those first of which least is used, where that lowers the
   * energy. Returns whether there were any. */
  bool prune()
  {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t line = 0; line < uses_.size(); ++line)
      if (uses_[line].borders > 0)
        order.emplace_back(uses_[line].length, line);
    std::sort(order.begin(), order.end());
    bool is_better = false;
    for (const auto& [length, line] : order)
      is_better = tryWithout(line) || is_better;
    return is_better;
  }

  /** @brief Returns the cells within reach of the walls on a line. */
  std::vector<std::size_t> cellsNear(std::size_t line) const
  {
    std::vector<std::size_t> cells;
    std::set<std::size_t> found;
    const auto add = [&](std::size_t c) {
      if (found.insert(c).second)
        cells.push_back(c);
    };
    for (const std::size_t b : of_line_[line])
      if (isWall(b))
        for (const std::size_t c : {borders_[b].left, borders_[b].right})
          add(c);
    std::size_t first = 0;
    for (int step = 0; step < steps; ++step) {
      const std::size_t end = cells.size();
      for (; first < end; ++first)
        for (const std::size_t b : of_cell_[cells[first]]) {
          add(borders_[b].left);
          add(borders_[b].right);
        }
    }
    std::sort(cells.begin(), cells.end());
    return cells;
  }

  bool tryWithout(std::size_t line)
  {
    std::set<int> beside{0};
    double rise = 0;
    for (const std::size_t b : of_line_[line])
      if (isWall(b)) {
        const int left = labels_[borders_[b].left];
        const int right = labels_[borders_[b].right];
        beside.insert({left, right});
        rise += costs_.ofBorder(b, left, right, false) - borderCost(b, left, right);
      }
    const std::vector<std::size_t> cells = cellsNear(line);
    may_use_[line] = 0;
    const auto [change, before] = expand({beside.begin(), beside.end()}, &cells, 2);
    if (rise + change < -1e-6)
      return true;
    set(before);
    may_use_[line] = 1;
    return false;
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  static constexpr int steps = 12; ///< cells about a line that may change without it

  const StoreyCosts& costs_;
  const std::vector<StoreyLine>& lines_;
  const std::vector<CellBorder>& borders_;
  double price_;
  double half_price_ = 0; ///< length of a line, metres, whose use costs half its price
  std::vector<std::uint8_t> may_use_; ///< of each line
  std::vector<LineUse> uses_;
  std::vector<std::vector<std::size_t>> of_line_; ///< its borders
  std::vector<std::vector<std::size_t>> of_cell_;
  std::vector<std::size_t> local_; ///< numbers of the cells of a cut
  std::vector<int> labels_;
};

} // namespace

void
labelStorey(const StoreyEvidence& evidence,
            const StoreyEnergy& energy,
            std::vector<PlanRoom>& rooms)
{
  if (evidence.storey.rooms.empty())
    return;
  StoreyLines found = storeyLines(evidence);
  std::vector<StoreyLine>& lines = found.lines;
  Eigen::AlignedBox2d box;
  for (const std::size_t r : evidence.storey.rooms) {
    box.extend(evidence.grid.centre(evidence.cells[r].seen.box().low));
    box.extend(evidence.grid.centre(evidence.cells[r].seen.box().high));
  }
  std::vector<std::size_t> line_of;
  PlanCells arrangement(box, dividersOf(lines, evidence.max_wall, line_of));
  const std::vector<StoreyLine> bounds = airBounds(evidence, lines, arrangement);
  if (!bounds.empty()) {
    lines.insert(lines.end(), bounds.begin(), bounds.end());
    line_of.clear();
    arrangement = PlanCells(box, dividersOf(lines, evidence.max_wall, line_of));
  }
  std::vector<CellBorder> borders = arrangement.borders();
  nameBorders(lines, line_of, borders);
  const StoreyCosts costs(evidence, energy, found, arrangement, borders);
  const StoreyLabelling labelling(costs, lines, borders, energy.line);
  std::vector<PlanCurve> curves;
  for (const StoreyLine& line : lines)
    curves.push_back(line.curve);
  std::vector<LabelLoops> all =
      labelLoops(borders, labelling.labels(),
                 static_cast<int>(evidence.storey.rooms.size()), curves);
  for (std::size_t k = 0; k < all.size(); ++k) {
    LabelLoops& loops = all[k];
    if (loops.outer.elements.empty())
      continue;
    PlanRoom& room = rooms[evidence.storey.rooms[k]];
    room.boundary = std::move(loops.outer);
    room.columns = std::move(loops.holes);
  }
}

} // namespace pcl::sedr
