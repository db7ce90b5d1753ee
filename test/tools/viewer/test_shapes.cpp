// SPDX-License-Identifier: BSD-3-Clause
#include "scan_file.h"
#include "tool_error.h"
#include "tools/in_folder.h"
#include "tools/sample_result.h"
#include "viewer/shapes.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <set>

namespace {

using namespace programs;
using namespace pcl::sedr;
using namespace pcl::sedr::tools;

/** The sample after writing and reading. */
class ViewedSample : public InFolder<> {
protected:
  void SetUp() override
  {
    sample_.writeTo(folder_.path() / "model");
    result_ = pcl::sedr::tools::readResult((folder_.path() / "model").string(), {});
  }

  SampleResult sample_;
  pcl::sedr::tools::ViewedResult result_;
};

Colour
colourAt(vtkPolyData* shape, vtkIdType i)
{
  double rgb[3];
  shape->GetPointData()->GetScalars()->GetTuple(i, rgb);
  return static_cast<Colour>(rgb[0] * 65536 + rgb[1] * 256 + rgb[2]);
}

std::set<std::string>
coloursIn(vtkPolyData* shape)
{
  std::set<std::string> found;
  for (vtkIdType i = 0; i < shape->GetNumberOfPoints(); ++i)
    found.insert(hexCode(colourAt(shape, i)));
  return found;
}

double
highest(vtkPolyData* shape)
{
  return shape->GetBounds()[5];
}

TEST_F(ViewedSample, ColoursPointsByLabelRoomAndDistance)
{
  const Shapes shapes(result_);
  ViewState state;
  state.ceilings = true;
  EXPECT_EQ(coloursIn(shapes.of("structure", state)),
            (std::set<std::string>{hexCode(colours::ceiling), hexCode(colours::floor),
                                   hexCode(colours::wall)}));
  state.colour = "room";
  EXPECT_EQ(coloursIn(shapes.of("structure", state)),
            (std::set<std::string>{hexCode(roomColour(1)), hexCode(roomColour(2))}));
  // Points are within 2 mm of the model; the table top is 0.75 m above the floor.
  state.colour = "distance";
  EXPECT_EQ(coloursIn(shapes.of("structure", state))
                .count(hexCode(distanceColour(1, state.range))),
            0u);
  EXPECT_EQ(coloursIn(shapes.of("scan", state))
                .count(hexCode(distanceColour(1, state.range))),
            1u)
      << "furniture is red";
}

TEST_F(ViewedSample, OneRoomAloneIsShownInAllLayers)
{
  const Shapes shapes(result_);
  ViewState state;
  state.room = 2;
  const double first = result_.rules.boxOf(2).min().x();
  for (const std::string& layer : layer_names)
    EXPECT_GE(shapes.of(layer, state)->GetBounds()[0], first - 0.16) << layer;
}

TEST_F(ViewedSample, LegendTellsAreasAndColours)
{
  const Shapes shapes(result_);
  ViewState state;
  state.layers = {"structure"};
  const auto has = [&](const std::string& text, std::optional<Colour> colour) {
    const auto lines = shapes.legend(state);
    return std::any_of(lines.begin(), lines.end(), [&](const LegendLine& line) {
      return line.text.find(text) != std::string::npos && line.colour == colour;
    });
  };
  EXPECT_TRUE(has("ceiling", colours::ceiling));
  EXPECT_TRUE(has("room 1  12.0 m2", std::nullopt));
  EXPECT_TRUE(has("without ceilings", std::nullopt));
  state.clip_height = 1.25;
  EXPECT_TRUE(has("cut at 1.25 m", std::nullopt));
  state.colour = "room";
  EXPECT_TRUE(has("room 2  10.5 m2", roomColour(2)));
  state.colour = "distance";
  EXPECT_TRUE(has("5 cm or more", distanceColour(0.05, 0.05)));
}

TEST(PlanRules, OfTwoStoreysTellWhichAPlaceBelongsTo)
{
  Floorplan plan;
  for (std::uint32_t id = 1; id <= 2; ++id) {
    plan.rooms.push_back(planOf(BoxRoom()));
    plan.rooms.back().id = id;
    plan.rooms.back().floor.plane[3] -= 2.8 * (id - 1);
    plan.rooms.back().ceiling.plane[3] -= 2.8 * (id - 1);
  }
  const PlanRules rules(plan);
  ASSERT_EQ(rules.storeys().size(), 2u);
  const Eigen::Vector3d middle = rules.boxOf(1).center();
  EXPECT_TRUE(rules.isInStorey(1, 0, 1));
  EXPECT_FALSE(rules.isInStorey(2, 0, 1));
  EXPECT_TRUE(rules.isInStorey(2, 2, 1)) << "a known room decides";
  EXPECT_FALSE(rules.isCeiling(StructureLabel::Other, 0, middle));
  EXPECT_TRUE(rules.isCeiling(StructureLabel::Other, 0, {middle.x(), middle.y(), 2.45}))
      << "the lower ceiling";
  EXPECT_FALSE(rules.isCeiling(StructureLabel::Other, 0, {middle.x(), middle.y(), 2.8}))
      << "the upper floor";
  EXPECT_TRUE(rules.isCeiling(StructureLabel::Detail, 1, {middle.x(), middle.y(), 2.2}))
      << "a soffit";
  EXPECT_FALSE(
      rules.isCeiling(StructureLabel::Detail, 1, {middle.x(), middle.y(), 0.2}))
      << "a step";
}

TEST_F(ViewedSample, ShowsOpeningsByKindAndTheFootOfALeaf)
{
  EXPECT_FALSE(result_.has("openings"));
  result_.plan.openings = {{OpeningKind::Door, {1, 2}, {}, {1, 2}, {1, 3}, 0, 2}};
  EXPECT_TRUE(result_.has("openings"));
  const Shapes shapes(result_);
  ViewState state;
  state.layers = {"openings"};
  auto shape = shapes.of("openings", state);
  EXPECT_EQ(coloursIn(shape), std::set<std::string>{hexCode(colours::detail)});
  EXPECT_DOUBLE_EQ(highest(shape), 2);
  EXPECT_DOUBLE_EQ(shape->GetBounds()[0], shape->GetBounds()[1]) << "in its wall";
  result_.plan.openings[0].hinge = OpeningHinge::Start;
  result_.plan.openings[0].swing = 2; // to the right of the direction
  EXPECT_DOUBLE_EQ(shapes.of("openings", state)->GetBounds()[1], 2);
  const auto isInLegend = [&] {
    const auto legend = shapes.legend(state);
    return std::any_of(legend.begin(), legend.end(),
                       [](const LegendLine& line) { return line.text == "door: 1"; });
  };
  EXPECT_TRUE(isInLegend());
  state.room = 7;
  EXPECT_FALSE(isInLegend());
  EXPECT_EQ(shapes.of("openings", state)->GetNumberOfPoints(), 0);
}

/** Returns the layers of a file or folder of the sample. */
std::vector<std::string>
layersOf(const std::filesystem::path& path)
{
  const ViewedResult result = readResult(path.string(), {});
  std::vector<std::string> layers;
  for (const std::string& layer : layer_names)
    if (result.has(layer))
      layers.push_back(layer);
  return layers;
}

using Layers = std::vector<std::string>;

TEST_F(ViewedSample, IsReadWithAllItsLayers)
{
  for (const auto& layer : layer_names)
    EXPECT_EQ(result_.has(layer), layer != "openings") << layer;
  EXPECT_EQ(result_.clouds.at("scan").size(), sample_.scan.points.size());
  EXPECT_TRUE(result_.clouds.at("scan").labels.empty());
  EXPECT_TRUE(result_.notes.empty());
  EXPECT_NEAR(result_.bounds().max().z(), 2.5, 1e-6);
}

TEST_F(ViewedSample, IsReadInPartWhereFilesAreMissing)
{
  const auto model = folder_.path() / "model";
  for (const char* name : {"mesh.ply", "solid.ply", "structure.pcd"})
    std::filesystem::remove(model / name);
  std::filesystem::remove(folder_.path() / "scan.pcd");
  EXPECT_EQ(layersOf(model), Layers{"plan"});
  const ViewedResult rest = readResult(model.string(), {});
  EXPECT_EQ(rest.notes.size(), 1u) << "the scan";
  EXPECT_NEAR(rest.bounds().max().z(), 2.5, 1e-6);
  for (const char* name : {"floorplan.json", "report.json"})
    std::filesystem::remove(model / name);
  EXPECT_THROW(readResult(model.string(), {}), ToolError);
}

TEST_F(ViewedSample, OfOneFileIsWhatItHolds)
{
  const auto model = folder_.path() / "model";
  EXPECT_EQ(layersOf(model / "floorplan.json"), Layers{"plan"});
  EXPECT_EQ(layersOf(model / "mesh.ply"), Layers{"mesh"});
  EXPECT_EQ(layersOf(model / "solid.ply"), Layers{"solid"});
  EXPECT_EQ(layersOf(model / "structure.pcd"), Layers{"structure"});
  EXPECT_EQ(layersOf(folder_.path() / "scan.pcd"), Layers{"scan"});
  EXPECT_THROW(readResult((model / "report.json").string(), {}), ToolError);
  const auto text = folder_.path() / "scan.csv";
  std::ofstream(text) << "1,2,3\n4,5,6\n";
  EXPECT_EQ(readResult(text.string(), {}).bounds().max(), Eigen::Vector3d(4, 5, 6));
}

/** A point at 1e6 m would reduce the room to a dot. */
TEST_F(ViewedSample, OfAScanWithAStrayPointTheRoomFillsTheView)
{
  std::vector<std::vector<float>> points;
  for (int k = 0; k < 2000; ++k)
    points.push_back({0.1F * static_cast<float>(k % 50),
                      0.1F * static_cast<float>(k / 50), k % 2 == 0 ? 0 : 2.5F});
  points.push_back({20, 2, 1}); // seen through a window
  points.push_back({1e6F, 3e38F, -1e6F});
  const auto path = folder_.path() / "stray.pcd";
  writeFile(path, pcdBytes(points, std::vector<std::uint32_t>(2002, 3)));
  const DisplayCloud shown = readResult(path.string(), {}).clouds.at("structure");
  EXPECT_EQ(shown.whole_size, 2002u);
  EXPECT_EQ(shown.size(), 2001u);
  EXPECT_EQ(shown.labels.size(), 2001u);
  writeFile(path, pcdBytes(points));
  EXPECT_NEAR(readResult(path.string(), {}).bounds().max().x(), 20, 1e-6);
}

} // namespace
