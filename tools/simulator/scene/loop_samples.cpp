// SPDX-License-Identifier: BSD-3-Clause
#include "loop_samples.h"

namespace pcl::sedr::sim {

std::vector<double>
stepsAlong(const Element& element)
{
  constexpr double spacing = 0.05;
  const double size = lengthOf(element);
  const auto count = static_cast<std::size_t>(std::ceil(size / spacing));
  std::vector<double> steps;
  for (std::size_t i = 0; i <= count; ++i)
    steps.push_back(size * static_cast<double>(i) / static_cast<double>(count));
  return steps;
}

std::vector<Vec2>
samplesAlong(const Loop& loop, double inwards)
{
  std::vector<Vec2> samples;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Element element = elementOf(loop, i);
    for (const double s : stepsAlong(element))
      samples.push_back(pointAt(element, s) - inwards * rightNormalAt(element, s));
  }
  return samples;
}

} // namespace pcl::sedr::sim
