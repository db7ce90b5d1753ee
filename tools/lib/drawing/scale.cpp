// SPDX-License-Identifier: BSD-3-Clause
#include "scale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pcl::sedr::tools {

double
roundStep(double most)
{
  const double power = std::pow(10, std::floor(std::log10(most) + 1e-9));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= most * (1 + 1e-9))
      return factor * power;
  return power;
}

int
digitsOf(double step)
{
  return std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
}

std::string
fixedText(double value, int digits)
{
  const double unit = std::pow(10, -digits);
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits,
                std::abs(value) < unit / 2 ? 0.0 : value);
  return text;
}

std::string
lengthText(double metres)
{
  const bool is_fine = metres < 0.00999;
  const bool is_short = metres < 0.999;
  const double value = is_fine ? 1000 * metres : is_short ? 100 * metres : metres;
  return fixedText(value, digitsOf(std::max(value, 1e-9))) + (is_fine    ? " mm"
                                                              : is_short ? " cm"
                                                                         : " m");
}

} // namespace pcl::sedr::tools
