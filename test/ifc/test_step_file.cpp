// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_surface/src/ifc/step_file.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using namespace pcl::sedr::ifc;

TEST(StepText, QuotesAndBackslashesAreDoubled)
{
  EXPECT_EQ(stepText("room 1"), "'room 1'");
  EXPECT_EQ(stepText("it's"), "'it''s'");
  EXPECT_EQ(stepText("a\\b"), "'a\\\\b'");
  EXPECT_EQ(stepText(""), "''");
}

TEST(StepText, LettersBeyondAsciiAreEscaped)
{
  EXPECT_EQ(stepText("K\xc3\xbc"
                     "che"),
            "'K\\X2\\00FC\\X0\\che'");
  EXPECT_EQ(stepText("\xe2\x82\xac"), "'\\X2\\20AC\\X0\\'");
  EXPECT_EQ(stepText("\xf0\x9f\x8f\xa0"), "'\\X4\\0001F3E0\\X0\\'");
  EXPECT_EQ(stepText("a\nb"), "'a\\X2\\000A\\X0\\b'");
}

TEST(StepText, WhatIsNoUtf8IsAQuestionMark)
{
  EXPECT_EQ(stepText("\xfc"), "'?'");
  EXPECT_EQ(stepText("a\xc3"), "'a?'");
  EXPECT_EQ(stepText("\xc3("), "'?('");
}

TEST(StepReal, HasAPoint)
{
  EXPECT_EQ(stepReal(0), "0.");
  EXPECT_EQ(stepReal(-0.0), "0.");
  EXPECT_EQ(stepReal(12), "12.");
  EXPECT_EQ(stepReal(-0.25), "-0.25");
  EXPECT_EQ(stepReal(5335900.125), "5335900.125");
  EXPECT_EQ(stepReal(1e-12), "0.");
}

TEST(StepFile, InstancesAreCountedFromOne)
{
  StepFile file;
  const StepRef a = file.add("IFCDIRECTION", {std::vector<double>{0, 0, 1}});
  const StepRef b = file.add("IFCX", {a, StepValue::none(), StepValue::derived(), "n",
                                      StepValue::enumerated("AREA"), 2.5,
                                      std::vector<StepRef>{a, a}, StepRef{}});
  EXPECT_EQ(a.id, 1u);
  EXPECT_EQ(b.id, 2u);
  const std::string text = file.text("view", "m.ifc", "IFC4");
  EXPECT_NE(text.find("\n#1=IFCDIRECTION((0.,0.,1.));\n"), std::string::npos);
  EXPECT_NE(text.find("\n#2=IFCX(#1,$,*,'n',.AREA.,2.5,(#1,#1),$);\n"),
            std::string::npos);
  EXPECT_NE(text.find("FILE_SCHEMA(('IFC4'));"), std::string::npos);
}

} // namespace
