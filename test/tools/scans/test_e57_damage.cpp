// SPDX-License-Identifier: BSD-3-Clause
#include "e57/e57_tree.h"
#include "e57_files.h"

namespace {

using namespace pcl::sedr::tools;
using namespace programs;

TEST_F(E57Files, WhatIsBrokenIsToldWithNumbers)
{
  const auto fields = integerFields(wholeCoordinates(500, 5000), 5000);
  E57Writer writer;
  writer.addScan("hall", fields);
  const std::string good = writer.file();
  const auto expect = [&](const std::string& bytes, const std::string& part) {
    const std::string reason = refusal(bytes);
    EXPECT_NE(reason.find(part), std::string::npos) << reason;
    EXPECT_NE(reason.find("scan.e57'"), std::string::npos) << reason;
  };
  std::string bytes = good;
  bytes[1500] = static_cast<char>(bytes[1500] ^ 16);
  expect(bytes, "page 2 of 4 is damaged, its checksum is");
  expect(good.substr(0, good.size() - 1), "cut off, its header promises 4096 bytes");
  expect(good.substr(0, 40), "it has 40 bytes of the 48");
  const auto withNumber = [&](std::size_t at, std::uint64_t number) {
    std::string page = good.substr(0, E57Writer::payload);
    page.replace(at, sizeof number, reinterpret_cast<const char*>(&number),
                 sizeof number);
    return E57Writer::sealed(page) + good.substr(E57Writer::page);
  };
  expect(withNumber(8, 9), "version 9");
  expect(withNumber(40, 5), "pages are said to have 5 bytes");
  expect(withNumber(16, 3000), "its 3000 bytes are no whole number of pages of 1024");
  expect(withNumber(24, 3000000), "its XML is said to begin at byte 3000000");
  expect(withNumber(24, 1021), "its XML is said to begin at byte 1021");
  expect(withNumber(32, 1ull << 40), "its XML is said to have 1099511627776 bytes");

  E57Writer lying;
  lying.addScan("hall", fields, "", 501);
  expect(lying.file(), "scan 1 ('hall'): it is said to have 501 points, its packets "
                       "hold 'cartesianX' of 500");
  E57Writer modest;
  modest.addScan("hall", fields, "", 400);
  expect(modest.file(), "scan 1 ('hall'): it is said to have 400 points, its packets "
                        "hold 'cartesianX' of 500");
  E57Writer floats;
  const std::vector<float> values(500, 1);
  floats.addScan("",
                 {E57TestField::ofFloats("cartesianX", values),
                  E57TestField::ofFloats("cartesianY", values),
                  E57TestField::ofFloats("cartesianZ", values)},
                 "", 499);
  expect(floats.file(),
         "said to have 499 points, its packets hold 'cartesianX' of 500");
  E57Writer bodiless;
  std::vector<E57TestField> constant;
  for (const char* name : {"cartesianX", "cartesianY", "cartesianZ"})
    constant.push_back(E57TestField::ofIntegers(name, {1}, 1, 1));
  bodiless.addScan("", constant, "", 0x7fffffff);
  expect(bodiless.file(),
         "all of its 2147483647 points are one and the same, the whole "
         "file has 8160 bits");
  E57Writer constants;
  constants.addScan("", constant, "", 3000);
  EXPECT_EQ(load(constants).size(), 3000u);
  E57Writer huge;
  huge.addScan("", fields, "", 1ll << 60);
  expect(huge.file(), "scan 1: it is said to have 1152921504606846976 points");
  E57Writer blind;
  blind.addScan("", {fields[0], fields[1]});
  expect(blind.file(), "neither cartesian nor spherical");
  E57Writer negative;
  auto shrunk = fields;
  shrunk[1].attributes =
      "type=\"ScaledInteger\" minimum=\"0\" maximum=\"9\" scale=\"-1\"";
  negative.addScan("", shrunk);
  expect(negative.file(), "the scale of 'cartesianY' is -1.0");
  E57Writer turned;
  turned.addScan("", fields, E57Writer::pose(1, 1, 0, 0, 0, 0, 0));
  expect(turned.file(), "quaternion of its pose has the length 1.41");
  E57Writer empty;
  expect(empty.file(), "it holds no scan");
  E57Writer pointless;
  auto none = fields;
  for (auto& field : none)
    field.stored.clear();
  pointless.addScan("", none);
  expect(pointless.file(), "has 0 points");
  ScanSettings third;
  third.scan = 3;
  EXPECT_NE(refusal(good, third).find("has no scan 3, it holds 1"), std::string::npos);
}

TEST_F(E57Files, XmlThatWouldGrowOrGoTooDeepIsRefused)
{
  E57Writer writer;
  std::string deep;
  for (int k = 0; k < 100000; ++k)
    deep += "<a>";
  EXPECT_NE(refusal(writer.fileWith(deep)).find("deeper than 64"), std::string::npos);
  EXPECT_NE(refusal(writer.fileWith("<!DOCTYPE x [<!ENTITY a \"aaaa\">]><e57Root/>"))
                .find("document type"),
            std::string::npos);
  std::string wide = "<e57Root>";
  for (int k = 0; k < 150000; ++k) // hundreds of bytes of memory each
    wide += "<a b=''/>";
  EXPECT_NE(refusal(writer.fileWith(wide + "</e57Root>"))
                .find("300001 elements and attributes"),
            std::string::npos);
  const std::string signs(300000, '='); // are neither in a text
  EXPECT_EQ(
      shapeOf("<a b='=' c = '<'><![CDATA[" + signs + "]]>" + signs + "</a>", 9).parts,
      3u);
  EXPECT_NE(refusal(writer.fileWith("<!doctype x><e57Root/>")).find("document type"),
            std::string::npos);
  EXPECT_FALSE(shapeOf("<!-- <!DOCTYPE x> --><a><![CDATA[<!DOCTYPE y>]]></a>", 9)
                   .has_document_type);
  EXPECT_NE(refusal(writer.fileWith("<e57Root><data3D></e57Root>")).find("XML"),
            std::string::npos);
  EXPECT_EQ(shapeOf("<a><!-- <b><c> --><b x='>'/><![CDATA[<d><d>]]></a>", 9).nesting,
            2u);
  EXPECT_EQ(shapeOf("<", 9).nesting, 1u);
  // As rapidxml reads them: quotes in names, in closing tags and in declarations.
  EXPECT_EQ(shapeOf("<a\"><b'><c=\">", 9).nesting, 3u);
  EXPECT_EQ(shapeOf("<a></a\"><b><c>", 9).nesting, 2u);
  EXPECT_EQ(shapeOf("<!x '><a><b>", 9).nesting, 2u);
  EXPECT_EQ(shapeOf("<a b\"=\"x\"><c>", 9).nesting, 2u);
  EXPECT_EQ(shapeOf("<a b = '<c>'/><d e=\"'\"><f>", 9).nesting, 2u);
}

TEST_F(E57Files, OneBrokenScanOfSeveralIsNamedOrLeftOut)
{
  const auto fields = integerFields(wholeCoordinates(3000, 5000), 5000);
  E57Writer writer;
  writer.addScan("kitchen", fields);
  writer.addScan("cellar", fields, "", 4000);
  writer.addScan("attic", fields);
  EXPECT_NE(refusal(writer.file()).find("scan 2 ('cellar')"), std::string::npos);
  ScanSettings settings;
  settings.skip_broken = true;
  EXPECT_EQ(load(writer, settings).size(), 6000u);
  // Damaged points are detected before they are returned.
  std::string bytes = writer.file();
  bytes[3000] = static_cast<char>(bytes[3000] ^ 1);
  EXPECT_EQ(loadCloud(write(bytes), settings).size(), 3000u);
}

/** Valid files with changed bytes, with or without correct checksums, or truncated,
 * must be read or rejected. */
TEST_F(E57Files, ChangedBytesAreReadOrRefused)
{
  E57Writer writer;
  writer.packet_bytes = 300;
  writer.has_index = true;
  writer.addScan("a", integerFields(wholeCoordinates(300, 500), 500),
                 E57Writer::pose(1, 0, 0, 0, 1, 2, 3));
  writer.addScan("b", {E57TestField::ofDoubles("sphericalRange", {1, 2, 3}),
                       E57TestField::ofDoubles("sphericalAzimuth", {1, 2, 3}),
                       E57TestField::ofFloats("sphericalElevation", {0, 0, 1})});
  const std::string good = writer.file();
  std::mt19937 random(1);
  std::size_t refused = 0;
  constexpr std::size_t trials = 4000;
  for (std::size_t trial = 0; trial < trials; ++trial) {
    std::string bytes = good;
    for (std::size_t k = 0; k <= trial % 4; ++k) {
      const std::size_t at = random() % (trial % 3 == 0 ? 200 : bytes.size());
      bytes[at] = static_cast<char>(trial % 5 == 0 ? 0xff : random());
    }
    if (trial % 8 != 0) { // correct checksums reach more code
      std::string sealed;
      for (std::size_t p = 0; p + E57Writer::page <= bytes.size(); p += E57Writer::page)
        sealed += E57Writer::sealed(bytes.substr(p, E57Writer::payload));
      bytes = sealed;
    }
    if (trial % 50 == 0)
      bytes.resize(random() % bytes.size() + 1);
    try {
      ScanSettings settings;
      settings.skip_broken = trial % 16 == 1;
      loadCloud(write(bytes), settings);
    }
    catch (const ToolError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, trials / 8);
  EXPECT_LT(refused, trials);
}

} // namespace
