// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/number_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

using pcl::sedr::numberText;

TEST(NumberText, HasSixDigitsWhateverItsSize)
{
  EXPECT_EQ(numberText(0.15), "0.15");
  EXPECT_EQ(numberText(3), "3");
  EXPECT_EQ(numberText(-0.0498913), "-0.0498913");
  EXPECT_EQ(numberText(1.0 / 3), "0.333333");
  EXPECT_EQ(numberText(1e-300), "1e-300");
  EXPECT_EQ(numberText(1e300), "1e+300");
  EXPECT_EQ(numberText(std::numeric_limits<double>::infinity()), "inf");
}

} // namespace
