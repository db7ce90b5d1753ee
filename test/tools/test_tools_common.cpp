// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"
#include "whole_file.h"

#include <pcl/sedr_filters/field_access.h>

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace pcl::sedr::tools;
using programs::bytesOf;
using programs::TemporaryFolder;
using programs::writeFile;
using Field = pcl::PCLPointField;

class CloudFiles : public ::testing::Test {
protected:
  std::string
  in(const std::string& name) const
  {
    return (folder_.path() / name).string();
  }

  ToolCloud
  load(const std::string& bytes)
  {
    writeFile(in("cloud"), bytes);
    return loadCloud(in("cloud"));
  }

  /** The sentence with which `bytes` are refused; "" if they are not. */
  std::string
  refusal(const std::string& bytes)
  {
    try {
      load(bytes);
      return "";
    }
    catch (const ToolError& error) {
      EXPECT_EQ(error.exitCode(), BadUse);
      return error.what();
    }
  }

  TemporaryFolder folder_;
};

/** A cloud of three points with fields of many types. */
pcl::PCLPointCloud2
manyFields()
{
  pcl::PCLPointCloud2 blob;
  const std::vector<std::pair<std::string, std::uint8_t>> fields{{"x", Field::FLOAT32},
                                                                 {"intensity", Field::FLOAT64},
                                                                 {"y", Field::FLOAT32},
                                                                 {"z", Field::FLOAT32},
                                                                 {"rgb", Field::FLOAT32},
                                                                 {"ring", Field::UINT16},
                                                                 {"flag", Field::INT8},
                                                                 {"label", Field::INT16},
                                                                 {"normal_x", Field::FLOAT32}};
  for (const auto& [name, type] : fields) {
    Field field;
    field.name = name;
    field.datatype = type;
    field.count = 1;
    field.offset = blob.point_step;
    blob.fields.push_back(field);
    blob.point_step += static_cast<unsigned>(pcl::sedr::fieldSize(type));
  }
  blob.width = 3;
  blob.height = 1;
  blob.row_step = 3 * blob.point_step;
  blob.data.resize(blob.row_step);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t f = 0; f < fields.size(); ++f)
      pcl::sedr::writeField(&blob.data[i * blob.point_step + blob.fields[f].offset],
                            blob.fields[f].datatype,
                            static_cast<double>(10 * f + i) + (f < 4 ? 0.25 : 0));
  return blob;
}

TEST_F(CloudFiles, EveryFieldSurvivesPcdBinaryAndCompressed)
{
  const auto blob = manyFields();
  for (const auto data : {PcdData::Binary, PcdData::Compressed}) {
    saveCloud(in("a.pcd"), blob, data);
    const ToolCloud cloud = loadCloud(in("a.pcd"));
    ASSERT_EQ(cloud.blob.fields.size(), blob.fields.size());
    for (std::size_t f = 0; f < blob.fields.size(); ++f) {
      EXPECT_EQ(cloud.blob.fields[f].name, blob.fields[f].name);
      EXPECT_EQ(cloud.blob.fields[f].datatype, blob.fields[f].datatype);
    }
    EXPECT_EQ(cloud.blob.data, blob.data);
    EXPECT_TRUE(cloud.has_label);
    EXPECT_FALSE(cloud.has_room);
    EXPECT_EQ(cloud.label, (std::vector<std::uint32_t>{70, 71, 72}));
    EXPECT_EQ(cloud.room, (std::vector<std::uint32_t>{0, 0, 0}));
    EXPECT_EQ((*cloud.points)[2].y, 22.25f);
  }
  EXPECT_NE(bytesOf(in("a.pcd")).find("DATA binary_compressed"), std::string::npos);
}

TEST_F(CloudFiles, EveryFieldSurvivesPly)
{
  auto blob = manyFields();
  const std::uint32_t colour = 0xff102030u; // r 16, g 32, b 48
  std::memcpy(&blob.data[findField(blob, "rgb")->offset], &colour, sizeof colour);
  saveCloud(in("a.PLY"), blob);
  const ToolCloud cloud = loadCloud(in("a.PLY"));
  ASSERT_EQ(cloud.blob.fields.size(), blob.fields.size());
  for (const auto& field : blob.fields) {
    const auto* read = findField(cloud.blob, field.name);
    ASSERT_NE(read, nullptr) << field.name;
    EXPECT_EQ(read->datatype, field.datatype);
    if (field.name != "rgb") {
      EXPECT_EQ(floatField(cloud.blob, field.name), floatField(blob, field.name));
    }
  }
  std::uint32_t read_colour = 0;
  std::memcpy(&read_colour, &cloud.blob.data[findField(cloud.blob, "rgb")->offset], 4);
  EXPECT_EQ(read_colour, colour);
}

TEST_F(CloudFiles, AsciiPcdIsReadWithCommentsBlankLinesAndNaN)
{
  const ToolCloud cloud = load("# a comment\nVERSION .7\nFIELDS x y z room\nSIZE 4 8 4 1\n"
                               "TYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\n"
                               "VIEWPOINT 1 2 3 1 0 0 0\nPOINTS 2\nDATA ascii\n"
                               "1.5 -2e1 +3 7\r\n\n nan 5 -inf 9\n");
  EXPECT_EQ((*cloud.points)[0].y, -20.f);
  EXPECT_EQ((*cloud.points)[0].z, 3.f);
  EXPECT_TRUE(std::isnan((*cloud.points)[1].x));
  EXPECT_EQ(cloud.room, (std::vector<std::uint32_t>{7, 9}));
  EXPECT_EQ(cloud.points->sensor_origin_.y(), 2.f);
  EXPECT_EQ(findField(cloud.blob, "y")->datatype, Field::FLOAT32) << "doubles become floats";
}

TEST_F(CloudFiles, PaddingOfBinaryPcdIsLeftOut)
{
  std::string bytes = "VERSION 0.7\nFIELDS x y z _ label\nSIZE 4 4 4 1 4\nTYPE F F F U U\n"
                      "COUNT 1 1 1 4 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA binary\n";
  const float xyz[] = {1, 2, 3};
  const std::uint32_t rest[] = {77, 5};
  bytes.append(reinterpret_cast<const char*>(xyz), sizeof xyz);
  bytes.append(reinterpret_cast<const char*>(rest), sizeof rest);
  const ToolCloud cloud = load(bytes);
  EXPECT_EQ(cloud.blob.fields.size(), 4u);
  EXPECT_EQ(cloud.label, (std::vector<std::uint32_t>{5}));
}

TEST_F(CloudFiles, PlyOfAnyByteOrderIsReadAndFacesAreSkipped)
{
  const std::string rest = "comment made by hand\nelement vertex 2\nproperty double x\n"
                           "property double y\nproperty double z\nproperty uchar red\n"
                           "property uchar green\nproperty uchar blue\nproperty uchar alpha\n"
                           "property float nx\nelement face 1\n"
                           "property list uchar int vertex_indices\nend_header\n";
  const ToolCloud ascii = load("ply\nformat ascii 1.0\n" + rest +
                               "1 2 3 10 20 30 40 0.5\n4 5 6 1 2 3 4 1\n3 0 1 0\n");
  EXPECT_EQ((*ascii.points)[1].x, 4.f);
  EXPECT_EQ(floatField(ascii.blob, "normal_x"), (std::vector<float>{0.5f, 1.f}));
  EXPECT_EQ(wholeField(ascii.blob, "rgba"),
            (std::vector<std::uint32_t>{0x280a141eu, 0x04010203u}));

  std::string swapped = "ply\nformat binary_big_endian 1.0\n" + rest;
  const auto append = [&](auto value) {
    const char* first = reinterpret_cast<const char*>(&value);
    for (std::size_t k = sizeof value; k-- > 0;)
      swapped += first[k];
  };
  for (const double v : {1.0, 2.0, 3.0})
    append(v);
  swapped += "\x0a\x14\x1e\x28";
  append(0.5f);
  for (const double v : {4.0, 5.0, 6.0})
    append(v);
  swapped += "\x01\x02\x03\x04";
  append(1.0f);
  EXPECT_EQ(load(swapped).blob.data, ascii.blob.data);
}

TEST_F(CloudFiles, HeadersThatPromiseTooMuchAreRefusedWithTheNumbers)
{
  const std::string good = programs::pcdBytes({{1, 2, 3}, {4, 5, 6}});
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string bytes = good;
    bytes.replace(bytes.find(from), from.size(), to);
    return bytes;
  };
  EXPECT_EQ(refusal(good), "");
  EXPECT_NE(refusal(good.substr(0, good.size() - 5)).find("promises 2 points"),
            std::string::npos);
  EXPECT_NE(refusal(replaced("WIDTH 2", "WIDTH 3")), "");
  EXPECT_NE(refusal(replaced("WIDTH 2", "WIDTH -2")), "");
  EXPECT_NE(refusal(replaced("POINTS 2", "POINTS 4000000000000")), "");
  EXPECT_NE(refusal(replaced("SIZE 4 4 4", "SIZE 4 4")), "");
  EXPECT_NE(refusal(replaced("SIZE 4 4 4", "SIZE 4 4 3")), "");
  EXPECT_NE(refusal(replaced("COUNT 1 1 1", "COUNT 1 1 0")), "");
  EXPECT_NE(refusal(replaced("COUNT 1 1 1", "COUNT 1 1 999999999")), "");
  EXPECT_NE(refusal(replaced("DATA binary", "DATA morse")), "");
  EXPECT_NE(refusal(replaced("FIELDS x y z", "FIELDS x y w")).find("'z'"), std::string::npos);
  const std::string huge = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2000000000\nDATA ascii\n";
  EXPECT_NE(refusal(huge + "1 2 3\n").find("2000000000"), std::string::npos)
      << "refused before memory is taken";
  EXPECT_NE(refusal("ply\nformat ascii 1.0\nelement vertex 2000000000\nproperty float x\n"
                    "end_header\n1\n")
                .find("2000000000"),
            std::string::npos);
}

/** All files that a good one becomes by cutting it off anywhere, or by changing bytes, are read or
 * refused, never worse. */
TEST_F(CloudFiles, DamagedFilesAreReadOrRefused)
{
  std::vector<std::string> files;
  saveCloud(in("a.pcd"), manyFields());
  files.push_back(bytesOf(in("a.pcd")));
  saveCloud(in("a.pcd"), manyFields(), PcdData::Compressed);
  files.push_back(bytesOf(in("a.pcd")));
  saveCloud(in("a.ply"), manyFields());
  files.push_back(bytesOf(in("a.ply")));
  files.push_back("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nDATA ascii\n"
                  "1 2 3\n4 5 6\n");
  files.push_back("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                  "property float z\nend_header\n1 2 3\n");
  std::mt19937 random(1);
  for (const auto& file : files) {
    ASSERT_EQ(refusal(file), "");
    for (std::size_t size = 0; size + 2 < file.size(); ++size)
      EXPECT_NE(refusal(file.substr(0, size)), "") << size << " of " << file.size();
    for (int i = 0; i < 1000; ++i) {
      std::string damaged = file;
      for (int k = 0; k < 3; ++k)
        damaged[random() % damaged.size()] = static_cast<char>(random());
      refusal(damaged);
    }
  }
}

TEST_F(CloudFiles, CoordinatesTooLargeForAFloatAreRefusedButStrayPointsAreNot)
{
  EXPECT_EQ(refusal(programs::pcdBytes({{8000, 1, 1}, {8000, 2, 1}, {8000, 3, 1}})), "");
  EXPECT_EQ(refusal(programs::pcdBytes({{1, 1, 1}, {1, 2, 1}, {4.5e6f, 3, 1}})), "");
  const std::string sentence = refusal("FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH 2\n"
                                       "DATA ascii\n412345.5 5650100 90\n412346.5 5650101 91\n");
  EXPECT_NE(sentence.find("5650101 m"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("(412000, 5650000, 0)"), std::string::npos) << sentence;
}

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
  EXPECT_THROW(checkWritable("/dev/null"), ToolError) << "a device is not to be replaced";
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

/** A tool's options, as tests see them. */
struct SampleOptions {
  std::string input;
  float leaf = 0.05f;
  unsigned int threads = 0;
  int steps = 3;
  double height = 0;
  bool has_height = false;
  std::string mode = "auto";
  bool fast = false;
  Options options{"pcl_sample", "Does something."};

  SampleOptions()
  {
    options.file("INPUT", input, "cloud");
    options.number("leaf", leaf, "m", "edge of a voxel", Range::above(0));
    options.number("threads", threads, "", "threads");
    options.number("steps", steps, "", "steps", Range::between(-5, 5));
    options.optionalNumber("height", height, has_height, "m", "height", "measured");
    options.text("mode", mode, "mode", {"auto", "manual"});
    options.flag("fast", fast, "in haste");
  }

  bool
  parse(std::vector<const char*> arguments)
  {
    arguments.insert(arguments.begin(), "pcl_sample");
    return options.parse(static_cast<int>(arguments.size()), arguments.data());
  }

  /** The sentence of refusal. */
  std::string
  refusal(const std::vector<const char*>& arguments)
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
  ASSERT_TRUE(sample.parse({"--leaf",
                            "0.1",
                            "in.pcd",
                            "--steps=-4",
                            "--height",
                            "-1.5",
                            "--mode",
                            "manual",
                            "--fast"}));
  EXPECT_EQ(sample.input, "in.pcd");
  EXPECT_EQ(sample.leaf, 0.1f);
  EXPECT_EQ(sample.threads, 0u);
  EXPECT_EQ(sample.steps, -4);
  EXPECT_TRUE(sample.has_height);
  EXPECT_EQ(sample.height, -1.5);
  EXPECT_EQ(sample.mode, "manual");
  EXPECT_TRUE(sample.fast);
}

TEST(ToolOptions, HelpShowsUnitsRangesAndTheDefaultsOfTheVariables)
{
  SampleOptions sample;
  EXPECT_FALSE(sample.parse({"-h"}));
  EXPECT_FALSE(sample.parse({"--help", "--leaf", "nonsense"}));
  const std::string help = sample.options.help();
  EXPECT_NE(help.find("edge of a voxel [m] (above 0; default 0.05)"), std::string::npos) << help;
  EXPECT_NE(help.find("(from -5 to 5; default 3)"), std::string::npos) << help;
  EXPECT_NE(help.find("(default measured)"), std::string::npos) << help;
  EXPECT_NE(help.find("pcl_sample INPUT [options]"), std::string::npos) << help;
}

TEST(ToolOptions, RefuseEachMistakeWithASentenceThatNamesIt)
{
  SampleOptions sample;
  EXPECT_NE(sample.refusal({}).find("INPUT is missing"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "b"}).find("'b'"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--leaf", "0"}).find("--leaf must be above 0 m, not 0"),
            std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--leaf", "-1"}).find("not -1"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--leaf", "nan"}).find("'nan'"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--leaf", "1cm"}).find("'1cm'"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--leaf", "1e300"}).find("1e300"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--leaf"}).find("needs a value"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--leaf", "1", "--leaf", "2"}).find("more than once"),
            std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--threads", "-1"}).find("-1"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--threads", "1.5"}).find("whole number"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--threads", "99999999999"}), "");
  EXPECT_NE(sample.refusal({"a", "--steps", "6"}).find("from -5 to 5"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--mode", "soon"}).find("auto, manual"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--lea", "1"}).find("--lea"), std::string::npos);
  EXPECT_NE(sample.refusal({"a", "--fast=yes"}), "");
}

} // namespace
