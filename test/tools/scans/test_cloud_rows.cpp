// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_rows.h"
#include "tool_error.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"
#include "bytes/whole_file.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr::tools;
using programs::bytesOf;
using programs::manyFields;
using programs::TemporaryFolder;
using programs::writeFile;
using Field = pcl::PCLPointField;

TEST(CloudRows, RowsAreSelectedAppendedAndMovedWithAllFields)
{
  auto blob = manyFields();
  auto selected = selectRows(blob, {2, 0});
  appendRows(selected, blob, {1, 1});
  setCoordinates(selected, 3, {{7, 8, 9}});
  ASSERT_EQ(rowsOf(selected), 4u);
  EXPECT_EQ(floatField(selected, "ring"), (std::vector<float>{52, 50, 51, 51}));
  EXPECT_EQ(floatField(selected, "y"), (std::vector<float>{22.25f, 20.25f, 21.25f, 8}));
  appendRows(selected, selected, {0});
  EXPECT_EQ(floatField(selected, "ring"), (std::vector<float>{52, 50, 51, 51, 52}));
}

TEST(CloudRows, FieldsAreSetAddedAndPutInPlaceOfOtherTypes)
{
  auto blob = manyFields();
  setField(blob, "label", std::vector<std::uint32_t>{1, 2, 100000});
  setField(blob, "room", std::vector<std::uint32_t>{4, 5, 6});
  setField(blob, "normal_x", std::vector<float>{0.5f, 0.6f, 0.7f});
  EXPECT_EQ(findField(blob, "label")->datatype, Field::UINT32);
  EXPECT_EQ(wholeField(blob, "label"), (std::vector<std::uint32_t>{1, 2, 100000}));
  EXPECT_EQ(wholeField(blob, "room"), (std::vector<std::uint32_t>{4, 5, 6}));
  EXPECT_EQ(floatField(blob, "normal_x"), (std::vector<float>{0.5f, 0.6f, 0.7f}));
  EXPECT_EQ(floatField(blob, "flag"), (std::vector<float>{60, 61, 62}));
  EXPECT_TRUE(wholeField(blob, "nothing").empty());
  EXPECT_THROW(setField(blob, "room", std::vector<std::uint32_t>{1}), std::logic_error);
}

TEST(WholeFile, IsWrittenWholeOrNotAtAll)
{
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.txt").string();
  writeWhole(path, [](std::ostream& stream) { stream << "old"; });
  EXPECT_THROW(writeWhole(path,
                          [](std::ostream& stream) {
                            stream << "half of the ne";
                            throw ToolError("stopped");
                          }),
               ToolError);
  EXPECT_EQ(bytesOf(path), "old");
  EXPECT_THROW(writeWhole(path, [](std::ostream& s) { s.setstate(std::ios::badbit); }),
               ToolError);
  EXPECT_EQ(bytesOf(path), "old");
  EXPECT_THROW(checkWritable("/dev/null"), ToolError)
      << "a device is not to be replaced";
  EXPECT_THROW(checkWritable(folder.path().string()), ToolError);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(WholeFile, ALinkStaysALink)
{
  const TemporaryFolder folder;
  const auto target = folder.path() / "target.txt";
  const auto link = folder.path() / "link.txt";
  writeFile(target, "old");
  std::filesystem::create_symlink(target, link);
  writeWhole(link.string(), [](std::ostream& stream) { stream << "new"; });
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(bytesOf(target), "new");
}

} // namespace
