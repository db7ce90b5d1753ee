// SPDX-License-Identifier: BSD-3-Clause
#include "results/distance_colour.h"
#include "tools/pictures/pictures.h"
#include "viewed_sample.h"
#include "viewer/camera.h"
#include "viewer/legend.h"
#include "viewer/point_report.h"

#include <algorithm>
#include <set>

namespace {

using namespace programs;
using namespace pcl::sedr;

std::uint32_t
numberOf(Colour c)
{
  return std::uint32_t{c.red} << 16 | std::uint32_t{c.green} << 8 | c.blue;
}

std::set<std::uint32_t>
coloursIn(const ColouredPoints& shown)
{
  std::set<std::uint32_t> found;
  for (const auto c : shown.colours)
    found.insert(numberOf(c));
  return found;
}

TEST_F(ViewedSample, ColoursPointsByLabelRoomAndDistance)
{
  const Painter painter(result_);
  ViewState state;
  std::set<std::uint32_t> labels;
  for (const auto label :
       {StructureLabel::Ceiling, StructureLabel::Floor, StructureLabel::Wall})
    labels.insert(numberOf(colourOf(label)));
  EXPECT_EQ(coloursIn(painter.points(Layer::Structure, state)), labels);
  state.colouring = Colouring::Room;
  const std::set<std::uint32_t> rooms{numberOf(roomColour(1)), numberOf(roomColour(2))};
  EXPECT_EQ(coloursIn(painter.points(Layer::Structure, state)), rooms);
  // Points are within 2 mm of the model; the table top is 0.75 m above the floor.
  for (const double d : painter.distances(Layer::Structure))
    EXPECT_LE(d, 0.0021);
  const auto& raw = painter.distances(Layer::Raw);
  EXPECT_NEAR(*std::max_element(raw.begin(), raw.end()), 0.75, 0.0021);
  state.colouring = Colouring::Distance;
  EXPECT_EQ(coloursIn(painter.points(Layer::Raw, state))
                .count(numberOf(distanceColour(1, painter.range()))),
            1u)
      << "furniture is red";
}

TEST_F(ViewedSample, FarOutsideTheDistanceIsThatFromTheBox)
{
  const Eigen::Vector3f corner = result_.mesh.bounds().min().cast<float>();
  result_.raw.points = {corner - Eigen::Vector3f(3, 0, 0),
                        corner - Eigen::Vector3f(0.5F, 0, 0)};
  const Painter painter(result_);
  EXPECT_NEAR(painter.distances(Layer::Raw)[0], 3, 1e-5);
  EXPECT_NEAR(painter.distances(Layer::Raw)[1], 0.5, 1e-5);
}

TEST_F(ViewedSample, WithoutCeilingsShowsAllButThem)
{
  const Painter painter(result_);
  ViewState state;
  state.ceiling = false;
  const auto highest = [](const ColouredPoints& shown) {
    float most = -100;
    for (const auto& p : shown.points)
      most = std::max(most, p.z());
    return most;
  };
  EXPECT_NEAR(highest(painter.points(Layer::Structure, state)), 2.475, 0.003)
      << "the top row of wall points, which stay";
  EXPECT_LE(highest(painter.points(Layer::Raw, state)), 2.36)
      << "without labels, what is 15 cm below the plan's ceiling";
  EXPECT_GE(highest(painter.points(Layer::Raw, state)), 2.3);
  for (const auto layer : {Layer::Mesh, Layer::Solid}) {
    const TriangleMesh& mesh = *result_.meshOf(layer);
    const auto ceilings =
        std::count(mesh.labels.begin(), mesh.labels.end(),
                   static_cast<std::uint32_t>(StructureLabel::Ceiling));
    EXPECT_EQ(painter.triangles(layer, ViewState()).points.size(),
              3 * mesh.triangles.size());
    EXPECT_EQ(painter.triangles(layer, state).points.size() / 3,
              mesh.triangles.size() - static_cast<std::size_t>(ceilings));
  }
}

TEST_F(ViewedSample, DrawsPlanLinesAndSolidEdges)
{
  const Painter painter(result_);
  ViewState state;
  // A box has four lower, four upper and four vertical edges.
  EXPECT_EQ(painter.planLines(state).points.size() / 2, 2u * 12);
  EXPECT_EQ(painter.solidEdges(state).points.size() / 2, 2u * 12);
  state.ceiling = false;
  EXPECT_EQ(painter.planLines(state).points.size() / 2, 2u * 8);
  EXPECT_EQ(painter.solidEdges(state).points.size() / 2, 2u * 12)
      << "the walls still end where the ceiling was";
}

TEST_F(ViewedSample, PlanLinesFollowArcs)
{
  ViewedResult round;
  PlanRoom room = planOf(BoxRoom());
  PlanElement circle;
  circle.start = circle.end = {3, 0};
  circle.centre = {2, 0};
  circle.radius = 1;
  circle.counter_clockwise = false;
  room.columns.push_back({{circle}});
  round.plan.rooms.push_back(room);
  const Painter painter(round);
  std::size_t on_circle = 0;
  const auto lines = painter.planLines(ViewState());
  for (std::size_t i = 0; i < lines.points.size(); ++i)
    if (lines.colours[i] == colours::column) {
      EXPECT_NEAR((lines.points[i].head<2>() - Eigen::Vector2f(2, 0)).norm(), 1, 1e-5);
      ++on_circle;
    }
  EXPECT_GT(on_circle, 60u);
}

TEST_F(ViewedSample, LegendTellsCountsAreasAndColours)
{
  const Painter painter(result_);
  ViewState state;
  state.layers = {Layer::Structure};
  const auto has = [&](const std::string& text, Colour colour) {
    const auto lines = legendOf(result_, painter, state);
    return std::any_of(lines.begin(), lines.end(), [&](const LegendLine& line) {
      return line.text.find(text) != std::string::npos && line.colour == colour;
    });
  };
  const auto ceilings =
      std::count_if(sample_.scan.points.begin(), sample_.scan.points.end(),
                    [](const RoomPoint& p) { return p.label == Label::Ceiling; });
  EXPECT_EQ(ceilings, 80 * 60 + 70 * 60);
  EXPECT_TRUE(has("ceiling  9,000 points", colours::ceiling));
  EXPECT_TRUE(has("room 1  12.0 m2", roomColour(1)));
  EXPECT_TRUE(has("room 2  10.5 m2", roomColour(2)));
  EXPECT_FALSE(has("without ceilings", colours::ink));
  state.ceiling = false;
  state.clip_height = 1.25;
  EXPECT_TRUE(has("without ceilings", colours::ink));
  EXPECT_TRUE(has("cut at 1.25 m", colours::ink));
  state.colouring = Colouring::Distance;
  EXPECT_TRUE(has("5 cm or more", distanceColour(0.05, 0.05)));
  EXPECT_EQ(countText(0), "0");
  EXPECT_EQ(countText(999), "999");
  EXPECT_EQ(countText(1234567), "1,234,567");
  const Image image = drawLegend(legendOf(result_, painter, state));
  EXPECT_GT(image.width, 100);
  EXPECT_NE(
      std::count(image.pixels.begin(), image.pixels.end(), distanceColour(0.05, 0.05)),
      0);
  EXPECT_TRUE(drawLegend({}).pixels.empty());
}

TEST_F(ViewedSample, TellsWhatAPickedPointIs)
{
  const BoxRoom room = sample_.first;
  // A point 3 cm in front of wall 2 of the plan, which is at x + width.
  const std::string wall =
      reportPoint(result_, {room.x + room.width - 0.03, room.y + 1.02, 1.23});
  EXPECT_NE(wall.find("wall, room 1"), std::string::npos) << wall;
  EXPECT_NE(wall.find("room_1_wall_2"), std::string::npos) << wall;
  EXPECT_NE(wall.find("3.0 cm from the mesh"), std::string::npos) << wall;
  const std::string ceiling =
      reportPoint(result_, {sample_.second.x + 1, room.y + 1, 2.5});
  EXPECT_NE(ceiling.find("ceiling, room 2"), std::string::npos) << ceiling;
  EXPECT_NE(ceiling.find("room_2_ceiling"), std::string::npos) << ceiling;
  const std::string far = reportPoint(result_, {50, 0, 0});
  EXPECT_NE(far.find("nothing known"), std::string::npos) << far;
}

TEST_F(ViewedSample, CameraSeesTheWholeModelAndStandsInTheLargestRoom)
{
  for (const double aspect : {0.5, 1.0, 2.0})
    for (const auto view_point : {ViewPoint::Top, ViewPoint::Iso}) {
      const CameraPose pose = cameraPose(result_, view_point, aspect);
      const Eigen::Vector3d ahead = (pose.focus - pose.position).normalized();
      const Eigen::Vector3d right = ahead.cross(pose.up).normalized();
      const Eigen::Vector3d above = right.cross(ahead);
      const double slope = std::tan(pose.view_angle * M_PI / 360);
      double most = 0;
      for (const auto& vertex : result_.mesh.vertices) {
        const Eigen::Vector3d way = vertex - pose.position;
        const double depth = way.dot(ahead);
        ASSERT_GT(depth, 0);
        most = std::max({most, std::abs(way.dot(above)) / (depth * slope),
                         std::abs(way.dot(right)) / (depth * slope * aspect)});
      }
      EXPECT_LE(most, 1) << "all within the window";
      EXPECT_GE(most, 0.75) << "which it fills";
    }
  const CameraPose inside = cameraPose(result_, ViewPoint::Inside, 1.5);
  EXPECT_TRUE(result_.plan.rooms[0].contains(inside.position.head<2>()));
  EXPECT_GE(result_.plan.rooms[0].boundary.distance(inside.position.head<2>()), 0.6);
  EXPECT_GT(inside.position.z(), 1);
  EXPECT_LT(inside.position.z(), 2);
}

/** The sample with a copy above it: rooms 3 and 4 from 2.8 to 5.3 m. */
ViewedResult
twoStoreys(const ViewedResult& one)
{
  constexpr double up = 2.8;
  ViewedResult both = one;
  both.plan.storeys.clear(); // they lack the rooms above
  for (PlanRoom room : one.plan.rooms) {
    room.id += 2;
    room.floor.plane[3] -= up;
    room.ceiling.plane[3] -= up;
    both.plan.rooms.push_back(room);
  }
  for (DisplayCloud ViewedResult::*cloud :
       {&ViewedResult::raw, &ViewedResult::structure})
    for (std::size_t i = 0, n = (one.*cloud).size(); i < n; ++i) {
      DisplayCloud& shown = both.*cloud;
      shown.points.push_back((one.*cloud).points[i] + Eigen::Vector3f(0, 0, 2.8F));
      if (!shown.labels.empty())
        shown.labels.push_back((one.*cloud).labels[i]);
      if (!shown.rooms.empty())
        shown.rooms.push_back((one.*cloud).rooms[i] + 2);
      if (!shown.normals.empty())
        shown.normals.push_back((one.*cloud).normals[i]);
    }
  for (TriangleMesh ViewedResult::*mesh : {&ViewedResult::mesh, &ViewedResult::solid}) {
    TriangleMesh upper = one.*mesh;
    for (auto& vertex : upper.vertices)
      vertex.z() += up;
    for (auto& room : upper.rooms)
      room += 2;
    (both.*mesh).append(upper);
  }
  return both;
}

TEST_F(ViewedSample, OfOneStoreyShowsNothingOfTheOthers)
{
  const ViewedResult both = twoStoreys(result_);
  const Painter painter(both);
  ASSERT_EQ(painter.storeys().storeys().size(), 2u);
  ViewState state;
  for (const std::uint32_t storey : {1u, 2u}) {
    state.storey = storey;
    const float low = storey == 1 ? 0 : 2.8F;
    const auto isWithin = [&](const ColouredPoints& shown) {
      return !shown.points.empty() &&
             std::all_of(shown.points.begin(), shown.points.end(),
                         [&](const Eigen::Vector3f& p) {
                           return p.z() > low - 0.16F && p.z() < low + 2.66F;
                         });
    };
    EXPECT_TRUE(isWithin(painter.points(Layer::Raw, state)));
    EXPECT_TRUE(isWithin(painter.points(Layer::Structure, state)));
    EXPECT_EQ(painter.points(Layer::Structure, state).points.size(),
              result_.structure.size());
    for (const auto layer : {Layer::Mesh, Layer::Solid}) {
      EXPECT_TRUE(isWithin(painter.triangles(layer, state)));
      EXPECT_EQ(painter.triangles(layer, state).points.size(),
                3 * result_.meshOf(layer)->triangles.size());
    }
    EXPECT_EQ(painter.planLines(state).points.size() / 2, 2u * 12);
    EXPECT_EQ(painter.solidEdges(state).points.size() / 2, 2u * 12);
    const auto lines = legendOf(both, painter, state);
    const auto tells = [&](const std::string& text) {
      return std::any_of(lines.begin(), lines.end(), [&](const LegendLine& line) {
        return line.text.find(text) != std::string::npos;
      });
    };
    EXPECT_TRUE(tells("storey " + std::to_string(storey)));
    EXPECT_EQ(tells("room 1 "), storey == 1);
    EXPECT_EQ(tells("room 3 "), storey == 2);
    const double eyes = cameraPose(both, ViewPoint::Inside, 1.5, storey).position.z();
    EXPECT_TRUE(eyes > low + 1 && eyes < low + 2) << eyes;
  }
  state.storey = 0;
  EXPECT_EQ(painter.points(Layer::Structure, state).points.size(),
            both.structure.size());
}

TEST_F(ViewedSample, WithoutCeilingsShowsTheFloorsOfAllStoreys)
{
  const ViewedResult both = twoStoreys(result_);
  const Painter painter(both);
  ViewState state;
  state.ceiling = false;
  const auto count = [&](float low, float high) {
    const auto shown = painter.points(Layer::Raw, state).points;
    return std::count_if(shown.begin(), shown.end(), [&](const Eigen::Vector3f& p) {
      return p.z() > low && p.z() < high;
    });
  };
  EXPECT_EQ(count(2.4F, 2.6F), 0) << "the ceilings of the lower one";
  EXPECT_GT(count(2.7F, 2.9F), 1000) << "the floors of the upper one";
  EXPECT_EQ(count(5.2F, 5.4F), 0);
}

} // namespace
