// SPDX-License-Identifier: BSD-3-Clause
#include "storey_lines.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double beyond = 4; // metres that a line goes on past its seen ends,
constexpr double beyond_arc = 0.2;
constexpr double aligned = 0.966; // cosine

/** @brief A place at a surface or at the end of air, and the normal there. */
struct NormalPlace {
  Eigen::Vector2d at;
  Eigen::Vector2d normal;
};

/** @brief Returns the places where the seen air of a room ends, normals out of it. */
std::vector<NormalPlace>
endsOfAir(const RoomCells& room, const CellGrid& grid)
{
  constexpr double holes = 3; // cells
  constexpr int reach = 3;    // cells
  const CellMask seen = eroded(dilated(room.seen, holes), holes);
  std::vector<NormalPlace> ends;
  for (std::size_t i = 0; i < seen.values().size(); ++i) {
    const Cell cell = seen.cellAt(i);
    if (!seen.values()[i] ||
        (seen.at({cell.x + 1, cell.y}) && seen.at({cell.x - 1, cell.y}) &&
         seen.at({cell.x, cell.y + 1}) && seen.at({cell.x, cell.y - 1})))
      continue;
    Eigen::Vector2d out = Eigen::Vector2d::Zero();
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x)
        if (!seen.at({cell.x + x, cell.y + y}))
          out += Eigen::Vector2d(x, y);
    if (out.norm() > 0)
      ends.push_back(
          {grid.centre(cell) + grid.size() / 2 * out.normalized(), out.normalized()});
  }
  return ends;
}

/** @brief Appends the lines at which the air of a room ends without a surface. */
void
appendEnds(const RoomCells& room,
           const CellGrid& grid,
           const std::vector<Eigen::Vector2d>& normals,
           std::vector<StoreyLine>& lines)
{
  constexpr double near = 0.2; // metres
  constexpr double on = 1;     // metre that a line goes on
  const CellBox& cells = room.seen.box();
  const Eigen::AlignedBox2d box(grid.centre(cells.low), grid.centre(cells.high));
  std::vector<const StoreyLine*> faces;
  for (const StoreyLine& line : lines)
    if (!line.is_end && line.box().intersects(box))
      faces.push_back(&line);
  std::vector<NormalPlace> ends;
  for (const NormalPlace& end : endsOfAir(room, grid)) {
    const auto isBeside = [&](const StoreyLine* line) {
      const double s = line->along(end.at);
      return line->curve.distance(end.at) <= near && s > line->from - near &&
             s < line->to + near &&
             std::abs(line->curve.tangentAt(end.at).dot(end.normal)) < 0.7;
    };
    if (std::none_of(faces.begin(), faces.end(), isBeside))
      ends.push_back(end);
  }
  for (const Eigen::Vector2d& normal : normals) {
    std::vector<std::pair<double, double>> places; // offset, along
    for (const NormalPlace& end : ends)
      if (std::abs(end.normal.dot(normal)) > aligned)
        places.emplace_back(normal.dot(end.at), leftOf(normal).dot(end.at));
    for (const FaceCurve& run : linesAlong(std::move(places), normal,
                                           {grid.size(), 2 * grid.size(), 1, 0.5})) {
      StoreyLine& line = lines.emplace_back();
      static_cast<FaceCurve&>(line) = run;
      line.is_end = true;
      line.from -= on;
      line.to += on;
    }
  }
}

/** @brief Appends lines across the ends of faces that end at no other one. */
void
appendEdges(std::vector<StoreyLine>& lines)
{
  constexpr double reach = 0.6;    // metres to both sides
  constexpr double near = 0.06;    // metres, of another line
  constexpr double shortest = 0.2; // metres, of a face that is found
  const std::size_t faces = lines.size();
  for (std::size_t k = 0; k < faces; ++k) {
    const StoreyLine line = lines[k];
    if (line.is_end || line.isWhole())
      continue;
    for (const double s : line.edges) {
      const Eigen::Vector2d p = line.at(s);
      const Eigen::Vector2d way = line.curve.tangentAt(p);
      if (std::any_of(lines.begin(), lines.end(), [&](const StoreyLine& other) {
            const double t = other.along(p);
            return other.curve.distance(p) < near && t > other.from - reach &&
                   t < other.to + reach &&
                   std::abs(other.curve.tangentAt(p).dot(way)) < 0.7;
          }))
        continue;
      StoreyLine edge;
      edge.is_end = true;
      edge.curve.point = p;
      edge.curve.direction = leftOf(way);
      edge.from = -reach;
      edge.to = reach;
      edge.near = line.near;
      const auto bins = static_cast<std::size_t>(2 * reach / StoreyLine::bin) + 2;
      edge.any.assign(bins, 0);
      edge.tall = edge.any;
      edge.between.assign(bins, StoreyLine::Between::Nothing);
      for (std::size_t i = 0; i < bins; ++i) // sides of pilasters may be too short
        if (std::abs((static_cast<double>(i) + 0.5) * StoreyLine::bin - reach) <
            shortest)
          edge.between[i] = StoreyLine::Between::Beyond;
      lines.push_back(std::move(edge));
    }
  }
}

} // namespace

StoreyLines
storeyLines(const StoreyEvidence& storey)
{
  std::vector<Eigen::Vector2d> places;
  for (const std::size_t r : storey.storey.rooms)
    places.insert(places.end(), storey.cells[r].wall_points.begin(),
                  storey.cells[r].wall_points.end());
  const FaceCurves faces = faceCurves(places, storey.radii, storey.threads);
  StoreyLines storey_lines{{}, faces.certainty};
  std::vector<StoreyLine>& lines = storey_lines.lines;
  for (const FaceCurve& face : faces.curves) {
    StoreyLine& line = lines.emplace_back();
    static_cast<FaceCurve&>(line) = face;
    line.parameters = face.curve.isCircle() ? 3 : face.is_main ? 1 : 2;
  }
  for (const std::size_t r : storey.storey.rooms)
    appendEnds(storey.cells[r], storey.grid, faces.normals, lines);
  const LineEvidence evidence(storey);
  const auto forEachLine = [&](const auto& body) {
    parallelBlocks(lines.size(), 1, storey.threads,
                   [&](std::size_t k, std::size_t) { body(lines[k]); });
  };
  forEachLine([&](StoreyLine& line) {
    const double on =
        line.is_end ? 0
        : line.curve.isCircle()
            ? std::min(beyond_arc, M_PI * line.curve.radius - (line.to - line.from) / 2)
            : beyond;
    line.from -= on;
    line.to += on;
    line.near = storey.near;
    evidence.observe(line);
  });
  forEachLine([&](StoreyLine& line) { evidence.findBetween(lines, line); });
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
