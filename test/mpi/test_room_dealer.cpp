// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/packing.h"
#include "mpi/room_dealer.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

namespace {

using namespace pcl::sedr;
using namespace pcl::sedr::tools;

WallJob
jobOf(std::size_t number)
{
  WallJob job;
  job.room = static_cast<std::uint32_t>(number + 1);
  job.points.assign(number, Eigen::Vector3f::Ones());
  return job;
}

/** Counts the points of a room; room 3 fails on every rank. */
RoomResult
countPoints(const RoomJob& job)
{
  if (roomOf(job) == 3)
    throw std::runtime_error("its door is locked");
  FoundWalls found;
  found.walls.push_back(static_cast<int>(std::get<WallJob>(job).points.size()));
  return found;
}

TEST(RoomDealer, GivesEveryRoomToSomebodyAndTellsOfTheOneThatWasLost)
{
  RankMail mail{boost::mpi::communicator()};
  constexpr std::size_t rooms = 20;
  if (!mail.isFirst()) {
    for (;;) {
      mail.waitFor(Subject::Order);
      const std::string order = mail.receive(0, Subject::Order);
      if (order.empty())
        return;
      const auto job = unpack<RoomJob>(order);
      mail.send(0, Subject::Result, pack(workSafely(mail.rank(), job, countPoints)));
    }
  }
  std::map<int, std::string> held;
  std::vector<std::uint32_t> finished;
  RoomHooks hooks;
  hooks.work = countPoints;
  hooks.order = [](const RoomJob& job) { return pack(job); };
  hooks.note = [&](int rank, const std::string& what) {
    EXPECT_TRUE(what.empty() || held[rank].empty()) << "one room at a time";
    held[rank] = what;
  };
  hooks.finished = [&](std::uint32_t room, const RoomResult&) {
    finished.push_back(room);
  };
  RoomDealer dealer(mail, hooks);
  std::vector<std::size_t> sizes;
  for (std::size_t i = 0; i < rooms; ++i)
    sizes.push_back(i);
  std::vector<std::size_t> asked;
  std::vector<RoomResult> results(rooms);
  dealer.work(
      sizes,
      [&](std::size_t i) {
        asked.push_back(i);
        return RoomJob(jobOf(i));
      },
      [&](std::size_t i, RoomResult result) { results[i] = std::move(result); });
  for (int r = 1; r < mail.size(); ++r)
    mail.send(r, Subject::Order, "");

  for (std::size_t i = 0; i < rooms; ++i) {
    EXPECT_EQ(asked[i], rooms - 1 - i) << "the largest first, each once";
    if (i == 2) {
      const auto* lost = std::get_if<LostRoom>(&results[i]);
      ASSERT_TRUE(lost);
      EXPECT_NE(
          lost->reason.find("' failed at the walls of room 3: its door is locked"),
          std::string::npos)
          << lost->reason;
      EXPECT_EQ(dealer.losses(), std::vector<std::string>{lost->reason});
      continue;
    }
    const auto* found = std::get_if<FoundWalls>(&results[i]);
    ASSERT_TRUE(found) << i;
    EXPECT_EQ(found->walls, pcl::Indices{static_cast<int>(i)});
  }
  EXPECT_EQ(finished.size(), rooms);
  EXPECT_EQ(held.size(), static_cast<std::size_t>(mail.size())) << "all had a room";
  for (const auto& [rank, what] : held)
    EXPECT_EQ(what, "") << rank;
  EXPECT_FALSE(mail.hasLeft());
}

} // namespace
