// SPDX-License-Identifier: BSD-3-Clause
#include "storey_samples.h"

namespace pcl::sedr {

namespace {

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
