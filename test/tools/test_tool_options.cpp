// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"
#include "says.h"
#include "tool_error.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using namespace pcl::sedr::tools;

/** The options of a tool for tests. */
struct SampleOptions {
  std::string input;
  float leaf = 0.05f;
  unsigned int threads = 0;
  int steps = 3;
  std::optional<double> height;
  std::string mode = "auto";
  std::string title;
  std::string day;
  bool fast = false;
  Options options{"pcl_sample", "Does something."};

  SampleOptions()
  {
    options.file("INPUT", input, "cloud");
    options.number("leaf", leaf, "m", "edge of a voxel", Range::above(0));
    options.number("threads", threads, "", "threads");
    options.number("steps", steps, "", "steps", Range::between(-5, 5));
    options.optionalNumber("height", height, "m", "height", "measured");
    options.text("mode", mode, "mode", {"auto", "manual"});
    options.words("title", title, "on the sheet");
    options.date("day", day, "of the survey");
    options.flag("fast", fast, "in haste");
  }

  bool parse(std::vector<const char*> arguments)
  {
    arguments.insert(arguments.begin(), "pcl_sample");
    return options.parse(static_cast<int>(arguments.size()), arguments.data());
  }

  /** Returns the error sentence. */
  std::string refusal(const std::vector<const char*>& arguments)
  {
    try {
      parse(arguments);
      return "";
    }
    catch (const ToolError& error) {
      EXPECT_EQ(error.exitCode(), BadUse);
      return error.what();
    }
  }
};

TEST(ToolOptions, AreReadAnywhereAfterOneDashOrTwo)
{
  for (const bool is_short : {false, true}) {
    SampleOptions sample;
    std::vector<const char*> arguments{"--leaf",     "0.1",      "in.pcd",
                                       "--steps=-4", "--height", "-1.5",
                                       "--mode",     "manual",   "--fast"};
    for (const char*& argument : arguments)
      argument += is_short && argument[1] == '-' ? 1 : 0;
    ASSERT_TRUE(sample.parse(arguments));
    EXPECT_EQ(sample.input, "in.pcd");
    EXPECT_EQ(sample.leaf, 0.1f);
    EXPECT_EQ(sample.threads, 0u);
    EXPECT_EQ(sample.steps, -4);
    EXPECT_EQ(sample.height, -1.5);
    EXPECT_EQ(sample.mode, "manual");
    EXPECT_TRUE(sample.fast);
  }
}

TEST(ToolOptions, AnswerWithHelpOrVersion)
{
  for (const char* asked : {"-h", "-help", "--help"}) {
    SampleOptions sample;
    EXPECT_FALSE(sample.parse({asked, "--leaf", "nonsense"}));
    EXPECT_TRUE(says(sample.options.answer(),
                     "edge of a voxel [m] (above 0; default 0.05)",
                     "(from -5 to 5; default 3)", "(default measured)",
                     "pcl_sample INPUT [options]"));
  }
  SampleOptions sample;
  EXPECT_FALSE(sample.parse({"--version"}));
  EXPECT_EQ(sample.options.answer().rfind("pcl_sample (SEDR) ", 0), 0u);
}

TEST(PlainText, EscapesWhatCannotBePrintedAndCutsWhatIsLong)
{
  EXPECT_EQ(plainText("K\xc3\xbc"
                      "che 1"),
            "K\xc3\xbc"
            "che 1");
  EXPECT_EQ(plainText("a\n\x1b[2J\x7f"), "a\\x0a\\x1b[2J\\x7f");
  EXPECT_EQ(plainText("\xc3"), "\\xc3");                   // cut off
  EXPECT_EQ(plainText("\xc0\xaf"), "\\xc0\\xaf");          // overlong
  EXPECT_EQ(plainText("\xe2\x80\xae"), "\\xe2\\x80\\xae"); // turns the direction
  EXPECT_EQ(plainText("\xed\xa0\x80"), "\\xed\\xa0\\x80"); // half a character
  EXPECT_EQ(plainText(std::string_view("\0", 1)), "\\x00");
  EXPECT_EQ(plainText("abcdef", 3), "abc...");
  EXPECT_EQ(quotedWord(std::string(100, 'a')), "'" + std::string(40, 'a') + "...'");
}

TEST(ToolOptions, RefuseEachMistakeWithASentenceThatNamesIt)
{
  for (const auto& [arguments, told] :
       std::vector<std::pair<std::vector<const char*>, std::string>>{
           {{}, "INPUT is missing"},
           {{"a", "b"}, "'b'"},
           {{"a", "--leaf", "0"}, "--leaf must be above 0 m, not 0"},
           {{"a", "--leaf", "-1"}, "not -1"},
           {{"a", "--leaf", "nan"}, "'nan'"},
           {{"a", "--leaf", "1cm"}, "'1cm'"},
           {{"a", "--leaf"}, "--leaf"},
           {{"a", "--leaf", "1", "--leaf", "2"}, "--leaf"},
           {{"a", "--title", "K\xfc"},
            "--title takes printable text in UTF-8, not 'K\\xfc'"},
           {{"a", "--day", "2024-5-31"}, "a day such as 2024-05-31"},
           {{"a", "--threads", "-1"}, "-1"},
           {{"a", "--threads", "1.5"}, "whole number"},
           {{"a", "--threads", "99999999999"}, "--threads"},
           {{"a", "--steps", "6"}, "from -5 to 5"},
           {{"a", "--mode", "soon"}, "auto, manual"},
           {{"a", "--lea", "1"}, "--lea"},
           {{"a", "-slow"}, "-slow"},
           {{"a", "--fast=yes"}, "--fast"}}) {
    const std::string refusal = SampleOptions().refusal(arguments);
    EXPECT_TRUE(says(refusal, told));
  }
  EXPECT_EQ(SampleOptions().refusal({"a", "--title", "K\xc3\xbc"}), "");
}

} // namespace
