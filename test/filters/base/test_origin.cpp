// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/scan_frame.h>

#include <gtest/gtest.h>

#include <string>

namespace {

using pcl::sedr::Origin;

TEST(Origin, TextAndCommentReadBack)
{
  const Origin origin{{691600, -5335900.125, 0.000001}};
  EXPECT_EQ(origin.text(", "), "691600, -5335900.125, 0.000001");
  EXPECT_EQ(Origin{}.text(), "0 0 0");
  for (const std::string before : {"", "# ", "comment "}) {
    Origin read;
    ASSERT_TRUE(Origin::fromComment(before + origin.comment(), read));
    EXPECT_EQ(read, origin);
  }
}

TEST(Origin, WhatIsNoOriginIsNotRead)
{
  Origin origin{{1, 2, 3}};
  for (const char* text :
       {"", "1 2", "1 2 3 4", "1 2 x", "1 2 nan", "1 2 inf", "1;2;3"})
    EXPECT_FALSE(Origin::fromText(text, origin)) << text;
  EXPECT_FALSE(Origin::fromComment("# origin 1 2 3", origin));
  EXPECT_EQ(origin, (Origin{{1, 2, 3}}));
  EXPECT_TRUE(Origin::fromText(" 4,5, 6 \r", origin));
  EXPECT_EQ(origin, (Origin{{4, 5, 6}}));
}

TEST(Origin, LocalPlacesGoThereAndBackExactly)
{
  const Origin origin{{691600, 5335900, 0}};
  const Eigen::Vector3d p(691612.25, 5335907.5, 1.25);
  EXPECT_EQ(origin.toLocal(p), Eigen::Vector3d(12.25, 7.5, 1.25));
  EXPECT_EQ(origin.toGiven(origin.toLocal(p)), p);
  EXPECT_TRUE(Origin{}.isZero());
  EXPECT_FALSE(origin.isZero());
}

} // namespace
