// SPDX-License-Identifier: BSD-3-Clause
#include "scan_file.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "tools/reading_settings.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace pcl::sedr::tools;
using namespace programs;
using programs::TemporaryFolder;
using programs::writeFile;

class TextFiles : public ::testing::Test {
protected:
  ToolCloud load(const std::string& text, const std::string& columns = "")
  {
    writeFile(folder_.path() / "scan.xyz", text);
    ScanSettings settings;
    settings.columns = columns;
    return loadCloud((folder_.path() / "scan.xyz").string(), settings);
  }

  /** Expects the first point. */
  void expectFirst(const ToolCloud& cloud, float x, float y, float z)
  {
    EXPECT_EQ((*cloud.points)[0].x, x);
    EXPECT_EQ((*cloud.points)[0].y, y);
    EXPECT_EQ((*cloud.points)[0].z, z);
  }

  std::string refusal(const std::string& text, const std::string& columns = "")
  {
    try {
      load(text, columns);
    }
    catch (const ToolError& error) {
      return error.what();
    }
    ADD_FAILURE() << "it was read";
    return {};
  }

  TemporaryFolder folder_;
};

TEST_F(TextFiles, ColumnsAreToldByTheFileOrByTheirNumber)
{
  expectFirst(load("1.5 2 3\n4 5 6\n"), 1.5f, 2, 3);
  expectFirst(load("# made by hand\n\n1.5\t2\t-3e0\r\n"), 1.5f, 2, -3);
  expectFirst(load("x,y,z\n1.5,2,3\n"), 1.5f, 2, 3);
  expectFirst(load("1,5;2;3\n"), 1.5f, 2, 3); // a decimal comma
  const ToolCloud named = load("//Intensity Z Y X\n9 3 2 1\n8 3 2 1\n");
  expectFirst(named, 1, 2, 3);
  EXPECT_EQ(floatField(named.blob, "intensity"), (std::vector<float>{9, 8}));
  const ToolCloud pts = load("2\n1 2 3 -100 255 128 0\n4 5 6 -200 1 2 3\n");
  ASSERT_EQ(pts.size(), 2u);
  EXPECT_EQ(floatField(pts.blob, "intensity"), (std::vector<float>{-100, -200}));
  const auto* rgb = &pts.blob.data[findField(pts.blob, "rgb")->offset];
  EXPECT_EQ(rgb[2], 255);
  EXPECT_EQ(rgb[1], 128);
  EXPECT_EQ(rgb[0], 0);
  EXPECT_EQ(findField(load("1 2 3 0.5 0.5 0.7\n").blob, "rgb"), nullptr);
}

TEST_F(TextFiles, NoColumnTakesThePlaceOfAnother)
{
  EXPECT_NE(refusal("1,2,3,4,5\n1,,3,4,5\n").find("point 2 has 1 of 5 numbers"),
            std::string::npos);
  EXPECT_NE(refusal("1\t2\t3\t4\n1\t\t3\t4\n").find("point 2 has 1 of 4 numbers"),
            std::string::npos);
  EXPECT_NE(refusal("1,2,3,a\n1,,3,a\n").find("point 2 has 1 of 3"), std::string::npos);
  std::string late;
  for (int k = 0; k < 150; ++k)
    late += "1;2;3\n";
  EXPECT_NE(refusal(late + "1,5;2;3\n").find("point 151 has more than 3 numbers"),
            std::string::npos);
  EXPECT_NE(refusal("1 2 3 4\n1 2 3\n").find("point 2 has 3 of 4"), std::string::npos);
  expectFirst(load("1;2;3; \n4;5;6;\n"), 1, 2, 3);
  expectFirst(load("1, 2 ,\t3,,\n4, 5, 6,\n"), 1, 2, 3);
  expectFirst(load("1 2 3 a door\n4 5 6 wall\n"), 1, 2, 3);
}

TEST_F(TextFiles, QuotesEncloseWholeCells)
{
  expectFirst(load("\"1\",\"2.5\",\"3\"\n"), 1, 2.5f, 3);
  expectFirst(load("\"1,5\";\"2\";\"3\"\n"), 1.5f, 2, 3);
  refusal("\"691,600.5\",\"5,336,000.2\",\"3.1\"\n");
  refusal("\"1\"2 3 4\n");
  refusal("\"1 2 3\n");
}

TEST_F(TextFiles, NumbersBeyondThoseOfDoublesAreNoPlaces)
{
  const ToolCloud cloud = load("1e400 2 3\n1e-400 2 3\n");
  EXPECT_FALSE(std::isfinite((*cloud.points)[0].x));
  EXPECT_EQ((*cloud.points)[1].x, 0);
}

TEST_F(TextFiles, DecimalCommasAreFoundThoughTheFirstNumbersAreWhole)
{
  const ToolCloud semicolons = load("1;2;3\n-0,5;0,25;3,5\n");
  expectFirst(semicolons, 1, 2, 3);
  EXPECT_EQ((*semicolons.points)[1].x, -0.5f);
  EXPECT_EQ((*semicolons.points)[1].z, 3.5f);
  const ToolCloud blanks = load("1 2,5 3,25\n4 5 6\n");
  expectFirst(blanks, 1, 2.5f, 3.25f);
  ASSERT_EQ(blanks.size(), 2u);
  expectFirst(load("1,2,3\n4,5,6\n"), 1, 2, 3); // commas between columns
}

TEST_F(TextFiles, NumbersMayStandInQuotes)
{
  expectFirst(load("\"X\",\"Y\",\"Z\"\n\"1.5\",\"2\",\"3\"\n"), 1.5f, 2, 3);
  expectFirst(load("\"1,5\";\"2\";\"3,25\"\n"), 1.5f, 2, 3.25f);
  // Both commas at once are refused rather than taken for columns.
  EXPECT_NE(refusal("\"1,5\",\"2,5\",\"3,5\"\n").find("neither"), std::string::npos);
}

TEST_F(TextFiles, TheMarkBeforeUtf8IsNoPartOfThePoints)
{
  const ToolCloud cloud = load("\xEF\xBB\xBF"
                               "1 2 3\n4 5 6\n");
  ASSERT_EQ(cloud.size(), 2u);
  expectFirst(cloud, 1, 2, 3);
  expectFirst(load("\xEF\xBB\xBF"
                   "North East Elev\n2 1 3\n"),
              1, 2, 3);
}

TEST_F(TextFiles, ColumnsThatAreAskedForAreTaken)
{
  const ToolCloud cloud = load("7 30 20 10\n7 31 21 11\n", "_ z y x");
  expectFirst(cloud, 10, 20, 30);
  EXPECT_EQ(cloud.blob.fields.size(), 3u);
  EXPECT_NE(refusal("1 2 3\n", "x y").find("do not hold each of x, y and z"),
            std::string::npos);
  EXPECT_NE(refusal("1 2 3\n", "x,y,z,intensity").find("has 3 of the 4 columns"),
            std::string::npos);
}

TEST_F(TextFiles, ABrokenLineIsNamed)
{
  EXPECT_NE(refusal("1 2 3\n4 5\n").find("point 2 has 2 of 3 numbers"),
            std::string::npos);
  EXPECT_NE(refusal("1 2 3\n4 5 six\n").find("point 2 has 2 of 3"), std::string::npos);
  EXPECT_NE(refusal("no numbers at all\n").find("neither"), std::string::npos);
  EXPECT_NE(refusal(std::string("1 2 3\0\n", 7)).find("neither"), std::string::npos);
}

TEST_F(TextFiles, DigitsOfAGridAreNotLost)
{
  const ToolCloud cloud =
      load("691600.125 5335900.25 512\n691600.125 5335902.75 515\n");
  EXPECT_EQ(cloud.origin.place.x(), 691600);
  EXPECT_EQ((*cloud.points)[0].x, 0.125f);
  EXPECT_EQ((*cloud.points)[1].y - (*cloud.points)[0].y, 2.5f);
  EXPECT_EQ((*cloud.points)[1].z, 515.f);
}

TEST_F(TextFiles, PiecesAreThoseOfTheWhole)
{
  std::mt19937 random(3);
  const std::size_t n = 30000; // several remembered lines
  std::string lines;
  std::size_t number = 0;
  for (std::size_t i = 0; i < n; ++i) {
    lines += std::to_string(number++ % 900) + " 1.25 " + std::to_string(random() % 9) +
             (i % 7 == 0 ? "\n\n# a comment\n" : "\n");
  }
  const ToolCloud whole = load(lines);
  ASSERT_EQ(whole.size(), n);
  for (std::size_t i = 0; i < n; ++i)
    ASSERT_EQ((*whole.points)[i].x, static_cast<float>(i % 900));
  const ScanFile pieces((folder_.path() / "scan.xyz").string(), inPieces(5000));
  std::vector<std::uint8_t> rows;
  pieces.forEachPiece(12345, 23456, [&](const pcl::sedr::RowSource::Piece& piece) {
    rows.insert(rows.end(), piece.rows, piece.rows + piece.size * pieces.rowSize());
    return true;
  });
  EXPECT_TRUE(std::equal(rows.begin(), rows.end(),
                         whole.blob.data.begin() +
                             static_cast<std::ptrdiff_t>(12345 * pieces.rowSize())));
}

TEST_F(TextFiles, TheCommaOfNumbersPartedByBlanksIsTheirDecimalSign)
{
  for (const char* const text :
       {"1,5 -2,25 3,125\n4,5 5,5 6,5\n", "1,5\t-2,25\t3,125\t17\n4,5\t5\t6,5\t8\n"})
    expectFirst(load(text), 1.5F, -2.25F, 3.125F);
  // In other positions it separates columns.
  expectFirst(load("1,2, 3\n4,5, 6\n"), 1, 2, 3);
  expectFirst(load("1,2,3 255\n4,5,6 255\n"), 1, 2, 3);
}

TEST_F(TextFiles, NamesOfOtherProgramsAndTheirUnitsAreKnown)
{
  for (const char* const text :
       {"Z [m], X [m], Y [m]\n3,1,2\n", "\"Z(m)\";\"X(m)\";\"Y(m)\"\n3;1;2\n",
        "h,e,n\n3,1,2\n", "H\xc3\xb6he;Rechtswert;Hochwert\n3;1;2\n",
        "# z x y\n# by hand\n\n3 1 2\n", "Points:2,Points:0,Points:1\n3,1,2\n"})
    expectFirst(load(text), 1, 2, 3);
  const ToolCloud named = load("PointNo;East;North;Elev;Scalar field\n7;1;2;3;9\n");
  expectFirst(named, 1, 2, 3);
  EXPECT_EQ(floatField(named.blob, "scalar_field"), (std::vector<float>{9}));
}

TEST_F(TextFiles, NamesThatAreNotKnownAreRefusedNotTakenForXyz)
{
  for (const char* const text :
       {"a,b,c\n1,2,3\n", "Lat Lon Alt\n1 2 3\n", "//Lat Lon H\n1 2 3\n",
        "id x y z\n1 2 3\n", "# east;middle;up\n1;2;3\n"}) {
    const std::string reason = refusal(text);
    EXPECT_NE(reason.find("--columns"), std::string::npos) << text << reason;
    EXPECT_LT(reason.size(), 300u);
  }
  const std::string reason = refusal(std::string(9999, 'a') + "\n1 2 3\n");
  EXPECT_NE(reason, "");
  EXPECT_LT(reason.size(), 300u);
  expectFirst(load("a,b,c\n1,2,3\n", "x,y,z"), 1, 2, 3);
  expectFirst(load("# exported by hand\n1 2 3\n"), 1, 2, 3);
}

TEST_F(TextFiles, CommentsBeforeTheNumbersMayBeMany)
{
  std::string comments;
  for (int k = 0; k < 1000; ++k)
    comments += "# line " + std::to_string(k) + "\n\n";
  expectFirst(load(comments + "1 2 3\n"), 1, 2, 3);
}

TEST_F(TextFiles, LinesEndWithAnySign)
{
  for (const char* const text : {"1 2 3\r4 5 6\r7 8 9", "1 2 3\r\n4 5 6\r\n7 8 9\r\n",
                                 "1 2 3\r4 5 6\n7 8 9\r\n"}) {
    const ToolCloud cloud = load(text);
    ASSERT_EQ(cloud.size(), 3u) << text;
    expectFirst(cloud, 1, 2, 3);
    EXPECT_EQ((*cloud.points)[2].z, 9.F);
  }
}

TEST_F(TextFiles, CountsOfPointsAreThoseOfTheLinesThatFollow)
{
  const std::string points = "1 2 3 0.5\n4 5 6 0.5\n";
  EXPECT_NE(refusal("3\n" + points).find("3 points are promised before point 1, but 2"),
            std::string::npos);
  EXPECT_NE(refusal("1\n" + points).find("1 points are promised before point 1, but 2"),
            std::string::npos);
  EXPECT_NE(refusal("-2\n" + points).find("'-2'"), std::string::npos);
  // Several scans in one file, each with its count.
  const ToolCloud two = load("2\n" + points + "1\n7 8 9 0.5\n");
  ASSERT_EQ(two.size(), 3u);
  EXPECT_EQ((*two.points)[2].x, 7.F);
  EXPECT_NE(refusal("2\n" + points + "2\n7 8 9 0.5\n")
                .find("2 points are promised before point 3, but 1 follow"),
            std::string::npos);
}

TEST_F(TextFiles, PtxIsRefusedByName)
{
  const std::string head = "2\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                           "1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n";
  EXPECT_NE(refusal(head + "1 2 3 0.5\n1 2 4 0.5\n").find("is PTX"), std::string::npos);
  // A line with only the number of points, as in PTS, is no point.
  expectFirst(load("2\n1 2 3 0.5\n1 2 4 0.5\n"), 1, 2, 3);
}

} // namespace
