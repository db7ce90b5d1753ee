// SPDX-License-Identifier: BSD-3-Clause
#include "loop_samples.h"

#include "../curves/contour.h"
#include "sedr_filters/src/base/middle_value.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

constexpr double inside = 0.35; // metres: surfaces are looked for from here
constexpr double outside = 0.7; // to here

/** @brief Returns a closed polygon with corners of equal spacing. */
std::vector<Eigen::Vector2d>
resampled(const std::vector<Eigen::Vector2d>& polygon, double spacing)
{
  double length = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    length += (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
  const auto count = std::max<std::size_t>(
      12, static_cast<std::size_t>(std::lround(length / spacing)));
  std::vector<Eigen::Vector2d> places;
  double done = 0;
  std::size_t i = 0;
  double edge = (polygon[1] - polygon[0]).norm();
  for (std::size_t k = 0; k < count; ++k) {
    const double s = length * static_cast<double>(k) / static_cast<double>(count);
    while (s > done + edge && i + 1 < polygon.size()) {
      done += edge;
      ++i;
      edge = (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
    }
    const double t = edge > 0 ? std::min(1.0, (s - done) / edge) : 0;
    places.push_back(polygon[i] + t * (polygon[(i + 1) % polygon.size()] - polygon[i]));
  }
  return places;
}

/** @brief Returns a closed polygon whose corners are means of five neighbours, so that
 * the steps of cells vanish. */
std::vector<Eigen::Vector2d>
smoothed(const std::vector<Eigen::Vector2d>& polygon)
{
  constexpr std::array<double, 5> kernel{0.11, 0.24, 0.3, 0.24, 0.11};
  const std::size_t n = polygon.size();
  std::vector<Eigen::Vector2d> result(n, Eigen::Vector2d::Zero());
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < kernel.size(); ++k)
      result[i] += kernel[k] * polygon[(i + n + k - 2) % n];
  return result;
}

LoopContour
contourThrough(const Contour& contour, const CellGrid& grid, std::size_t room)
{
  LoopContour result;
  result.room = room;
  result.is_hole = signedArea(contour) < 0;
  const std::vector<Eigen::Vector2d> places = resampled(smoothed(contour), grid.size());
  const std::size_t n = places.size();
  std::vector<Eigen::Vector2d> chords(n);
  for (std::size_t i = 0; i < n; ++i)
    chords[i] = places[(i + 1) % n] - places[(i + n - 1) % n];
  for (std::size_t i = 0; i < n; ++i) {
    Eigen::Vector2d tangent = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < 7; ++k) {
      const double d = (static_cast<double>(k) - 3) / 1.5;
      tangent += std::exp(-0.5 * d * d) * chords[(i + n + k - 3) % n];
    }
    tangent /= std::max(tangent.norm(), 1e-9);
    LoopSample sample;
    sample.place = places[i];
    sample.normal = {tangent.y(), -tangent.x()};
    sample.anchor = places[i];
    result.samples.push_back(sample);
  }
  return result;
}

/** @brief Fills the table of areas of a sample. */
void
fillAreas(const LoopSample& sample,
          const LoopCells& cells,
          const CellGrid& grid,
          const LoopEnergy& energy,
          float* row)
{
  const AreaTable table;
  const double size = grid.size();
  const double strip = table.step * size; // square metres of a step
  const auto is = [&](const CellMask* mask, const Eigen::Vector2d& p) {
    return mask && mask->at(grid.at(p.x(), p.y())) != 0;
  };
  double sum = 0;
  for (int k = 1; k <= table.half; ++k) {    // inwards
    const double t = (0.5 - k) * table.step; // the middle of a step
    const Eigen::Vector2d p = sample.place + t * sample.normal;
    if (t < -size && is(cells.region, p))
      sum += strip * (!cells.seen || is(cells.seen, p) ? energy.cut : energy.add);
    row[table.half - k] = static_cast<float>(sum);
  }
  sum = 0;
  row[table.half] = 0;
  for (int k = 1; k <= table.half; ++k) { // outwards
    const double t = (k - 0.5) * table.step;
    const Eigen::Vector2d p = sample.place + t * sample.normal;
    if (t > size / 2 && !is(cells.region, p))
      sum += strip * (is(cells.others, p) ? energy.other : energy.add);
    row[table.half + k] = static_cast<float>(sum);
  }
}

/** @brief Finds up to three surfaces beside a sample: peaks of the density of points
 * along its normal. */
void
findPeaks(const LoopContour& contour, std::size_t i, double width, LoopSample& sample)
{
  constexpr double bin = 0.005;
  constexpr double least = 0.5; // points of a peak
  constexpr auto bins = static_cast<int>((inside + outside) / bin + 0.5) + 1;
  std::array<double, bins> density{};
  for (std::size_t k = contour.first[i]; k < contour.first[i + 1]; ++k) {
    const double o = (contour.points[k] - sample.place).dot(sample.normal) + inside;
    const int from = std::max(0, static_cast<int>((o - 3 * width) / bin));
    const int to = std::min(bins, static_cast<int>((o + 3 * width) / bin) + 2);
    for (int j = from; j < to; ++j) {
      const double d = (j * bin - o) / width;
      density[static_cast<std::size_t>(j)] += std::exp(-0.5 * d * d);
    }
  }
  sample.offset.fill(0);
  sample.weight.fill(0);
  for (int j = 1; j + 1 < bins; ++j) {
    const double* const h = density.data() + j;
    if (!(h[0] > least && h[0] >= h[-1] && h[0] > h[1]))
      continue;
    const auto least_of = static_cast<std::size_t>(
        std::min_element(sample.weight.begin(), sample.weight.end()) -
        sample.weight.begin());
    if (h[0] <= sample.weight[least_of])
      continue;
    const double curvature = std::max(2 * h[0] - h[-1] - h[1], 1e-12);
    sample.offset[least_of] = j * bin - inside + bin / 2 * (h[1] - h[-1]) / curvature;
    sample.weight[least_of] = h[0];
  }
}

double
most(const LoopSample& sample)
{
  return *std::max_element(sample.weight.begin(), sample.weight.end());
}

/** @brief Sets the share of each surface that does not count: what stands before it,
 * and what it lacks itself. Those behind do not matter. */
void
weighSurfaces(double usual, double width, LoopSample& sample)
{
  const double densest = most(sample);
  for (std::size_t q = 0; q < sample.weight.size(); ++q) {
    sample.before[q] = 1;
    if (!(sample.weight[q] > 0))
      continue;
    double share = 1 - std::min(1.0, sample.weight[q] / std::min(densest, usual / 4));
    for (std::size_t p = 0; p < sample.weight.size(); ++p)
      if (sample.weight[p] > 0 && sample.offset[p] < sample.offset[q] - 3 * width)
        share += sample.weight[p] / densest;
    sample.before[q] = std::min(1.0, share);
  }
}

/** @brief Puts the anchor of a sample onto the surface that costs least. */
void
setAnchor(const float* areas, double outlier, LoopSample& sample)
{
  const AreaTable table;
  double least = std::numeric_limits<double>::infinity();
  sample.anchor = sample.place;
  for (std::size_t q = 0; q < sample.weight.size(); ++q) {
    if (!(sample.weight[q] > 0))
      continue;
    const double cost = outlier * sample.before[q] + areas[table.at(sample.offset[q])];
    if (cost < least) {
      least = cost;
      sample.anchor = sample.place + sample.offset[q] * sample.normal;
    }
  }
}

/** @brief Returns how far outwards the surfaces of a sample may lie: nearer to it than
 * to where its room goes on, as on the other side of a column; two cells at least. */
double
reachOf(const LoopSample& sample, const CellMask& region, const CellGrid& grid)
{
  for (double t = 2 * grid.size(); t < 2 * outside; t += grid.size() / 2) {
    const Eigen::Vector2d p = sample.place + t * sample.normal;
    if (region.at(grid.at(p.x(), p.y())))
      return std::max(t / 2, 2 * grid.size());
  }
  return outside;
}

} // namespace

std::vector<LoopContour>
contoursOf(const CellMask& region, const CellGrid& grid, std::size_t room)
{
  constexpr double shortest = 0.5; // metres
  std::vector<LoopContour> contours;
  for (const Contour& contour : traceContours(region, grid.size()))
    if (static_cast<double>(contour.size()) * grid.size() > shortest)
      contours.push_back(contourThrough(contour, grid, room));
  std::stable_sort(contours.begin(), contours.end(),
                   [](const LoopContour& a, const LoopContour& b) {
                     return std::make_pair(a.is_hole, b.samples.size()) <
                            std::make_pair(b.is_hole, a.samples.size());
                   });
  return contours;
}

void
gatherBeside(const PlanPoints& walls,
             const LoopCells& cells,
             const CellGrid& grid,
             const LoopEnergy& energy,
             LoopContour& contour)
{
  const AreaTable table;
  const double half = grid.size() / 2;
  contour.first.assign(1, 0);
  contour.area.resize(contour.samples.size() *
                      static_cast<std::size_t>(table.columns()));
  for (std::size_t i = 0; i < contour.samples.size(); ++i) {
    const LoopSample& sample = contour.samples[i];
    const Eigen::Vector2d along(-sample.normal.y(), sample.normal.x());
    const double reach = reachOf(sample, *cells.region, grid);
    walls.forEachWithin(sample.place, outside, [&](const Eigen::Vector2d& p) {
      const double o = (p - sample.place).dot(sample.normal);
      if (o > -inside && o < reach && std::abs((p - sample.place).dot(along)) < half)
        contour.points.push_back(p);
    });
    contour.first.push_back(contour.points.size());
    fillAreas(sample, cells, grid, energy,
              contour.area.data() + i * static_cast<std::size_t>(table.columns()));
  }
}

void
findSurfaces(std::vector<LoopContour>& contours,
             const LoopEnergy& energy,
             double spacing)
{
  constexpr double width = 0.01; // metres: scatter of the points of a surface
  const double outlier = energy.outlier * spacing / energy.max_correlation * 2;
  const AreaTable table;
  for (LoopContour& contour : contours)
    for (std::size_t i = 0; i < contour.samples.size(); ++i)
      findPeaks(contour, i, width, contour.samples[i]);
  std::vector<double> counts;
  for (const LoopContour& contour : contours)
    for (const LoopSample& sample : contour.samples)
      if (most(sample) > 0)
        counts.push_back(most(sample));
  const double usual = counts.empty() ? 1 : middleValue(std::move(counts));
  for (LoopContour& contour : contours)
    for (std::size_t i = 0; i < contour.samples.size(); ++i) {
      LoopSample& sample = contour.samples[i];
      const double n = most(sample);
      sample.seen = n > 0.05 * usual ? std::min(1.0, n / (usual / 4)) : 0;
      sample.points = static_cast<std::size_t>(n);
      weighSurfaces(usual, width, sample);
      if (n > 0)
        setAnchor(contour.area.data() + i * static_cast<std::size_t>(table.columns()),
                  outlier, sample);
    }
}

} // namespace pcl::sedr
