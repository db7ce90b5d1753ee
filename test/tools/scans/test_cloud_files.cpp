// SPDX-License-Identifier: BSD-3-Clause
#include "scan_options.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"

#include "sedr_filters/src/base/field_access.h"
#include <pcl/conversions.h>

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace pcl::sedr::tools;
using programs::bytesOf;
using programs::manyFields;
using programs::TemporaryFolder;
using programs::writeFile;
using Field = pcl::PCLPointField;

class CloudFiles : public ::testing::Test {
protected:
  std::string in(const std::string& name) const
  {
    return (folder_.path() / name).string();
  }

  ToolCloud load(const std::string& bytes)
  {
    writeFile(in("cloud"), bytes);
    return loadCloud(in("cloud"));
  }

  /** Returns the error for `bytes`; "" if there is none. */
  std::string refusal(const std::string& bytes)
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

TEST_F(CloudFiles, AStructureInPiecesIsTheSameFile)
{
  for (const std::size_t size : {std::size_t{0}, std::size_t{100000}}) {
    pcl::PointCloud<pcl::PointStructure> structure;
    for (std::size_t i = 0; i < size; ++i) {
      pcl::PointStructure p;
      p.getVector3fMap() << static_cast<float>(i), 2, 3;
      p.label = static_cast<std::uint32_t>(i % 4);
      p.room = static_cast<std::uint32_t>(i / 4);
      structure.push_back(p);
    }
    pcl::PCLPointCloud2 blob;
    pcl::toPCLPointCloud2(structure, blob);
    saveCloud(in("whole.pcd"), blob);
    saveStructure(in("pieces.pcd"), structure);
    EXPECT_EQ(bytesOf(in("pieces.pcd")), bytesOf(in("whole.pcd")));
  }
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
  const ToolCloud cloud =
      load("# a comment\nVERSION .7\nFIELDS x y z room\nSIZE 4 8 4 1\n"
           "TYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\n"
           "VIEWPOINT 1 2 3 1 0 0 0\nPOINTS 2\nDATA ascii\n"
           "1.5 -2e1 +3 7\r\n\n nan 5 -inf 9\n");
  EXPECT_EQ((*cloud.points)[0].y, -20.f);
  EXPECT_EQ((*cloud.points)[0].z, 3.f);
  EXPECT_TRUE(std::isnan((*cloud.points)[1].x));
  EXPECT_EQ(cloud.room, (std::vector<std::uint32_t>{7, 9}));
  EXPECT_EQ(cloud.points->sensor_origin_.y(), 2.f);
  EXPECT_EQ(findField(cloud.blob, "y")->datatype, Field::FLOAT32)
      << "doubles become floats";
}

TEST_F(CloudFiles, PaddingOfBinaryPcdIsLeftOut)
{
  std::string bytes =
      "VERSION 0.7\nFIELDS x y z _ label\nSIZE 4 4 4 1 4\nTYPE F F F U U\n"
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
  const std::string rest =
      "comment made by hand\nelement vertex 2\nproperty double x\n"
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

TEST_F(CloudFiles, PlyWithListsBeforeItsVerticesIsRead)
{
  const std::string elements = "element face 2\nproperty list ushort int i\nproperty "
                               "uchar kind\nelement nothing 9\nelement vertex 2\n"
                               "property float x\nproperty float y\nproperty float z\n"
                               "end_header\n";
  const ToolCloud ascii =
      load("ply\nformat ascii 1.0\n" + elements + "2 5 6 1\n\n0 1\n1 2 3\n\n4 5 6\n");
  for (const bool is_big : {false, true}) {
    std::string bytes = std::string("ply\nformat binary_") +
                        (is_big ? "big" : "little") + "_endian 1.0\n" + elements;
    const auto append = [&](auto value) {
      const char* first = reinterpret_cast<const char*>(&value);
      for (std::size_t k = 0; k < sizeof value; ++k)
        bytes += first[is_big ? sizeof value - 1 - k : k];
    };
    append(std::uint16_t{2});
    append(5);
    append(6);
    append('a');
    append(std::uint16_t{0});
    append('b');
    const std::string faces = bytes;
    for (const float v : {1.F, 2.F, 3.F, 4.F, 5.F, 6.F})
      append(v);
    EXPECT_EQ(load(bytes).blob.data, ascii.blob.data);
    EXPECT_NE(refusal(faces).find("cut off"), std::string::npos);
    EXPECT_NE(refusal(bytes.substr(0, faces.size() - 3)).find("cut off"),
              std::string::npos);
  }
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
  EXPECT_NE(refusal(good + std::string(12, 'x')).find("24 bytes, but 36 bytes follow"),
            std::string::npos);
  EXPECT_NE(refusal(replaced("WIDTH 2", "WIDTH 3")), "");
  EXPECT_NE(refusal(replaced("WIDTH 2", "WIDTH -2")), "");
  EXPECT_NE(refusal(replaced("POINTS 2", "POINTS 4000000000000")), "");
  EXPECT_NE(refusal(replaced("SIZE 4 4 4", "SIZE 4 4")), "");
  EXPECT_NE(refusal(replaced("SIZE 4 4 4", "SIZE 4 4 3")), "");
  EXPECT_NE(refusal(replaced("COUNT 1 1 1", "COUNT 1 1 0")), "");
  EXPECT_NE(refusal(replaced("COUNT 1 1 1", "COUNT 1 1 999999999")), "");
  EXPECT_NE(refusal(replaced("DATA binary", "DATA morse")), "");
  EXPECT_NE(refusal(replaced("FIELDS x y z", "FIELDS x y w")).find("'z'"),
            std::string::npos);
  const std::string huge =
      "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2000000000\nDATA ascii\n";
  EXPECT_NE(refusal(huge + "1 2 3\n").find("2000000000"), std::string::npos)
      << "refused before memory is taken";
  EXPECT_NE(
      refusal("ply\nformat ascii 1.0\nelement vertex 2000000000\nproperty float x\n"
              "end_header\n1\n")
          .find("2000000000"),
      std::string::npos);
  EXPECT_NE(
      refusal("ply\nformat binary_little_endian 1.0\nelement vertex 3\nend_header\n"
              "abcabcabc")
          .find("3 points of 0 bytes"),
      std::string::npos);
  EXPECT_NE(refusal("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nDATA ascii\n"
                    "1 2 3\n4 5 6\n")
                .find("promises 1 points, but more lines follow"),
            std::string::npos);
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                          "property float y\nproperty float z\nend_header\n1 2 3\n";
  EXPECT_EQ(refusal(ply + "\n"), "");
  EXPECT_NE(refusal(ply + "4 5 6\n").find("promises 1 vertices, but more lines"),
            std::string::npos);
  const std::string strange =
      refusal(replaced("FIELDS x", "FIELDS " + std::string(9999, '\7')));
  EXPECT_NE(strange, "");
  EXPECT_LT(strange.size(), 500u);
  EXPECT_NE(refusal(replaced("WIDTH 2", "WIDTH 4000000000000")).find("counted"),
            std::string::npos);
}

/** 2^31 bytes precede the coordinates and as many follow them. In 32 bits this looks
 * like points of 12 bytes, with x far beyond the end of the file. */
TEST_F(CloudFiles, PointsLargerThanFourGigabytesAreRefused)
{
  std::string fields = "FIELDS";
  std::string sizes = "SIZE";
  std::string types = "TYPE";
  std::string counts = "COUNT";
  const auto add = [&](const std::string& name, int size, int count) {
    fields += " " + name;
    sizes += " " + std::to_string(size);
    types += " F";
    counts += " " + std::to_string(count);
  };
  constexpr int max_values = 1 << 16;
  constexpr int many = 8192; // of 2^19 bytes each: 2^32
  for (int k = 0; k < many; ++k) {
    if (k == many / 2)
      for (const char* name : {"x", "y", "z"})
        add(name, 4, 1);
    add("f" + std::to_string(k), 8, max_values);
  }
  const std::string points(1000 * 12, '\0');
  EXPECT_NE(refusal(fields + "\n" + sizes + "\n" + types + "\n" + counts +
                    "\nWIDTH 1000\nPOINTS 1000\nDATA binary\n" + points)
                .find("4294967308 bytes"),
            std::string::npos);
}

TEST_F(CloudFiles, ACompressedPcdThatIsCutOffIsToldFromADamagedOne)
{
  saveCloud(in("a.pcd"), manyFields(), PcdData::Compressed);
  std::string bytes = bytesOf(in("a.pcd"));
  EXPECT_NE(refusal(bytes.substr(0, bytes.size() - 1)).find("cut off"),
            std::string::npos);
  bytes[bytes.find("binary_compressed\n") + 18]--; // declares one compressed byte less
  EXPECT_NE(refusal(bytes).find("damaged"), std::string::npos);
  const std::string lengths =
      std::string("\x04\0\0\0", 4) + "\x80\xc3\xc9\x01"; // 4, 30000000
  EXPECT_NE(refusal("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2500000\n"
                    "DATA binary_compressed\n" +
                    lengths + "abcd")
                .find("4 bytes cannot hold 30000000"),
            std::string::npos)
      << "refused before memory is taken";
}

/** A valid file that is truncated or changed anywhere must be read or rejected, without
 * other effects. */
TEST_F(CloudFiles, DamagedFilesAreReadOrRefused)
{
  std::vector<std::string> files;
  saveCloud(in("a.pcd"), manyFields());
  files.push_back(bytesOf(in("a.pcd")));
  saveCloud(in("a.pcd"), manyFields(), PcdData::Compressed);
  files.push_back(bytesOf(in("a.pcd")));
  saveCloud(in("a.ply"), manyFields());
  files.push_back(bytesOf(in("a.ply")));
  files.push_back(
      "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nDATA ascii\n"
      "1 2 3\n4 5 6\n");
  files.push_back(
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n1 2 3\n");
  std::mt19937 random(1);
  for (const auto& file : files) {
    ASSERT_EQ(refusal(file), "");
    for (std::size_t size = 0; size + 2 < file.size(); ++size)
      EXPECT_NE(refusal(file.substr(0, size)), "") << size << " of " << file.size();
    for (int i = 0; i < 300; ++i) {
      std::string damaged = file;
      for (int k = 0; k < 3; ++k)
        damaged[random() % damaged.size()] = static_cast<char>(random());
      refusal(damaged);
    }
  }
}

TEST_F(CloudFiles, CoordinatesTooLargeForAFloatAreRefusedButStrayPointsAreNot)
{
  EXPECT_EQ(refusal(programs::pcdBytes({{8000, 1, 1}, {8000, 2, 1}, {8000, 3, 1}})),
            "");
  EXPECT_EQ(refusal(programs::pcdBytes({{1, 1, 1}, {1, 2, 1}, {4.5e6f, 3, 1}})), "");
  // Doubles keep their digits until an origin is subtracted; floats have lost them.
  EXPECT_EQ(refusal("FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH 2\n"
                    "DATA ascii\n412345.5 5650100 90\n412346.5 5650101 91\n"),
            "");
  const std::string sentence =
      refusal(programs::pcdBytes({{412345.5f, 5650100, 90}, {412346.5f, 5650101, 91}}));
  EXPECT_NE(sentence.find("5650101 m"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("(412000, 5650000, 0)"), std::string::npos) << sentence;
}

TEST_F(CloudFiles, OriginsOfModelsAreReadOrTheFileIsRefused)
{
  const auto reasonFor = [&](const std::string& json) -> std::string {
    writeFile(in("plan.json"), json);
    try {
      originOfModel(in("plan.json"));
      return "";
    }
    catch (const ToolError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(reasonFor(R"({"origin": [691000, 5335990.5, -3]})"), "");
  EXPECT_EQ(originOfModel(in("plan.json")),
            (pcl::sedr::Origin{{691000, 5335990.5, -3}}));
  EXPECT_EQ(reasonFor(R"({"rooms": []})"), "");
  EXPECT_TRUE(originOfModel(in("plan.json")).isZero());
  EXPECT_NE(reasonFor(R"({"origin": [691000, 53)").find("is no JSON"),
            std::string::npos);
  EXPECT_NE(reasonFor(""), "");
  EXPECT_NE(reasonFor(R"({"origin": [1, 2]})").find("three numbers"),
            std::string::npos);
}

} // namespace
