// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_surface/src/ifc/ifc_guid.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace {

using pcl::sedr::ifc::guidOf;
using pcl::sedr::ifc::guidText;

TEST(IfcGuid, IsWrittenInBase64OfItsOwn)
{
  unsigned char zeros[16] = {};
  EXPECT_EQ(guidText(zeros), std::string(22, '0'));
  unsigned char ones[16];
  std::fill(std::begin(ones), std::end(ones), static_cast<unsigned char>(255));
  EXPECT_EQ(guidText(ones), "3" + std::string(21, '$'));
  unsigned char last[16] = {};
  last[15] = 10;
  EXPECT_EQ(guidText(last), std::string(21, '0') + "A");
}

TEST(IfcGuid, TheSameNameHasTheSameOneAndOthersAnother)
{
  EXPECT_EQ(guidOf("a/room_1"), guidOf("a/room_1"));
  std::set<std::string> guids;
  for (int i = 0; i < 1000; ++i)
    guids.insert(guidOf("a/room_" + std::to_string(i)));
  EXPECT_EQ(guids.size(), 1000u);
  for (const std::string& guid : guids) {
    EXPECT_EQ(guid.size(), 22u);
    EXPECT_LE(guid[0], '3') << "the first letter stands for two bits";
  }
}

} // namespace
