// SPDX-License-Identifier: BSD-3-Clause
#include "sheet.h"

namespace pcl::sedr {

void
Sheet::addLine(const std::string& look,
               const std::vector<Eigen::Vector2d>& places,
               bool is_closed)
{
  PlanLoop chain;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    PlanElement e;
    e.start = places[i];
    e.end = places[i + 1];
    chain.elements.push_back(e);
  }
  add(SheetPath{look, {chain}, is_closed});
}

} // namespace pcl::sedr
