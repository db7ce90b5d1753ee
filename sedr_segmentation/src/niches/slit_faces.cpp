// SPDX-License-Identifier: BSD-3-Clause
#include "slit_faces.h"

#include "../refit/plan_refit.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/grids/cell_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <numeric>

namespace pcl::sedr {

namespace {

/** @brief Maximum number of points; a larger scan is subsampled. */
constexpr std::size_t max_face_points = 1000000;

using Bins = std::array<std::size_t, SlitFace::Counts::bins>;

/** @brief Returns the bin of a distance below the ceiling. */
std::size_t
binOf(double below)
{
  const double bin = (below - SlitFace::Counts::highest) / SlitFace::Counts::step;
  return static_cast<std::size_t>(
      std::clamp(bin, 0.0, static_cast<double>(SlitFace::Counts::bins)));
}

std::size_t
countBetween(const Bins& counts, double low, double high)
{
  const std::size_t first = binOf(low);
  const std::size_t last = std::max(first, binOf(high));
  return std::accumulate(counts.begin() + static_cast<std::ptrdiff_t>(first),
                         counts.begin() + static_cast<std::ptrdiff_t>(last),
                         std::size_t{0});
}

/** @brief Returns the quantile of the distances below the ceiling. */
double
quantileOf(const Bins& counts, double share)
{
  const double all = static_cast<double>(
      std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
  double passed = 0;
  for (std::size_t b = 0; b < counts.size(); ++b) {
    const auto here = static_cast<double>(counts[b]);
    if (passed + here >= share * all && here > 0)
      return SlitFace::Counts::highest +
             SlitFace::Counts::step *
                 (static_cast<double>(b) + (share * all - passed) / here);
    passed += here;
  }
  return 0;
}

/** @brief Returns the probability of at most `seen` points if `expected` are expected.
 */
double
chanceOf(std::size_t seen, double expected)
{
  double one = std::exp(-expected); // Poisson distribution
  double chance = one;
  for (std::size_t k = 1; k <= seen; ++k) {
    one *= expected / static_cast<double>(k);
    chance += one;
  }
  return chance;
}

} // namespace

SlitFace::SlitFace(const PlanRoom& room,
                   const PlanElement& element,
                   const Priors& priors)
    : element_(element)
    , priors_(priors)
{
  const double middle = element.length() / 2;
  const Eigen::Vector2d before =
      element.pointAt(middle) + priors.surface_band * element.normalAt(middle);
  ceiling_ = room.ceilingSlab(room.detailAt(before));
  low_ = high_ = element.start.array();
  constexpr int parts = 8;
  for (int k = 0; k <= parts; ++k) {
    const Eigen::Array2d place = element.pointAt(element.length() * k / parts).array();
    low_ = low_.min(place);
    high_ = high_.max(place);
  }
  low_ -= farthestBefore();
  high_ += farthestBefore();
}

void
SlitFace::Counts::add(const Counts& other)
{
  for (std::size_t b = 0; b < bins; ++b) {
    face[b] += other.face[b];
    ceiling[b] += other.ceiling[b];
  }
}

void
SlitFace::count(const Eigen::Vector3f& point, Counts& counts) const
{
  const Eigen::Vector2d p = point.head<2>().cast<double>();
  if ((p.array() < low_).any() || (p.array() > high_).any())
    return;
  const double below = ceiling_.heightAt(p) - point.z();
  if (!(below >= Counts::highest && binOf(below) < Counts::bins))
    return;
  const double s = element_.project(p);
  const double margin = std::min(priors_.wall_band, element_.length() / 4);
  if (s < margin || s > element_.length() - margin)
    return;
  const double before = element_.normalAt(s).dot(p - element_.pointAt(s));
  if (std::abs(before) <= priors_.wall_band)
    ++counts.face[binOf(below)];
  else if (before >= 2 * priors_.min_wall && before <= farthestBefore() &&
           below < -Counts::highest)
    ++counts.ceiling[binOf(below)];
}

double
SlitFace::lowest() const
{
  double height = std::numeric_limits<double>::infinity();
  for (const double x : {low_.x(), high_.x()})
    for (const double y : {low_.y(), high_.y()})
      height = std::min(height, ceiling_.heightAt({x, y}));
  return height - Counts::highest - Counts::step * static_cast<double>(Counts::bins);
}

SlitFace::Top
SlitFace::top() const
{
  constexpr double min_expected = 8; // points
  constexpr double sigma = 0.341; // share of points to one sigma above: no lamps there
  // The band that certainly belongs to the face.
  const double body_low = priors_.surface_band;
  const double body_high = priors_.surface_band + priors_.run_gap;
  const double plane = quantileOf(counts_.ceiling, 0.5);
  const double spread = plane - quantileOf(counts_.ceiling, 0.5 - sigma);
  const double noise = std::max(priors_.slab_noise, priors_.sigmas * spread);
  const std::size_t body =
      countBetween(counts_.face, plane + body_low, plane + body_high);
  const double slit = std::max(priors_.min_slit, noise + 2 * Counts::step);
  if (slit > body_low)
    return Top::Unknown;
  // A face that ends within the body has points only in its lower half.
  const std::size_t lower =
      countBetween(counts_.face, plane + (body_low + body_high) / 2, plane + body_high);
  const double bins = static_cast<double>(binOf(plane + slit)) -
                      static_cast<double>(binOf(plane + noise));
  const double expected =
      static_cast<double>(body) * bins * Counts::step / (body_high - body_low);
  if (expected < min_expected)
    return Top::Unknown;
  const std::size_t seen = countBetween(counts_.face, plane + noise, plane + slit);
  if (static_cast<double>(seen) > priors_.share_part * expected)
    return Top::Ceiling;
  const double below =
      expected * 2 * static_cast<double>(lower) / static_cast<double>(body);
  return chanceOf(seen, std::max(expected, below)) <= priors_.chance ? Top::Slit
                                                                     : Top::Unknown;
}

namespace {

/** @brief Finds the faces near a position; all if they are too far apart for a table.
 */
class FacesNear {
public:
  explicit FacesNear(const std::vector<SlitFace*>& faces)
      : table_(0.5) // metres; the size is not critical
      , all_(faces.size())
  {
    std::iota(all_.begin(), all_.end(), 0u);
    std::vector<CellTable::Entry> entries;
    for (const std::uint32_t f : all_)
      entries.push_back({table_.boxAround(faces[f]->low(), faces[f]->high()), f});
    is_table_filled_ = table_.fill(entries).empty();
  }

  CellTable::Numbers at(const Eigen::Vector2d& place) const
  {
    if (!is_table_filled_)
      return {all_.data(), all_.data() + all_.size()};
    return table_.at(place);
  }

private:
  CellTable table_;
  std::vector<std::uint32_t> all_;
  bool is_table_filled_ = false;
};

} // namespace

void
countAtFaces(const std::vector<SlitFace*>& faces,
             const PointView& raw,
             const std::vector<int>& indices,
             unsigned threads)
{
  const std::size_t all = indices.empty() ? raw.size() : indices.size();
  const std::size_t step = rawStep(all, max_face_points);
  double lowest = std::numeric_limits<double>::infinity();
  for (const SlitFace* face : faces)
    lowest = std::min(lowest, face->lowest());
  const FacesNear near(faces);
  std::mutex adding;
  parallelBlocks(
      all / step, points_a_block, threads, [&](std::size_t begin, std::size_t end) {
        std::vector<SlitFace::Counts> counts(faces.size());
        for (std::size_t k = begin; k < end; ++k) {
          const std::size_t i = k * step;
          const Eigen::Vector3f p =
              raw[indices.empty() ? i : static_cast<std::size_t>(indices[i])];
          if (!(p.z() >= lowest) || !std::isfinite(p.z()))
            continue;
          for (const std::uint32_t f : near.at(p.head<2>().cast<double>()))
            faces[f]->count(p, counts[f]);
        }
        const std::lock_guard<std::mutex> lock(adding);
        for (std::size_t f = 0; f < faces.size(); ++f)
          faces[f]->add(counts[f]);
      });
}

} // namespace pcl::sedr
