// SPDX-License-Identifier: BSD-3-Clause
#include "storey_samples.h"

#include <numeric>

namespace pcl::sedr {

namespace {

/** @brief Returns the numbers of places in the order of PlanPoints. */
std::vector<std::uint32_t>
inOrder(const std::vector<Eigen::Vector2d>& places)
{
  const CellGrid grid(NumberedPlaces::step);
  std::vector<std::uint32_t> numbers(places.size());
  std::iota(numbers.begin(), numbers.end(), std::uint32_t{0});
  std::stable_sort(numbers.begin(), numbers.end(),
                   [&](std::uint32_t a, std::uint32_t b) {
                     return keyOf(grid.at(places[a].x(), places[a].y())) <
                            keyOf(grid.at(places[b].x(), places[b].y()));
                   });
  return numbers;
}

/** @brief Returns a place of each sample of some contours. */
template <typename PlaceOf>
std::vector<Eigen::Vector2d>
placesOf(const std::vector<LoopContour>& contours, PlaceOf placeOf)
{
  std::vector<Eigen::Vector2d> places;
  for (const LoopContour& contour : contours)
    for (const LoopSample& sample : contour.samples)
      places.push_back(placeOf(sample));
  return places;
}

} // namespace

NumberedPlaces::NumberedPlaces(const std::vector<Eigen::Vector2d>& places)
    : points_(places, step)
    , numbers_(inOrder(places))
{}

StoreySamples::StoreySamples(const std::vector<LoopContour>& contours)
    : places_(placesOf(contours, [](const LoopSample& s) { return s.place; }))
    , anchors_(placesOf(contours, [](const LoopSample& s) { return s.anchor; }))
{
  const AreaTable table;
  for (const LoopContour& contour : contours) {
    contour_.resize(samples_.size() + contour.samples.size(), first_.size());
    first_.push_back(samples_.size());
    for (std::size_t i = 0; i < contour.samples.size(); ++i) {
      samples_.push_back(&contour.samples[i]);
      areas_.push_back(contour.area.data() +
                       i * static_cast<std::size_t>(table.columns()));
    }
  }
}

} // namespace pcl::sedr
