// SPDX-License-Identifier: BSD-3-Clause
#include "line_pieces.h"

#include <Eigen/Cholesky>
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
    for (std::size_t k = first; k <= last; ++k) {
      if (arc.distance(line_[k]) > part * tolerance_)
        return false;
      length += k > first ? (line_[k] - line_[k - 1]).norm() : 0;
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

/** @brief Returns places on the ellipse nearest to a closed line, closed; none if its
 * corners are farther from it than the tolerance, root mean square. */
std::vector<Eigen::Vector2d>
ellipseNear(const std::vector<Eigen::Vector2d>& line, double tolerance)
{
  // a x^2 + b x y + c y^2 + d x + e y = 1 about the middle, by the middles of its
  // segments and their ends: a border's corners are farther out than its segments.
  constexpr int parts = 4;
  const auto size = static_cast<double>(line.size());
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : line)
    middle += corner / size;
  using Row = Eigen::Matrix<double, 5, 1>;
  const auto rowOf = [&](const Eigen::Vector2d& q) {
    return Row(q.x() * q.x(), q.x() * q.y(), q.y() * q.y(), q.x(), q.y());
  };
  Eigen::Matrix<double, 5, 5> squares = Eigen::Matrix<double, 5, 5>::Zero();
  Row sum = Row::Zero();
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
    for (int i = 0; i < parts; ++i) {
      const double weight = (line[k + 1] - line[k]).norm();
      const Row row =
          rowOf(line[k] + (i + 0.5) / parts * (line[k + 1] - line[k]) - middle);
      squares += weight * row * row.transpose();
      sum += weight * row;
    }
  const Row f = squares.ldlt().solve(sum);
  Eigen::Matrix2d shape;
  shape << f[0], f[1] / 2, f[1] / 2, f[2];
  if (!f.allFinite() || !(shape.determinant() > 0) || !(f[0] > 0))
    return {};
  const Eigen::Vector2d centre = -shape.inverse() * f.segment<2>(3) / 2;
  const double level = 1 + centre.dot(shape * centre);
  const auto onEllipse = [&](const Eigen::Vector2d& way) -> Eigen::Vector2d {
    return middle + centre + way * std::sqrt(level / way.dot(shape * way));
  };
  double off = 0;
  for (const Eigen::Vector2d& corner : line)
    off += (corner - onEllipse(corner - middle - centre)).squaredNorm() / size;
  if (!(std::sqrt(off) <= tolerance))
    return {};
  constexpr int places = 96;
  std::vector<Eigen::Vector2d> ellipse;
  for (int k = 0; k < places; ++k) {
    const double turn = 2 * M_PI * k / places;
    ellipse.push_back(onEllipse({std::cos(turn), std::sin(turn)}));
  }
  ellipse.push_back(ellipse.front());
  return ellipse;
}

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
  constexpr std::size_t round = 8; // corners; a coffer has fewer
  LinePieces parts(line, tolerance);
  if (line.size() > 1)
    parts.add(0, line.size() - 1);
  if (parts.pieces.size() < round || line.front() != line.back())
    return parts.pieces;
  const std::vector<Eigen::Vector2d> ellipse = ellipseNear(line, tolerance);
  if (ellipse.empty())
    return parts.pieces;
  LinePieces arcs(ellipse, tolerance);
  arcs.add(0, ellipse.size() - 1);
  return arcs.pieces;
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
