// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"
#include "plain_text.h"
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

TEST(ToolOptions, ReadNumbersTextsFlagsAndFilesAnywhere)
{
  SampleOptions sample;
  ASSERT_TRUE(sample.parse({"--leaf", "0.1", "in.pcd", "--steps=-4", "--height", "-1.5",
                            "--mode", "manual", "--fast"}));
  EXPECT_EQ(sample.input, "in.pcd");
  EXPECT_EQ(sample.leaf, 0.1f);
  EXPECT_EQ(sample.threads, 0u);
  EXPECT_EQ(sample.steps, -4);
  EXPECT_EQ(sample.height, -1.5);
  EXPECT_EQ(sample.mode, "manual");
  EXPECT_TRUE(sample.fast);
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

TEST(ToolOptions, MayBeginWithOneDash)
{
  SampleOptions sample;
  ASSERT_TRUE(sample.parse(
      {"-leaf", "0.1", "in.pcd", "-steps=-4", "-height", "-1.5", "-fast"}));
  EXPECT_EQ(sample.leaf, 0.1f);
  EXPECT_EQ(sample.steps, -4);
  EXPECT_EQ(sample.height, -1.5);
  EXPECT_TRUE(sample.fast);
  EXPECT_FALSE(SampleOptions().parse({"-h"}));
  EXPECT_FALSE(SampleOptions().parse({"-help"}));
  EXPECT_NE(SampleOptions().refusal({"in.pcd", "-slow"}), "");
}

TEST(ToolOptions, HelpShowsUnitsRangesAndTheDefaultsOfTheVariables)
{
  SampleOptions sample;
  EXPECT_FALSE(sample.parse({"-h"}));
  EXPECT_FALSE(sample.parse({"--version"}));
  EXPECT_EQ(sample.options.answer().rfind("pcl_sample (SEDR) ", 0), 0u);
  EXPECT_FALSE(sample.parse({"--help", "--leaf", "nonsense"}));
  const std::string help = sample.options.answer();
  EXPECT_NE(help.find("edge of a voxel [m] (above 0; default 0.05)"), std::string::npos)
      << help;
  EXPECT_NE(help.find("(from -5 to 5; default 3)"), std::string::npos) << help;
  EXPECT_NE(help.find("(default measured)"), std::string::npos) << help;
  EXPECT_NE(help.find("pcl_sample INPUT [options]"), std::string::npos) << help;
}

TEST(ToolOptions, RefuseEachMistakeWithASentenceThatNamesIt)
{
  SampleOptions sample;
  EXPECT_NE(sample.refusal({}).find("INPUT is missing"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "b"}).find("'b'"), std::string::npos);
  EXPECT_NE(
      sample.refusal({"a", "--leaf", "0"}).find("--leaf must be above 0 m, not 0"),
      std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--leaf", "-1"}).find("not -1"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--leaf", "nan"}).find("'nan'"), std::string::npos);
  EXPECT_EQ(sample.refusal({"a", "--title",
                            "K\xc3\xbc"
                            "che"}),
            "");
  EXPECT_EQ(SampleOptions().refusal({"a", "--title", "K\xfc"}),
            "--title takes printable text in UTF-8, not 'K\\xfc'");
  EXPECT_NE(sample.refusal({"a", "--leaf", "1cm"}).find("'1cm'"), std::string::npos);
  for (const std::vector<const char*>& wrong :
       {std::vector<const char*>{"a", "--leaf"}, {"a", "--leaf", "1", "--leaf", "2"}})
    EXPECT_NE(sample.refusal(wrong).find("--leaf"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--threads", "-1"}).find("-1"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--threads", "1.5"}).find("whole number"),
            std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--threads", "99999999999"}), "");
  EXPECT_NE(sample.refusal({"a", "--steps", "6"}).find("from -5 to 5"),
            std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--mode", "soon"}).find("auto, manual"),
            std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--lea", "1"}).find("--lea"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--fast=yes"}), "");
}

} // namespace
