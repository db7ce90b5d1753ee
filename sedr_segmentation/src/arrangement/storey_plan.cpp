// SPDX-License-Identifier: BSD-3-Clause
#include "storey_plan.h"

#include "../labelling/minimum_cut.h"
#include "label_loops.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns the straight pieces of lines and arcs, numbered by their line. */
std::vector<PlanDivider>
dividersOf(const std::vector<StoreyLine>& lines, std::vector<std::size_t>& line_of)
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
                          static_cast<std::uint32_t>(line_of.size())});
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
  for (CellBorder& border : borders) {
    const auto seenOn = [&](const StoreyLine& line) {
      double seen = 0;
      for (const double t : {0.1, 0.3, 0.5, 0.7, 0.9})
        seen += line.seenAt(border.start + t * (border.end - border.start));
      return seen;
    };
    std::size_t best = line_of[border.line];
    double most = seenOn(lines[best]);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const PlanCurve& curve = lines[k].curve;
      if (curve.isCircle() || curve.distance(border.start) > same ||
          curve.distance(border.end) > same)
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
      , labels_(costs.cells(), 0)
  {
    for (std::size_t c = 0; c < labels_.size(); ++c)
      for (int l = 1; l < static_cast<int>(costs.labels()); ++l)
        if (costs.ofCell(c, l) < costs.ofCell(c, labels_[c]))
          labels_[c] = l;
    std::vector<int> all(costs.labels());
    std::iota(all.begin(), all.end(), 0);
    expand(all, 4);
    prune();
    expand(all, 4);
  }

  const std::vector<int>& labels() const { return labels_; }

private:
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

  double total(const std::vector<int>& labels) const
  {
    double sum = 0;
    for (std::size_t c = 0; c < labels.size(); ++c)
      sum += costs_.ofCell(c, labels[c]);
    std::vector<std::uint8_t> is_used(lines_.size(), 0);
    for (std::size_t b = 0; b < borders_.size(); ++b) {
      const int left = labels[borders_[b].left];
      const int right = labels[borders_[b].right];
      sum += borderCost(b, left, right);
      if (left != right)
        is_used[borders_[b].line] = 1;
    }
    for (std::size_t k = 0; k < lines_.size(); ++k)
      sum += is_used[k] ? price_ * lines_[k].parameters : 0;
    return sum;
  }

  /** @brief Lets each of some labels take what lowers the energy. */
  void expand(const std::vector<int>& alphas, int sweeps)
  {
    cost_ = total(labels_);
    for (double before = cost_ + 1; sweeps-- > 0 && before - cost_ > 1e-6;) {
      before = cost_;
      for (const int alpha : alphas) {
        BinaryEnergy cut(labels_.size());
        for (std::size_t c = 0; c < labels_.size(); ++c)
          cut.addTerm(c, costs_.ofCell(c, labels_[c]), costs_.ofCell(c, alpha));
        for (std::size_t b = 0; b < borders_.size(); ++b) {
          const int left = labels_[borders_[b].left];
          const int right = labels_[borders_[b].right];
          const double no_yes = borderCost(b, left, alpha);
          const double yes_no = borderCost(b, alpha, right);
          // A thin part of `alpha` between two others may cost less than their border.
          const double no_no = std::min(borderCost(b, left, right), no_yes + yes_no);
          if (no_yes + yes_no > 0)
            cut.addPair(borders_[b].left, borders_[b].right, no_no, no_yes, yes_no, 0);
        }
        std::vector<int> labels = labels_;
        const std::vector<std::uint8_t> takes = cut.minimise();
        for (std::size_t c = 0; c < labels.size(); ++c)
          labels[c] = takes[c] ? alpha : labels[c];
        if (const double cost = total(labels); cost < cost_ - 1e-6) {
          cost_ = cost;
          labels_ = std::move(labels);
        }
      }
    }
  }

  /** @brief Leaves lines out, those first of which least is used, while that lowers the
   * energy. */
  void prune()
  {
    constexpr int rounds = 2;
    for (int round = 0; round < rounds; ++round) {
      std::map<std::size_t, double> used;
      for (std::size_t b = 0; b < borders_.size(); ++b)
        if (isWall(b))
          used[borders_[b].line] += borders_[b].length();
      std::vector<std::pair<double, std::size_t>> order;
      for (const auto& [line, length] : used)
        order.emplace_back(length, line);
      std::sort(order.begin(), order.end());
      const double before = cost_;
      for (const auto& [length, line] : order)
        tryWithout(line);
      if (before - cost_ < 1e-6)
        break;
    }
  }

  void tryWithout(std::size_t line)
  {
    std::set<int> beside{0};
    for (std::size_t b = 0; b < borders_.size(); ++b)
      if (borders_[b].line == line && isWall(b))
        beside.insert({labels_[borders_[b].left], labels_[borders_[b].right]});
    const std::vector<int> labels = labels_;
    const double before = cost_;
    may_use_[line] = 0;
    expand({beside.begin(), beside.end()}, 2);
    if (cost_ < before - 1e-6)
      return;
    may_use_[line] = 1;
    labels_ = labels;
    cost_ = before;
  }

  const StoreyCosts& costs_;
  const std::vector<StoreyLine>& lines_;
  const std::vector<CellBorder>& borders_;
  double price_;
  std::vector<std::uint8_t> may_use_; ///< of each line
  std::vector<int> labels_;
  double cost_ = 0;
};

} // namespace

void
labelStorey(const StoreyEvidence& evidence,
            const StoreyEnergy& energy,
            std::vector<PlanRoom>& rooms)
{
  if (evidence.storey.rooms.empty())
    return;
  const std::vector<StoreyLine> lines =
      storeyLines(evidence.storey, evidence.cells, evidence.grid, evidence.radii);
  Eigen::AlignedBox2d box;
  for (const std::size_t r : evidence.storey.rooms) {
    box.extend(evidence.grid.centre(evidence.cells[r].seen.box().low));
    box.extend(evidence.grid.centre(evidence.cells[r].seen.box().high));
  }
  std::vector<std::size_t> line_of;
  const PlanCells arrangement(box, dividersOf(lines, line_of));
  std::vector<CellBorder> borders = arrangement.borders();
  nameBorders(lines, line_of, borders);
  const StoreyCosts costs(evidence, energy, lines, arrangement.polygons(), borders);
  const StoreyLabelling labelling(costs, lines, borders, energy.line);
  std::vector<PlanCurve> curves;
  for (const StoreyLine& line : lines)
    curves.push_back(line.curve);
  for (std::size_t k = 0; k < evidence.storey.rooms.size(); ++k) {
    LabelLoops loops =
        labelLoops(borders, labelling.labels(), static_cast<int>(k) + 1, curves);
    if (loops.outer.elements.empty())
      continue;
    PlanRoom& room = rooms[evidence.storey.rooms[k]];
    room.boundary = std::move(loops.outer);
    room.columns = std::move(loops.holes);
  }
}

} // namespace pcl::sedr
