// SPDX-License-Identifier: BSD-3-Clause
#include "viewed_sample.h"
#include "viewer/shapes.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <set>

namespace {

using namespace programs;
using namespace pcl::sedr;
using namespace pcl::sedr::tools;

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

} // namespace
