// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include "sedr_surface/src/jobs/room_threads.h"
#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_surface/room_jobs.h>
#include <pcl/sedr_surface/structure_chain.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <stdexcept>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Processes the largest room first, and may fail at one of them. */
class Neighbours : public RoomWorkers {
public:
  template <typename Kind>
  void failAt(std::uint32_t room)
  {
    fails_ = [room](const RoomJob& job) {
      return std::holds_alternative<Kind>(job) && roomOf(job) == room;
    };
  }

  void work(const std::vector<std::size_t>& sizes,
            const std::function<RoomJob(std::size_t)>& job,
            const std::function<void(std::size_t, RoomResult)>& take) override
  {
    std::vector<std::size_t> order(sizes.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
    for (const std::size_t i : order) {
      const RoomJob one = job(i);
      jobs.push_back(roomOf(one));
      take(i, fails_ && fails_(one) ? RoomResult(LostRoom{"the lights went out"})
                                    : workOn(one, 2));
    }
  }

  std::vector<std::uint32_t> jobs; ///< rooms, in the order of processing

private:
  std::function<bool(const RoomJob&)> fails_;
};

/** Two rooms 10 cm apart. */
StructureChain::Cloud::Ptr
twoRooms()
{
  RoomPoints points;
  points.room(rectangle(0.01, 0.01, 4.01, 3.01), 0, 2.5);
  points.room(rectangle(4.11, 0.01, 9.11, 3.01), 0, 2.8);
  return points.cloud();
}

void
expectSame(const TriangleMesh& a, const TriangleMesh& b)
{
  EXPECT_TRUE(a.vertices == b.vertices);
  EXPECT_TRUE(a.triangles == b.triangles);
  EXPECT_TRUE(a.labels == b.labels);
  EXPECT_TRUE(a.rooms == b.rooms);
}

TEST(RoomJobs, DoneElsewhereGiveTheSameModel)
{
  for (const bool from_plan : {false, true}) {
    StructureChain here;
    here.mesh_from_plan = from_plan;
    ASSERT_TRUE(here.findStructure(twoRooms())) << here.problem;
    ASSERT_TRUE(here.makeMesh()) << here.problem;

    const auto neighbours = std::make_shared<Neighbours>();
    StructureChain chain;
    chain.mesh_from_plan = from_plan;
    chain.room_workers = neighbours;
    ASSERT_TRUE(chain.findStructure(twoRooms())) << chain.problem;
    ASSERT_TRUE(chain.makeMesh()) << chain.problem;
    EXPECT_EQ(neighbours->jobs.size(), 6u) << "walls, points and surface of two rooms";

    EXPECT_TRUE(chain.labels == here.labels);
    EXPECT_TRUE(chain.rooms == here.rooms);
    EXPECT_EQ(floorplanToJson(*chain.plan), floorplanToJson(*here.plan));
    ASSERT_EQ(chain.structure->size(), here.structure->size());
    for (std::size_t i = 0; i < here.structure->size(); ++i) {
      const auto& p = (*chain.structure)[i];
      const auto& q = (*here.structure)[i];
      ASSERT_EQ(p.getVector3fMap(), q.getVector3fMap());
      ASSERT_EQ(p.getNormalVector3fMap(), q.getNormalVector3fMap());
      ASSERT_EQ(p.label, q.label);
      ASSERT_EQ(p.room, q.room);
    }
    expectSame(chain.poisson.getMesh(), here.poisson.getMesh());
    EXPECT_TRUE(chain.warnings == here.warnings);
    EXPECT_TRUE(chain.repairedShares() == here.repairedShares());
    ASSERT_EQ(chain.reports.size(), here.reports.size());
    for (std::size_t i = 0; i < here.reports.size(); ++i) {
      EXPECT_EQ(chain.reports[i].points_in, here.reports[i].points_in);
      EXPECT_EQ(chain.reports[i].points_out, here.reports[i].points_out);
    }
  }
}

TEST(RoomJobs, ARoomThatIsLostIsLeftOutAndToldAndTheOthersStay)
{
  StructureChain here;
  ASSERT_TRUE(here.findStructure(twoRooms())) << here.problem;
  ASSERT_TRUE(here.makeMesh());

  const auto surfacesOf = [](const StructureChain& chain) {
    std::vector<std::uint32_t> rooms = chain.poisson.getMesh().rooms;
    rooms.erase(std::unique(rooms.begin(), rooms.end()), rooms.end());
    return rooms;
  };
  const auto run = [](const std::shared_ptr<RoomWorkers>& workers,
                      StructureChain& chain) {
    chain.room_workers = workers;
    return chain.findStructure(twoRooms()) && chain.makeMesh();
  };
  const auto tells = [](const StructureChain& chain) {
    return std::any_of(
        chain.warnings.begin(), chain.warnings.end(), [](const std::string& warning) {
          return warning.find("room 2") == 0 &&
                 warning.find("the lights went out") != std::string::npos;
        });
  };
  const auto neighbours = std::make_shared<Neighbours>();
  {
    neighbours->failAt<WallJob>(2);
    StructureChain chain;
    ASSERT_TRUE(run(neighbours, chain)) << chain.problem;
    ASSERT_EQ(chain.plan->rooms.size(), 1u);
    EXPECT_EQ(chain.plan->rooms[0].id, 1u);
    EXPECT_EQ(surfacesOf(chain), std::vector<std::uint32_t>({1}));
    EXPECT_TRUE(tells(chain));
  }
  {
    neighbours->failAt<RepairJob>(2);
    StructureChain chain;
    ASSERT_TRUE(run(neighbours, chain)) << chain.problem;
    EXPECT_EQ(chain.plan->rooms.size(), 2u);
    for (const auto& p : *chain.structure)
      ASSERT_EQ(p.room, 1u);
    EXPECT_EQ(surfacesOf(chain), std::vector<std::uint32_t>({1}));
    EXPECT_TRUE(tells(chain));
  }
  {
    neighbours->failAt<SurfaceJob>(2);
    StructureChain chain;
    ASSERT_TRUE(run(neighbours, chain)) << chain.problem;
    EXPECT_EQ(chain.structure->size(), here.structure->size());
    EXPECT_EQ(surfacesOf(chain), std::vector<std::uint32_t>({1}));
    EXPECT_TRUE(tells(chain));
  }
}

/** Sizes of five rooms; the first two outweigh the later ones. */
const std::vector<std::size_t> sizes{10, 100, 400, 20, 30};

TEST(RoomThreads, TakeEachRoomOnceAndTheLargestFirst)
{
  for (const unsigned threads : {1u, 2u, 3u}) {
    std::vector<std::size_t> made;
    std::vector<std::size_t> taken;
    RoomThreads(threads).work(
        sizes,
        [&](std::size_t i) {
          made.push_back(i);
          SurfaceJob job;
          job.samples.room = static_cast<std::uint32_t>(i);
          return job;
        },
        [&](std::size_t i, const RoomResult& result) {
          EXPECT_EQ(std::get<RoomSurface>(result).report.room, i);
          taken.push_back(i);
        });
    EXPECT_EQ(made.front(), 2u);
    EXPECT_EQ(made[1], 1u);
    std::sort(made.begin(), made.end());
    std::sort(taken.begin(), taken.end());
    EXPECT_EQ(made, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    EXPECT_EQ(taken, made);
  }
}

TEST(RoomThreads, HandOnWhatFailed)
{
  const auto fail = [](std::size_t i) -> RoomJob {
    if (i == 3)
      throw std::runtime_error("the lights went out");
    return SurfaceJob();
  };
  EXPECT_THROW(RoomThreads(2).work(sizes, fail, [](std::size_t, const RoomResult&) {}),
               std::runtime_error);
}

TEST(RoomThreads, GiveTheSurfacesOfTheRoomsInTheirOrder)
{
  Floorplan plan;
  for (std::uint32_t r = 0; r < 5; ++r) {
    plan.rooms.push_back(
        roomOf(rectangle(5 * r, 0, 5 * r + 1 + (2 * r) % 5 * 0.7, 2), 2.5));
    plan.rooms.back().id = r + 1;
  }
  pcl::StructuralPoisson<pcl::PointStructure> alone;
  alone.setFloorplan(std::make_shared<const Floorplan>(plan));
  ASSERT_TRUE(alone.makeMesh()) << alone.getErrorMessage();
  for (const unsigned threads : {2u, 3u, 8u}) {
    pcl::StructuralPoisson<pcl::PointStructure> poisson;
    poisson.setFloorplan(std::make_shared<const Floorplan>(plan));
    poisson.setNumberOfThreads(threads);
    ASSERT_TRUE(poisson.makeMesh()) << poisson.getErrorMessage();
    expectSame(poisson.getMesh(), alone.getMesh());
    ASSERT_EQ(poisson.getReports().size(), 5u);
    for (std::uint32_t r = 0; r < 5; ++r)
      EXPECT_EQ(poisson.getReports()[r].room, r + 1);
  }
}

TEST(RoomJobs, WithoutAnyRoomLeftThereIsNoStructure)
{
  RoomPoints points;
  points.room(rectangle(0.01, 0.01, 4.01, 3.01), 0, 2.5);
  const auto neighbours = std::make_shared<Neighbours>();
  neighbours->failAt<RepairJob>(1);
  StructureChain chain;
  chain.room_workers = neighbours;
  EXPECT_FALSE(chain.findStructure(points.cloud()));
  EXPECT_EQ(chain.failed_stage, "StructureRefinement");
}

} // namespace
