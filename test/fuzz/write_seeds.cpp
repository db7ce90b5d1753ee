// SPDX-License-Identifier: BSD-3-Clause
// Writes small valid files of every format as seeds of the fuzzers: write_fuzz_seeds
// FOLDER makes FOLDER/e57, FOLDER/las, FOLDER/pcd, FOLDER/ply and FOLDER/text.
#include "tools/scans/e57_writer.h"
#include "tools/scans/las_writer.h"

#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

using programs::E57TestField;
using programs::E57Writer;
using programs::LasSample;

class Seeds {
public:
  explicit Seeds(std::filesystem::path folder)
      : folder_(std::move(folder))
  {}

  void write(const std::string& format, const std::string& bytes)
  {
    std::filesystem::create_directories(folder_ / format);
    std::ofstream(folder_ / format / std::to_string(number_++), std::ios::binary)
        << bytes;
  }

private:
  std::filesystem::path folder_;
  int number_ = 0;
};

/** Returns the pages of an E57 file without their checksums. */
std::string
unsealed(const std::string& file)
{
  std::string payload;
  for (std::size_t at = 0; at < file.size(); at += E57Writer::page)
    payload += file.substr(at, E57Writer::payload);
  return payload;
}

void
writeE57(Seeds& seeds)
{
  std::vector<std::int64_t> whole;
  std::vector<double> real;
  for (int i = 0; i < 60; ++i) {
    whole.push_back(i * 37 % 501 - 250);
    real.push_back(0.05 * i);
  }
  const auto integers = [&](const char* name) {
    return E57TestField::ofIntegers(name, whole, -250, 250,
                                    "scale=\"0.01\" offset=\"3\"");
  };
  E57Writer cartesian;
  cartesian.packet_bytes = 150;
  cartesian.has_index = cartesian.is_uneven = true;
  cartesian.addScan("a",
                    {integers("cartesianX"), integers("cartesianY"),
                     integers("cartesianZ"), integers("intensity")},
                    E57Writer::pose(1, 0, 0, 0, 1, 2, 3));
  seeds.write("e57", unsealed(cartesian.file()));
  E57Writer spherical;
  spherical.addScan(
      "b",
      {E57TestField::ofReals<double>("sphericalRange", real),
       E57TestField::ofReals<double>("sphericalAzimuth", real),
       E57TestField::ofReals<float>("sphericalElevation", std::vector<float>(60, 0.5F)),
       E57TestField::ofIntegers("sphericalInvalidState",
                                std::vector<std::int64_t>(60, 0), 0, 2)});
  spherical.addScan("c", {integers("cartesianX"), integers("cartesianY"),
                          integers("cartesianZ"), integers("colorRed"),
                          integers("colorGreen"), integers("colorBlue")});
  seeds.write("e57", unsealed(spherical.file()));
}

void
writeLas(Seeds& seeds)
{
  LasSample las;
  for (int i = 0; i < 20; ++i)
    las.points.push_back({i * 100, i * 70 % 900, i * 30 % 270});
  seeds.write("las", las.bytes());
  las.minor = 4;
  las.format = 7;
  las.record = 36;
  las.colour_offset = 30;
  las.before.assign(60, '\0');
  seeds.write("las", las.bytes());
}

/** Writes PCD, PLY and text from literals. */
void
writeClouds(Seeds& seeds)
{
  const std::string xyz("\0\0\x80?\0\0\0@\0\0@@", 12); // 1, 2, 3 as floats
  const std::string header = "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z intensity\n"
                             "SIZE 4 4 4 1\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 2\n"
                             "HEIGHT 1\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS 2\nDATA ";
  seeds.write("pcd", header + "ascii\n1 2 3 4\n5 nan 7 8\n");
  seeds.write("pcd", header + "binary\n" + xyz + "\1" + xyz + "\2");
  // 26 bytes, field by field, as one literal run of LZF.
  const std::string fields = xyz + xyz + "\1\2";
  seeds.write("pcd", header + "binary_compressed\n" +
                         std::string("\x1b\0\0\0\x1a\0\0\0\x19", 9) + fields);
  const std::string far = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\n"
                          "VIEWPOINT 2000 0 0 1 0 0 0\nPOINTS 1\nDATA ";
  seeds.write("pcd", "# .PCD v0.7\n# sedr_origin 2000 0 0\n"
                     "# sedr_viewpoint 1 2 1.5 1 0 0 0\n" +
                         far + "ascii\n1 2 3\n");
  seeds.write("pcd", "# .PCD v0.7\n" + far + "binary\n" + xyz);
  const std::string element =
      "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string faces("\3\0\0\0\0\1\0\0\0\0\0\0\0", 13);
  for (const char* order : {"binary_little_endian", "binary_big_endian"})
    seeds.write("ply", std::string("ply\nformat ") + order + " 1.0\ncomment a\n" +
                           element + xyz + "abc" + xyz + "def" + faces);
  seeds.write("ply",
              "ply\nformat binary_big_endian 1.0\nelement vertex 3\nend_header\nabc");
  seeds.write("ply", "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty "
                     "list uchar int vertex_indices\nelement vertex 1\nproperty float "
                     "x\nproperty float y\nproperty float z\nend_header\n" +
                         faces + xyz);
  seeds.write("ply", "ply\nformat ascii 1.0\n" + element +
                         "1 2 3 4 5 6\n7 8 9 10 11 12\n3 0 1 0\n");
  seeds.write("text", "//X Y Z Intensity\n1 2 3 4\n5 6 7 8\n");
  seeds.write("text", "1,5;2,5;3\n4;5,25;6e1\n");
  seeds.write("text", "\"X\";\"Y\";\"Z\"\n\"1,5\";\"2\";\"3\"\n");
  seeds.write("text", "# comment\n1 2 3 10 20 30\n-4 +5 .6 1 2 3\n\n");
  seeds.write("text", "# positions\n1 2 1.5 40\n3 2 1.5 60\n");
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 2) {
    std::cerr << "write_fuzz_seeds: FOLDER is missing\n";
    return 1;
  }
  Seeds seeds(argv[1]);
  writeE57(seeds);
  writeLas(seeds);
  writeClouds(seeds);
  return 0;
}
