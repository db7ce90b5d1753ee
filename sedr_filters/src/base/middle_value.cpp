// SPDX-License-Identifier: BSD-3-Clause
#include "middle_value.h"

#include <algorithm>

namespace pcl::sedr {

double
middleValue(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace pcl::sedr
