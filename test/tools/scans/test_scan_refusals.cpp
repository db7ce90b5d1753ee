// SPDX-License-Identifier: BSD-3-Clause
// What is no scan, or a broken one, is refused by one sentence: a table a format.
#include "scan_folder.h"
#include "scan_settings.h"

namespace {

using namespace pcl::sedr::tools;
using namespace programs;

class ScanRefusals : public ScanFolder {};

const std::string no_words(9999, '\7');

TEST_F(ScanRefusals, OfPcd)
{
  const std::string good = pcdBytes({{1, 2, 3}, {4, 5, 6}});
  const std::string head = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nDATA ";
  const std::string ascii = head + "ascii\n";
  const std::string packed = head + "binary_compressed\n";
  const float nan = std::numeric_limits<float>::quiet_NaN();
  ASSERT_EQ(refusal(good), "");
  expectRefusals(
      {{good.substr(0, good.size() - 5), "cut off, its header promises 2 points"},
       {good + std::string(12, 'x'), "12 bytes, but 36 bytes follow"},
       {good.substr(0, good.find("WIDTH")), "without a DATA line"},
       {replaced(good, "WIDTH 2", "WIDTH 3"), "3 x 1 points in rows, but 2 in all"},
       {replaced(good, "WIDTH 2", "WIDTH -2"), "not a whole number"},
       {replaced(good, "WIDTH 2", "WIDTH 4000000000000"), "4000000000000 x 1"},
       {replaced(good, "SIZE 4 4 4", "SIZE 4 4"), "names 3 fields, but 2 sizes"},
       {replaced(good, "SIZE 4 4 4", "SIZE 4 4 3"), "which is unknown"},
       {replaced(good, "COUNT 1 1 1", "COUNT 1 1 0"), "count 0, which is unknown"},
       {replaced(good, "COUNT 1 1 1", "COUNT 1 1 99999999"), "which is unknown"},
       {replaced(good, "DATA binary", "DATA morse"), "'morse', not ascii or binary"},
       {replaced(good, "FIELDS x y z", "FIELDS x y w"), "no field 'z'"},
       {replaced(good, "FIELDS x y z", "FIELDS x y x"), "two fields 'x'"},
       {replaced(good, "FIELDS x", "FIELDS " + no_words), ""},
       {"WIDTH 2\n", "as PCD"},
       {ascii + "1 2 3\n4 5 6 7\n", "point 2 has more than 3 numbers"},
       {ascii + "1 2 3\n4 5 six\n", "point 2 has 2 of 3 numbers"},
       {ascii + "1 2 3\n", "promises 2 points, it holds 1"},
       {ascii + "1 2 3\n4 5 6\n7 8 9\n", "promises 2 points, but more lines follow"},
       {replaced(ascii, "WIDTH 2", "WIDTH 2000000000"), "promises 2000000000 points"},
       {packed + "abc", "cut off"},
       {packed + std::string("\4\0\0\0\x18\0\0\0abc", 11), "cut off"},
       {packed + std::string("\4\0\0\0\x18\0\0\0\xff\xff\xff\xff", 12), "damaged"},
       {replaced(packed, "WIDTH 2", "WIDTH 2500000") +
            std::string("\4\0\0\0\x80\xc3\xc9\1abcd", 12),
        "its 4 compressed bytes promise 30000000"},
       {pcdBytes({{nan, 0, 0}}), "no finite point among its 1"},
       {pcdBytes({}), "has 0 points"},
       {pcdBytes({{5e5F, 5.5e6F, 90}}), "too large"}});
}

/** 2^31 bytes before the coordinates and as many behind them look, in 32 bits, like
 * points of 12 bytes. */
TEST_F(ScanRefusals, OfPointsLargerThanFourGigabytes)
{
  std::string names, sizes, types, counts;
  const auto add = [&](const std::string& name, int size, int count) {
    names += " " + name;
    sizes += " " + std::to_string(size);
    types += " F";
    counts += " " + std::to_string(count);
  };
  constexpr int many = 8192; // of 2^19 bytes each: 2^32
  for (int k = 0; k < many; ++k) {
    if (k == many / 2)
      for (const char* name : {"x", "y", "z"})
        add(name, 4, 1);
    add("f" + std::to_string(k), 8, 1 << 16);
  }
  for (const char* data : {"binary\n", "ascii\n"})
    EXPECT_TRUE(says(refusal("FIELDS" + names + "\nSIZE" + sizes + "\nTYPE" + types +
                             "\nCOUNT" + counts + "\nWIDTH 1000\nDATA " + data +
                             std::string(12000, '\0')),
                     "4294967308 bytes"));
}

TEST_F(ScanRefusals, OfPly)
{
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string rest = "element vertex 1\n" + xyz + "end_header\n";
  const std::string ascii = "ply\nformat ascii 1.0\n" + rest;
  const std::string binary = "ply\nformat binary_little_endian 1.0\n";
  const std::string list = "element face 1\nproperty list ";
  ASSERT_EQ(refusal(ascii + "1 2 3\n\n"), "");
  expectRefusals(
      {{ascii + "1 2 3\n4 5 6\n", "promises 1 points, but more lines follow"},
       {ascii + "1 2\n", "point 1 has 2 of 3 numbers"},
       {ascii, "cut off"},
       {binary + rest + std::string(11, '\0'), "cut off"},
       {binary + rest + std::string(24, '\0'), "but 24 bytes follow"},
       {replaced(ascii, "vertex 1", "vertex 2000000000") + "1 2 3\n", "2000000000"},
       {replaced(ascii, "vertex 1", "vertex one"), "'one' is no number of elements"},
       {replaced(ascii, "ascii", "morse"), "its format is 'morse'"},
       {replaced(ascii, "float x", "floaty x"), "'floaty' of a property is unknown"},
       {replaced(ascii, "element vertex 1", "element face 1"),
        "first element is not 'vertex'"},
       {replaced(ascii, "end_header", no_words), "line that is none"},
       {"ply\nformat ascii 1.0\n", "does not end"},
       {binary + "element vertex 3\nend_header\nabcabcabc", "no field 'x'"},
       {binary + list + "char char i\n" + rest, "first element is not 'vertex'"},
       {binary + list + "float char i\n" + rest, "no whole number"}});
}

TEST_F(ScanRefusals, OfLas)
{
  const auto with = [](const auto& change) {
    LasSample las = threeLasPoints();
    change(las);
    return las.bytes();
  };
  std::string followed = with([](auto& las) {
    las.minor = 4;
    las.format = 6;
    las.record = 30;
  });
  followed.replace(235, 2, std::string("\xd1\1", 2)); // 375 + 3 * 30: records follow
  followed += std::string(120, 'x');
  expectRefusals(
      {{with([](auto& las) { las.claimed_points = 4; }),
        "cut off, its header promises 4 points of 20 bytes, but 60 bytes"},
       {with([](auto& las) { las.claimed_points = 2; }), "promises 2 points"},
       {followed, "210 bytes follow"},
       {with([](auto& las) {
          las.minor = 4;
          las.claimed_points = 1LL << 62;
        }),
        "promises 4611686018427387904 points"},
       {with([](auto& las) { las.minor = 7; }), "of version 1.7"},
       {with([](auto& las) { las.format = 11; }), "of the format 11"},
       {with([](auto& las) { las.format = 3; }), "20 bytes, format 3 takes 34"},
       {with([](auto& las) { las.scale[1] = -0.001; }), "the scale of y is -0.001"},
       {with([](auto& las) { las.scale[1] = 0; }), "the scale of y is 0.0"},
       {with([](auto& las) { las.points.clear(); }), "has 0 points"},
       {with([](auto& las) { las.format = 0x80; }), "pdal translate IN.laz OUT.las"},
       {with([](auto&) {}).substr(0, 100), "100 bytes of the 227"}});
  followed[243] = 1; // tells that records follow
  EXPECT_EQ(load(followed).size(), 3u);
}

TEST_F(ScanRefusals, OfE57)
{
  const auto fields = integerFields(wholeCoordinates(500, 5000), 5000);
  const auto fileOf = [](const std::vector<E57TestField>& own,
                         const std::string& pose = "", long long claimed = -1) {
    E57Writer writer;
    writer.addScan("hall", own, pose, claimed);
    return writer.file();
  };
  const std::string good = fileOf(fields);
  ASSERT_EQ(refusal(good), "");
  std::string changed = good;
  changed[1500] = static_cast<char>(changed[1500] ^ 16);
  const auto withNumber = [&](std::size_t at, std::uint64_t number) {
    std::string page = good.substr(0, E57Writer::payload);
    page.replace(at, sizeof number, reinterpret_cast<const char*>(&number),
                 sizeof number);
    return E57Writer::sealed(page) + good.substr(E57Writer::page);
  };
  auto shrunk = fields;
  shrunk[1].attributes = "type=\"ScaledInteger\" minimum=\"0\" maximum=\"9\" "
                         "scale=\"-1\"";
  std::vector<E57TestField> constant;
  for (const char* name : {"cartesianX", "cartesianY", "cartesianZ"})
    constant.push_back(E57TestField::ofIntegers(name, {1}, 1, 1));
  auto none = fields;
  for (auto& field : none)
    field.stored.clear();
  expectRefusals(
      {{changed, "page 2 of 4 is damaged, its checksum is"},
       {good.substr(0, good.size() - 1), "cut off, its header promises 4096 bytes"},
       {good.substr(0, 40), "it has 40 bytes of the 48"},
       {withNumber(8, 9), "version 9"},
       {withNumber(40, 5), "pages are said to have 5 bytes"},
       {withNumber(16, 3000), "3000 bytes are no whole number of pages of 1024"},
       {withNumber(24, 3000000), "its XML is said to begin at byte 3000000"},
       {withNumber(24, 1021), "its XML is said to begin at byte 1021"},
       {withNumber(32, 1ULL << 40), "its XML is said to have 1099511627776 bytes"},
       {fileOf(fields, "", 501),
        "scan 1 ('hall'): it is said to have 501 points, its packets hold "
        "'cartesianX' of 500"},
       {fileOf(fields, "", 400), "400 points, its packets hold 'cartesianX' of 500"},
       {fileOf(constant, "", 0x7fffffff), "one and the same"},
       {fileOf(fields, "", 1LL << 60), "said to have 1152921504606846976 points"},
       {fileOf({fields[0], fields[1]}), "neither cartesian nor spherical"},
       {fileOf(shrunk), "the scale of 'cartesianY' is -1.0"},
       {fileOf(fields, E57Writer::pose(1, 1, 0, 0, 0, 0, 0)), "the length 1.41"},
       {fileOf(none), "has 0 points"},
       {E57Writer().file(), "it holds no scan"}});
  EXPECT_EQ(load(fileOf(constant, "", 3000)).size(), 3000u);
  ScanSettings third;
  third.scan = 3;
  EXPECT_TRUE(says(refusal(good, third), "has no scan 3, it holds 1"));
}

TEST_F(ScanRefusals, OfXmlThatWouldGrowOrGoTooDeep)
{
  const auto times = [](int n, const std::string& text) {
    std::string all;
    for (int k = 0; k < n; ++k)
      all += text;
    return all;
  };
  const auto fileOf = [](const std::string& xml) { return E57Writer().fileWith(xml); };
  const std::string deep = times(100000, "<a>");
  expectRefusals(
      {{fileOf(deep), "deeper than 64"},
       {fileOf("<!DOCTYPE x [<!ENTITY a \"aaaa\">]><e57Root/>"), "document type"},
       {fileOf(times(10000, "<a b='/>'>")), "deeper than 64"},
       {fileOf(times(10000, "<a><!--</a>-->")), "deeper than 64"},
       {fileOf("<e57Root>" + times(150000, "<a b=''/>") + "</e57Root>"),
        "more than 262144 elements and attributes"},
       {fileOf("<e57Root><data3D></e57Root>"), "of its XML cannot be read"},
       {fileOf("<!-- <!DOCTYPE x> --><a><![CDATA[<!DOCTYPE y>]]></a>"), "'e57Root'"}});
}

TEST_F(ScanRefusals, OfText)
{
  const std::string points = "1 2 3 0.5\n4 5 6 0.5\n";
  expectRefusals(
      {{"hello", "neither PCD nor PLY, E57, LAS or columns of numbers"},
       {std::string("1 2 3\0\n", 7), "neither"},
       {"\"1.5\",\"2.5\",\"3.5\"\n", "neither"}, // in quotes
       {"1 2 3\n4 5\n", "point 2 has 2 of 3 numbers"},
       {"1 2 3 4\n1 2 3\n", "point 2 has 3 of 4"},
       {"1,2,3,4,5\n1,,3,4,5\n", "point 2 has 1 of 5"},
       {"1\t2\t3\t4\n1\t\t3\t4\n", "point 2 has 1 of 4"},
       {"1,2,3,a\n1,,3,a\n", "point 2 has 1 of 3"},
       {"1;2;3\n1,5;2;3\n", "point 2 has more than 3"},
       {"-2\n" + points, "'-2'"},
       {"2\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n" +
            points,
        "point 5 has more than 3"},
       {"a,b,c\n1,2,3\n", "--columns"},
       {"Lat Lon Alt\n1 2 3\n", "--columns"},
       {"//Lat,Lon,H\n1,2,3\n", "--columns"},
       {"id x y z\n1 2 3\n", "--columns"},
       {"# east;middle;up\n1;2;3\n", "--columns"},
       {std::string(9999, 'a') + "\n1 2 3\n", ""}});
  ScanSettings asked;
  asked.columns = "x y";
  EXPECT_TRUE(says(refusal("1 2 3\n", asked), "each of x, y and z"));
  asked.columns = "x,y,z,intensity";
  EXPECT_TRUE(says(refusal("1 2 3\n", asked), "3 of the 4 columns"));
}

TEST_F(ScanRefusals, OfOptionsThatHaveNothingToActOn)
{
  ScanSettings scan, skip, columns;
  scan.scan = 2;
  skip.skip_broken = true;
  columns.columns = "x,y,z";
  for (const std::string& bytes :
       {threeLasPoints().bytes(), pcdBytes({{1, 2, 3}}), std::string("1 2 3\n")})
    for (const ScanSettings& settings : {scan, skip})
      EXPECT_TRUE(says(refusal(bytes, settings), "is no E57 file"));
  EXPECT_TRUE(says(refusal(pcdBytes({{1, 2, 3}}), columns), "--columns"));
  EXPECT_THROW(loadCloud(in("missing")), ToolError);
  EXPECT_THROW(loadCloud(folder_.path().string()), ToolError);
  EXPECT_TRUE(says(refusal(""), "empty"));
}

/** Good files of every format with changed bytes, with right checksums or not, or cut
 * off, are read or refused. */
TEST_F(ScanRefusals, ChangedBytesAreReadOrRefused)
{
  E57Writer e57;
  e57.packet_bytes = 300;
  e57.has_index = true;
  e57.addScan("a", integerFields(wholeCoordinates(300, 500), 500),
              E57Writer::pose(1, 0, 0, 0, 1, 2, 3));
  e57.addScan("b", {E57TestField::ofReals<double>("sphericalRange", {1, 2, 3}),
                    E57TestField::ofReals<double>("sphericalAzimuth", {1, 2, 3}),
                    E57TestField::ofReals<float>("sphericalElevation", {0, 0, 1})});
  LasSample las = threeLasPoints();
  las.minor = 4;
  las.format = 7;
  las.record = 36;
  las.colour_offset = 30;
  saveCompressed(in("packed.pcd"), manyFields());
  saveBlob(in("cloud.ply"), manyFields());
  std::mt19937 random(5);
  for (const std::string& good :
       {e57.file(), las.bytes(), pcdBytes({{1, 2, 3}, {4, 5, 6}}),
        bytesOf(in("packed.pcd")), bytesOf(in("cloud.ply")),
        std::string("//X Y Z Intensity\n1 2 3 4\n5 6 7 8\n")}) {
    const bool is_e57 = good[0] == 'A';
    constexpr std::size_t trials = 1500;
    std::size_t refused = 0;
    for (std::size_t trial = 0; trial < trials; ++trial) {
      std::string bytes = good;
      for (std::size_t k = 0; k <= trial % 4; ++k)
        bytes[random() % (trial % 3 == 0 ? std::min<std::size_t>(200, good.size())
                                         : good.size())] =
            static_cast<char>(trial % 5 == 0 ? 0xff : random());
      if (is_e57 && trial % 8 != 0) { // right checksums reach more code
        std::string sealed;
        for (std::size_t p = 0; p < bytes.size(); p += E57Writer::page)
          sealed += E57Writer::sealed(bytes.substr(p, E57Writer::payload));
        bytes = sealed;
      }
      if (trial % 20 == 0)
        bytes.resize(random() % bytes.size() + 1);
      ScanSettings settings;
      settings.skip_broken = is_e57 && trial % 16 == 1;
      refused += refusal(bytes, settings).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, trials / 20) << good.substr(0, 20);
    EXPECT_LT(refused, trials) << good.substr(0, 20);
  }
}

} // namespace
