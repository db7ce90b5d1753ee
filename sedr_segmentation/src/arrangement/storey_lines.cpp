// SPDX-License-Identifier: BSD-3-Clause
#include "storey_lines.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Appends lines across the ends of faces that end at no other one; midway
 * between ends of several. */
void
appendEdges(std::vector<StoreyLine>& lines)
{
  constexpr double reach = 0.6; // metres to both sides
  constexpr double near =
      0.1; // metres, of another line: near corners ends are not seen
  constexpr double shortest = 0.2; // metres, of a face that is found
  const std::size_t faces = lines.size();
  std::vector<Eigen::AlignedBox2d> ends; // by edge
  for (std::size_t k = 0; k < faces; ++k) {
    const StoreyLine line = lines[k];
    if (line.is_end || line.isWhole())
      continue;
    for (const double s : line.edges) {
      const Eigen::Vector2d p = line.at(s);
      const Eigen::Vector2d way = line.curve.tangentAt(p);
      const auto across =
          std::find_if(lines.begin(), lines.end(), [&](const StoreyLine& other) {
            const double t = other.along(p);
            return other.curve.distance(p) < near && t > other.from - reach &&
                   t < other.to + reach &&
                   std::abs(other.curve.tangentAt(p).dot(way)) < 0.7;
          });
      if (across != lines.end()) {
        if (across->is_end) {
          Eigen::AlignedBox2d& of =
              ends[static_cast<std::size_t>(across - lines.begin()) - faces];
          const Eigen::Vector2d to_middle = of.extend(p).center() - across->curve.point;
          const Eigen::Vector2d normal = leftOf(across->curve.direction);
          across->curve.point += normal.dot(to_middle) * normal;
        }
        continue;
      }
      // Sides of pilasters may be too short.
      lines.push_back(endLine(p, leftOf(way), reach, shortest, line.near));
      ends.emplace_back(p);
    }
  }
}

} // namespace

StoreyLine
endLine(const Eigen::Vector2d& middle,
        const Eigen::Vector2d& direction,
        double reach,
        double beyond,
        double near)
{
  StoreyLine line;
  line.is_end = true;
  line.curve.point = middle;
  line.curve.direction = direction;
  line.from = -reach;
  line.to = reach;
  line.near = near;
  const auto bins = static_cast<std::size_t>(2 * reach / StoreyLine::bin) + 2;
  line.any.assign(bins, 0);
  line.tall = line.any;
  line.between.assign(bins, StoreyLine::Between::Nothing);
  for (std::size_t i = 0; i < bins; ++i)
    if (std::abs((static_cast<double>(i) + 0.5) * StoreyLine::bin - reach) < beyond)
      line.between[i] = StoreyLine::Between::Beyond;
  return line;
}

StoreyLines
storeyLines(const StoreyEvidence& storey)
{
  std::vector<Eigen::Vector2d> places;
  std::vector<float> shares;
  for (const std::size_t r : storey.storey.rooms) {
    const RoomCells& room = storey.cells[r];
    places.insert(places.end(), room.wall_points.begin(), room.wall_points.end());
    shares.insert(shares.end(), room.wall_shares.begin(), room.wall_shares.end());
  }
  const FacePlaces on_faces(places, shares, storey.threads);
  const FaceCurves faces = faceCurves(on_faces, storey.radii, storey.threads);
  StoreyLines storey_lines{{}, faces.certainty};
  std::vector<StoreyLine>& lines = storey_lines.lines;
  for (const FaceCurve& face : faces.curves) {
    StoreyLine& line = lines.emplace_back();
    static_cast<FaceCurve&>(line) = face;
    line.parameters = face.curve.isCircle() ? 3 : face.is_main ? 1 : 2;
  }
  const LineEvidence evidence(storey, on_faces);
  const auto forEachLine = [&](const auto& body) {
    parallelBlocks(lines.size(), 1, storey.threads,
                   [&](std::size_t k, std::size_t) { body(lines[k]); });
  };
  forEachLine([&](StoreyLine& line) {
    constexpr double beyond_arc = 0.2; // metres: a turn that goes on is seen
    const double on =
        line.curve.isCircle()
            ? std::min(beyond_arc, M_PI * line.curve.radius - (line.to - line.from) / 2)
            : long_face;
    line.from -= on;
    line.to += on;
    line.near = storey.near;
    evidence.observe(line);
  });
  const std::vector<StoreyLine> seen = lines;
  forEachLine([&](StoreyLine& line) { evidence.extendToCorners(seen, line); });
  forEachLine([&](StoreyLine& line) { evidence.findBetween(line); });
  appendEdges(lines);
  std::stable_sort(lines.begin(), lines.end(),
                   [](const StoreyLine& a, const StoreyLine& b) {
                     const auto order = [](const StoreyLine& line) {
                       return std::make_tuple(line.is_end, line.curve.isCircle(),
                                              -line.support(), line.from - line.to);
                     };
                     return order(a) < order(b);
                   });
  return storey_lines;
}

} // namespace pcl::sedr
