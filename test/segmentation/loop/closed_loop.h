// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <gtest/gtest.h>

#include <cstddef>

namespace sedr_test {

/** @brief Expects that every element starts where the previous one ends. */
inline void
expectClosed(const pcl::sedr::PlanLoop& loop)
{
  const std::size_t n = loop.elements.size();
  for (std::size_t i = 0; i < n; ++i)
    EXPECT_LT((loop.elements[i].end - loop.elements[(i + 1) % n].start).norm(), 1e-12);
}

} // namespace sedr_test
