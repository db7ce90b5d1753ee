// SPDX-License-Identifier: BSD-3-Clause
// Clouds with all their fields, in memory and in the files that are written.
#include "scan_folder.h"

#include "bytes/whole_file.h"
#include <pcl/conversions.h>

namespace {

using namespace pcl::sedr::tools;
using namespace programs;
using Field = pcl::PCLPointField;

class CloudFiles : public ScanFolder {};

TEST_F(CloudFiles, EveryFieldSurvives)
{
  auto blob = manyFields();
  const std::uint32_t colour = 0xff102030U;
  std::memcpy(&blob.data[findField(blob, "rgb")->offset], &colour, sizeof colour);
  saveBlob(in("a.pcd"), blob);
  saveCompressed(in("b.pcd"), blob);
  saveBlob(in("c.PLY"), blob);
  EXPECT_NE(bytesOf(in("b.pcd")).find("DATA binary_compressed"), std::string::npos);
  for (const char* name : {"a.pcd", "b.pcd", "c.PLY"}) {
    const ToolCloud cloud = loadCloud(in(name));
    ASSERT_EQ(cloud.blob.fields.size(), blob.fields.size()) << name;
    for (const auto& field : blob.fields) {
      const auto* read = findField(cloud.blob, field.name);
      ASSERT_NE(read, nullptr) << field.name;
      EXPECT_EQ(read->datatype, field.datatype);
      if (field.name == "rgb")
        EXPECT_EQ(std::memcmp(&cloud.blob.data[read->offset], &colour, 4), 0) << name;
      else
        EXPECT_EQ(floatField(cloud.blob, field.name), floatField(blob, field.name));
    }
    EXPECT_TRUE(cloud.has_label);
    EXPECT_FALSE(cloud.has_room);
    EXPECT_EQ(cloud.label, (std::vector<std::uint32_t>{70, 71, 72}));
    EXPECT_EQ(cloud.room, (std::vector<std::uint32_t>{0, 0, 0}));
  }
  EXPECT_THROW(saveBlob(in("d.txt"), blob), ToolError);
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
    saveBlob(in("whole.pcd"), blob);
    saveStructure(in("pieces.pcd"), structure);
    EXPECT_EQ(bytesOf(in("pieces.pcd")), bytesOf(in("whole.pcd")));
  }
}

TEST_F(CloudFiles, AFileIsWrittenWholeOrNotAtAll)
{
  const std::string path = write("old", "a.txt");
  EXPECT_THROW(writeWhole(path,
                          [](std::ostream& stream) {
                            stream << "half of the ne";
                            throw ToolError("stopped");
                          }),
               ToolError);
  EXPECT_THROW(writeWhole(path, [](std::ostream& s) { s.setstate(std::ios::badbit); }),
               ToolError);
  EXPECT_EQ(bytesOf(path), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1);
  EXPECT_THROW(checkWritable("/dev/null"), ToolError);
  EXPECT_THROW(checkWritable(folder_.path().string()), ToolError);
  std::filesystem::create_symlink(path, in("link"));
  writeWhole(in("link"), [](std::ostream& stream) { stream << "new"; });
  EXPECT_TRUE(std::filesystem::is_symlink(in("link")));
  EXPECT_EQ(bytesOf(path), "new");
}

} // namespace
