// SPDX-License-Identifier: BSD-3-Clause
#include "line_pieces.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pcl::sedr {
namespace {

/** @brief A line and the pieces it is divided into. */
class LinePieces {
public:
  LinePieces(const std::vector<Eigen::Vector2d>& line, double tolerance)
      : line_(line)
      , tolerance_(tolerance)
  {}

  /** @brief Appends the part between two of the places. */
  void add(std::size_t first, std::size_t last)
  {
    PlanElement piece;
    piece.start = line_[first];
    piece.end = line_[last];
    std::size_t farthest = first;
    double most = tolerance_;
    for (std::size_t k = first + 1; k < last; ++k) {
      const double distance = piece.length() > 0 ? piece.distance(line_[k])
                                                 : (line_[k] - piece.start).norm();
      if (distance <= most)
        continue;
      most = distance;
      farthest = k;
    }
    if (farthest == first || isArc(first, last, piece)) {
      pieces.push_back(piece);
      return;
    }
    add(first, farthest);
    add(farthest, last);
  }

  std::vector<PlanElement> pieces;

private:
  /** @brief Tries the circle through three of the places. */
  bool isArc(std::size_t first, std::size_t last, PlanElement& piece) const
  {
    constexpr std::size_t fewest = 8;
    constexpr double part = 1.0 / 3; // of the tolerance
    if (last - first + 1 < fewest)
      return false;
    const bool is_closed = piece.length() == 0;
    const Eigen::Vector2d& a = line_[first];
    const Eigen::Vector2d& b = line_[first + (last - first) / (is_closed ? 3 : 2)];
    const Eigen::Vector2d& c =
        is_closed ? line_[first + 2 * (last - first) / 3] : piece.end;
    Eigen::Matrix2d chords;
    chords << (b - a).transpose(), (c - a).transpose();
    const double across = chords.determinant();
    if (std::abs(across) < 1e-9)
      return false;
    PlanElement arc = piece;
    arc.centre = a + chords.inverse() *
                         Eigen::Vector2d((b - a).squaredNorm(), (c - a).squaredNorm()) /
                         2;
    arc.radius = (a - arc.centre).norm();
    arc.counter_clockwise = across > 0;
    double length = 0;
    for (std::size_t k = first + 1; k <= last; ++k) {
      const Eigen::Vector2d middle =
          (line_[k - 1] + line_[k]) / 2; // of a polygon's side
      if (std::max(arc.distance(line_[k]), arc.distance(middle)) > part * tolerance_)
        return false;
      length += (line_[k] - line_[k - 1]).norm();
    }
    constexpr double same_length = 0.05; // chords are little shorter, detours are not
    if (std::abs(arc.length() - length) > same_length * length)
      return false;
    piece = arc;
    return true;
  }

  const std::vector<Eigen::Vector2d>& line_;
  double tolerance_;
};

/** @brief Returns the area between a segment and the corners of a line, first to
 * last. */
double
areaBetween(const std::vector<Eigen::Vector2d>& corners,
            std::size_t first,
            std::size_t last)
{
  PlanElement chord;
  chord.start = corners[first];
  chord.end = corners[last];
  const auto off = [&](std::size_t k) {
    return chord.length() > 0 ? chord.distance(corners[k])
                              : (corners[k] - chord.start).norm();
  };
  const Eigen::Vector2d way = (chord.end - chord.start).normalized();
  const auto onChord = [&](std::size_t k) {
    const Eigen::Vector2d step = corners[k + 1] - corners[k];
    return chord.length() > 0 ? std::abs(step.dot(way)) : step.norm();
  };
  double area = 0;
  for (std::size_t k = first; k < last; ++k)
    area += (off(k) + off(k + 1)) / 2 * onChord(k);
  return area;
}

/** @brief Appends the segments between some of the corners of a line that cost least,
 * see withoutBulges(). Cost: corners cubed. */
void
addCheapest(const std::vector<Eigen::Vector2d>& corners,
            double corner_cost,
            std::vector<PlanElement>& pieces)
{
  std::vector<double> cost(corners.size(), 0);
  std::vector<std::size_t> before(corners.size(), 0);
  for (std::size_t k = 1; k < corners.size(); ++k) {
    cost[k] = std::numeric_limits<double>::infinity();
    for (std::size_t i = k; i-- > 0;) {
      const double with_it = cost[i] + corner_cost + areaBetween(corners, i, k);
      if (with_it < cost[k]) {
        cost[k] = with_it;
        before[k] = i;
      }
    }
  }
  const auto begin = static_cast<std::ptrdiff_t>(pieces.size());
  for (std::size_t k = corners.size() - 1; k > 0; k = before[k]) {
    PlanElement piece;
    piece.start = corners[before[k]];
    piece.end = corners[k];
    pieces.push_back(piece);
  }
  std::reverse(pieces.begin() + begin, pieces.end());
}

} // namespace

std::vector<PlanElement>
withoutBulges(const std::vector<PlanElement>& line, double min_area)
{
  constexpr std::size_t most = 200; // corners that are looked at together
  std::vector<PlanElement> pieces;
  std::vector<Eigen::Vector2d> corners;
  const auto close = [&] {
    if (!corners.empty())
      addCheapest(corners, min_area / 3, pieces);
    corners.clear();
  };
  for (const PlanElement& piece : line) {
    if (piece.isArc() || corners.size() == most)
      close();
    if (piece.isArc()) {
      pieces.push_back(piece);
      continue;
    }
    if (corners.empty())
      corners.push_back(piece.start);
    corners.push_back(piece.end);
  }
  close();
  return pieces;
}

std::vector<PlanElement>
piecesOf(const std::vector<Eigen::Vector2d>& line, double tolerance)
{
  LinePieces parts(line, tolerance);
  if (line.size() > 1)
    parts.add(0, line.size() - 1);
  return parts.pieces;
}

PlanElement
partPassing(const PlanElement& arc,
            const Eigen::Vector2d& a,
            const Eigen::Vector2d& b,
            const Eigen::Vector2d& passed)
{
  const auto [from, to] = std::minmax({arc.project(a), arc.project(b)});
  const double between = arc.project(passed);
  return from <= between && between <= to ? arc.part(from, to) : arc.part(to, from);
}

} // namespace pcl::sedr
