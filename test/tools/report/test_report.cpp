// SPDX-License-Identifier: BSD-3-Clause
#include "canvas.h"
#include "report/model/mesh_reduction.h"
#include "report/model/model_pictures.h"
#include "report/page/advice.h"
#include "report/page/histogram_svg.h"
#include "report/page/html_text.h"
#include "report/page/page_sections.h"
#include "tool_error.h"
#include "tools/run_program.h"
#include "tools/sample_files.h"
#include "tools/sample_result.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace programs;
using namespace pcl::sedr;
using namespace pcl::sedr::tools;

TEST(HtmlText, EscapesWhatHtmlWouldRead)
{
  EXPECT_EQ(escaped("a < b & \"c\" > 'd'"),
            "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
  EXPECT_EQ(escaped("m\xc2\xb2"), "m\xc2\xb2") << "UTF-8 stays";
  EXPECT_EQ(escaped("\xff!"), "\xef\xbf\xbd!") << "what is none becomes U+FFFD";
  EXPECT_EQ(escaped(std::string("a\0b\x1b", 4)), "a\xef\xbf\xbd"
                                                 "b\xef\xbf\xbd");
}

TEST(HtmlText, Base64AsInRfc4648)
{
  const std::vector<std::pair<std::string, std::string>> vectors{
      {"", ""},
      {"f", "Zg=="},
      {"fo", "Zm8="},
      {"foo", "Zm9v"},
      {"foob", "Zm9vYg=="},
      {"fooba", "Zm9vYmE="},
      {"foobar", "Zm9vYmFy"},
      {std::string("\xfb\xff\0", 3), "+/8A"}};
  for (const auto& [plain, coded] : vectors)
    EXPECT_EQ(base64(plain), coded);
}

TEST(HtmlText, NumbersHaveTheirThousandsApart)
{
  const std::string space = "\xe2\x80\xaf";
  EXPECT_EQ(numberText(0, 0), "0");
  EXPECT_EQ(numberText(999.994, 2), "999.99");
  EXPECT_EQ(numberText(1234567.5, 1), "1" + space + "234" + space + "567.5");
  EXPECT_EQ(numberText(-1000, 0), "-1" + space + "000");
  EXPECT_EQ(percentText(0.5), "50&nbsp;%");
  EXPECT_EQ(percentText(0.0123), "1.2&nbsp;%");
  EXPECT_EQ(percentText(0), "0&nbsp;%");
  EXPECT_EQ(percentText(1), "100&nbsp;%");
}

/** A result folder with this report.json. */
class ReportFacts : public ::testing::Test {
protected:
  ReportData read(const std::string& json)
  {
    writeFile((folder_.path() / "report.json").string(), json);
    return readReportData(ResultFolder(folder_.path().string()));
  }

  TemporaryFolder folder_;
};

TEST_F(ReportFacts, OfAnotherTypeCountAsNotThere)
{
  const ReportData data = read(
      R"({"format": "sedr-report", "input": 7, "stages": "none", "warnings": [3, "w"],
          "rooms": [{"id": 4, "area": "large", "mesh": [], "solid": {"wall_area": 2.5}}],
          "parameters": {"seed": 1}, "evaluation": {"cloud_to_mesh": {"count": -5}}})");
  EXPECT_EQ(data.scan, "");
  EXPECT_TRUE(data.stages.empty() || data.stages[0].name.empty());
  EXPECT_EQ(data.warnings, std::vector<std::string>{"w"});
  ASSERT_EQ(data.rooms.size(), 1u);
  EXPECT_EQ(data.rooms[0].id, 4u);
  EXPECT_EQ(data.rooms[0].area, 0);
  EXPECT_EQ(*data.rooms[0].wall_area, 2.5);
  EXPECT_FALSE(data.rooms[0].mesh_closed.has_value());
  EXPECT_FALSE(data.distances.has_value());
  EXPECT_THROW(read("[]"), ToolError);
  EXPECT_THROW(read("{"), ToolError);
  EXPECT_THROW(read(R"({"format": 3})"), ToolError);
}

TEST_F(ReportFacts, OfRoomsComeFromThePlanWhereTheReportHasNone)
{
  const SampleResult sample;
  writeFile((folder_.path() / "floorplan.json").string(),
            pcl::sedr::floorplanToJson(sample.plan));
  const ReportData data = read(R"({"format": "sedr-report"})");
  ASSERT_EQ(data.rooms.size(), 2u);
  EXPECT_NEAR(data.area(), 12 + 10.5, 1e-9);
  EXPECT_NEAR(data.volume(), 2.5 * 22.5, 1e-3);
  EXPECT_NEAR(data.rooms[0].perimeter, 14, 1e-9);
}

TEST(Advice, NamesUnseenWallsRepairsAndFarPoints)
{
  ReportData data;
  EXPECT_TRUE(adviceOn(data).empty());
  data.rooms.resize(1);
  data.rooms[0].id = 3;
  data.rooms[0].repaired_share = 0.24;
  EXPECT_TRUE(adviceOn(data).empty());
  data.rooms[0].repaired_share = 0.5;
  PlanRoom room = planOf(BoxRoom());
  room.id = 3;
  for (auto& wall : room.boundary.elements)
    wall.evidence = {0.9, 0.05, 0.05};
  room.boundary.elements[1].evidence = {0.1, 0.8, 0.1};
  room.boundary.elements[2].evidence = {0.1, 0.1, 0.8}; // a window front
  data.plan.rooms.push_back(room);
  data.distances = summarizeDistances(std::vector<double>(100, 0.03));
  data.warnings = {"room 3: 50 % of its surface were filled in, not seen: its walls",
                   "the scan is too sparse for cells of 0.05 m"};
  const auto advices = adviceOn(data);
  ASSERT_EQ(advices.size(), 4u)
      << "the run's own sentence of the share is not repeated";
  EXPECT_NE(advices[0].finding.find("filled in: room 3 50 %."), std::string::npos);
  EXPECT_EQ(advices[1].finding,
            "Walls of which hardly anything was seen: room 3: wall 2 "
            "(3.0 m, 80 % hidden).");
  EXPECT_NE(advices[2].finding.find("more than 3 cm"), std::string::npos);
  EXPECT_NE(advices[2].remedy.find("--plane-tolerance"), std::string::npos);
  EXPECT_NE(advices[3].remedy.find("--fixed-grid"), std::string::npos);
}

TEST(Advice, AsksForNoToleranceThatTheRunHad)
{
  ReportData data;
  data.distances = summarizeDistances(std::vector<double>(100, 0.03));
  data.parameters = {{"plane_tolerance", "0.1"}, {"boundary_tolerance", "0.05"}};
  const auto remedy = [&] { return adviceOn(data).at(0).remedy; };
  EXPECT_EQ(remedy().find("--plane-tolerance"), std::string::npos) << remedy();
  EXPECT_NE(remedy().find("--boundary-tolerance 0.1"), std::string::npos) << remedy();
  data.parameters[1].second = "0.2";
  EXPECT_EQ(remedy().find("-tolerance"), std::string::npos) << remedy();
}

TEST(Advice, KnowsWhatIsNotKnown)
{
  ReportData data;
  EXPECT_EQ(unknownOf(data),
            "whether all rooms are closed, how much of their surface was "
            "seen, how far the points lie from the model");
  const auto words = [&] { return advicePart(data); };
  EXPECT_EQ(words().find("class=\"fine\""), std::string::npos);
  data.rooms.resize(2);
  for (auto& room : data.rooms) {
    room.solid_closed = true;
    room.repaired_share = 0.1;
  }
  EXPECT_EQ(unknownOf(data), "how far the points lie from the model")
      << "as of a run without a mesh";
  EXPECT_NE(words().find("do not tell how far the points lie"), std::string::npos);
  data.distances = summarizeDistances(std::vector<double>(100, 0.001));
  EXPECT_EQ(unknownOf(data), "");
  EXPECT_NE(words().find("class=\"fine\""), std::string::npos);
}

TEST(HistogramSvg, IsEmptyWithoutAHistogram)
{
  EXPECT_EQ(histogramSvg({}, 0.05), "");
  EXPECT_EQ(histogramSvg(summarizeDistances({}), 0.05), "");
}

TEST(Canvas, ShowsWhatIsNearest)
{
  constexpr Colour red{200, 0, 0};
  constexpr Colour blue{0, 0, 200};
  Canvas image(10, 10, 2);
  image.fillSquare({5, 5, 1}, 4, red);
  image.fillTriangle({{{0, 0, 2}, {10, 0, 2}, {0, 10, 2}}}, blue);
  image.fillSquare({-25, 2.5, 0}, 1.5, red); // outside the image
  const Image seen = image.image();
  EXPECT_EQ(seen.width, 10);
  EXPECT_EQ(seen.at(5, 5), red) << "before the triangle, though drawn first";
  EXPECT_EQ(seen.at(1, 1), blue);
  EXPECT_EQ(seen.at(9, 9), colours::paper);
}

TEST(Canvas, DarkensWhatLiesBehindItsNeighbour)
{
  constexpr Colour grey{200, 200, 200};
  Canvas image(20, 10, 2);
  image.fillTriangle({{{0, 0, 0}, {10, 0, 0}, {0, 20, 0}}}, grey);
  image.fillTriangle({{{0, 0, 50}, {40, 0, 50}, {0, 40, 50}}}, grey);
  image.shadeDepth();
  const Image seen = image.image();
  EXPECT_EQ(seen.at(2, 2), grey) << "in front";
  EXPECT_LT(seen.at(9, 2).red, 150) << "just behind the edge";
  EXPECT_EQ(seen.at(17, 2), grey) << "far from it";
}

TEST(ParallelView, FillsTheImageAndLooksDown)
{
  std::vector<Eigen::Vector3d> corners;
  for (int k = 0; k < 8; ++k)
    corners.emplace_back(4 * (k & 1), (k & 2) != 0 ? 2 : 0, (k & 4) != 0 ? 1 : 0);
  const ParallelView view(corners, -90, 90, 400);
  EXPECT_NEAR(view.scale(), 96, 1e-9) << "4 m in 96 % of the width";
  EXPECT_EQ(view.height(), 2 * 96 + 16);
  EXPECT_TRUE(view.see({2, 1, 0}).isApprox(Eigen::Vector3d(200, 104, 0)));
  EXPECT_NEAR(view.see({4, 1, 0}).x(), 392, 1e-9) << "x to the right";
  EXPECT_NEAR(view.see({2, 2, 0}).y(), 8, 1e-9) << "y up";
  EXPECT_LT(view.see({2, 1, 1}).z(), view.see({2, 1, 0}).z()) << "the top is nearer";
  EXPECT_TRUE(view.faces({0, 0, 1}));
  EXPECT_FALSE(view.faces({0, 0, -1}));
}

/** Two square plates of n by n squares of 1 cm at a right angle with a common edge. */
TriangleMesh
angle(int n)
{
  TriangleMesh mesh;
  for (int part = 0; part < 2; ++part) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto row = static_cast<std::uint32_t>(n + 1);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        mesh.vertices.emplace_back(part == 0 ? 0.01 * i : 0, 0.01 * j,
                                   part == 0 ? 0 : 0.01 * i);
    for (std::uint32_t i = 0; i + 1 < row; ++i)
      for (std::uint32_t j = 0; j + 1 < row; ++j) {
        const std::uint32_t a = first + i * row + j;
        mesh.triangles.push_back({a, a + row, a + 1});
        mesh.triangles.push_back({a + 1, a + row, a + row + 1});
        mesh.labels.insert(mesh.labels.end(), 2, part == 0 ? 2u : 3u);
      }
  }
  return mesh;
}

TEST(ReducedMesh, KeepsPlanesEdgesAndLabels)
{
  TriangleMesh mesh = angle(100);
  std::map<std::array<double, 3>, std::uint32_t> known; // merges vertices
  for (auto& triangle : mesh.triangles)
    for (auto& v : triangle) {
      const auto& p = mesh.vertices[v];
      v = known.emplace(std::array<double, 3>{p.x(), p.y(), p.z()}, v).first->second;
    }
  mesh.removeUnusedVertices();
  const TriangleMesh reduced = reducedMesh(mesh, 2000);
  EXPECT_EQ(reduced.problem(), "");
  EXPECT_LE(reduced.triangles.size(), 2000u);
  EXPECT_GT(reduced.triangles.size(), 500u);
  std::size_t on_edge = 0;
  for (const auto& p : reduced.vertices) {
    EXPECT_TRUE(p.x() == 0 || p.z() == 0) << "on one of the plates";
    on_edge += p.x() == 0 && p.z() == 0 ? 1 : 0;
  }
  EXPECT_GT(on_edge, 10u);
  for (std::size_t t = 0; t < reduced.triangles.size(); ++t) {
    const Eigen::Vector3d normal = reduced.scaledNormal(t).normalized();
    const bool is_floor = reduced.labels[t] == 2;
    EXPECT_GT(std::abs(is_floor ? normal.z() : normal.x()), 0.999);
  }
  EXPECT_EQ(reducedMesh(mesh, 1000000).triangles.size(), mesh.triangles.size());
}

/** The sample, and the same rooms 2.8 m higher as rooms 3 and 4. */
Floorplan
twoStoreys()
{
  Floorplan plan = SampleResult().plan;
  for (PlanRoom room : SampleResult().plan.rooms) {
    room.id += 2;
    room.floor.plane[3] -= 2.8;
    room.ceiling.plane[3] -= 2.8;
    plan.rooms.push_back(room);
  }
  plan.storeys = {{1, "ground floor", 0, 0, {1, 2}}, {2, "<attic>", 0, 0, {3, 4}}};
  return plan;
}

std::size_t
countOf(const std::string& part, const std::string& text)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST_F(ReportFacts, OfStoreysAreToldAStoreyAtATime)
{
  writeFile((folder_.path() / "floorplan.json").string(),
            pcl::sedr::floorplanToJson(twoStoreys()));
  const ReportData data = read(R"({"format": "sedr-report"})");
  ASSERT_EQ(data.storeys.size(), 2u);
  const std::string storeys = storeysPart(data);
  EXPECT_EQ(countOf("<tr>", storeys), 3u) << storeys;
  EXPECT_NE(storeys.find("&lt;attic&gt;"), std::string::npos);
  EXPECT_NE(storeys.find("22.50"), std::string::npos) << "the area of one";
  EXPECT_EQ(countOf("<svg", planPart(data)), 2u);
  const std::string rooms = roomsPart(data);
  EXPECT_EQ(countOf("<table", rooms), 2u);
  EXPECT_LT(rooms.find("ground floor"), rooms.find("&lt;attic&gt;"));
  EXPECT_NE(figuresPart(data).find("storeys</dt><dd>2"), std::string::npos);
}

TEST_F(ReportFacts, OfTiltedWallsAreOnThePlan)
{
  const Floorplan plan = twoStoreys();
  const WallTilts tilts{{plan.rooms[0].id, 0, 10 * M_PI / 180}};
  writeFile((folder_.path() / "floorplan.json").string(),
            withTilts(floorplanToJson(plan), tilts, {}));
  EXPECT_NE(planPart(read(R"({"format": "sedr-report"})")).find("tilt 10.0"),
            std::string::npos);
}

TEST_F(ReportFacts, OfTheCoverageAreASection)
{
  const std::string report = R"({"format": "sedr-report", "coverage": {
      "seen": 60.5, "modelled": 12.1, "share": 0.2, "left_out": [
        {"reason": "room 3: <no> plan", "area": 48.4, "floor": -0.5, "ceiling": 2.5,
         "at": [10, -2.25], "counts": true},
        {"reason": "outdoors", "area": 3, "at": 7, "counts": false}]}})";
  const std::string part = coveragePart(read(report));
  EXPECT_NE(part.find("12.1&nbsp;m² of 60.5&nbsp;m²"), std::string::npos) << part;
  EXPECT_NE(part.find("20&nbsp;%"), std::string::npos);
  EXPECT_NE(part.find("room 3: &lt;no&gt; plan"), std::string::npos);
  EXPECT_NE(part.find("−0.5 to 2.5"), std::string::npos);
  EXPECT_EQ(countOf("<tr>", part), 3u);
  EXPECT_EQ(coveragePart(read(R"({"format": "sedr-report"})")), "") << "not told";
}

TEST_F(ReportFacts, OfFilesLinkThoseThatAreThere)
{
  const auto path = [&](const char* name) { return (folder_.path() / name).string(); };
  writeFile(path("floorplan.json"), pcl::sedr::floorplanToJson(twoStoreys()));
  for (const char* name : {"model.ifc", "floorplan_2.dxf", "other.txt"})
    writeFile(path(name), "");
  const ReportData data = read(R"({"format": "sedr-report"})");
  const std::string part =
      deliverablesPart(ResultFolder(folder_.path().string()), data);
  EXPECT_NE(part.find("<a href=\"model.ifc\">model.ifc</a>"), std::string::npos)
      << part;
  EXPECT_NE(part.find("<a href=\"floorplan_2.dxf\">"), std::string::npos);
  EXPECT_EQ(countOf("<a href", part), 4u) << "with both files of JSON";
  EXPECT_EQ(countOf("model.glb", part), 0u);
}

TEST_F(ReportFacts, OfOneStoreyAreToldAsEver)
{
  writeFile((folder_.path() / "floorplan.json").string(),
            pcl::sedr::floorplanToJson(SampleResult().plan));
  const ReportData data = read(R"({"format": "sedr-report"})");
  EXPECT_EQ(storeysPart(data), "");
  EXPECT_EQ(countOf("<svg", planPart(data)), 1u);
  EXPECT_EQ(countOf("<table", roomsPart(data)), 1u);
  EXPECT_EQ(countOf("<h3>", roomsPart(data) + planPart(data)), 0u);
}

} // namespace
