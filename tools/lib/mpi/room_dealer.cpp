// SPDX-License-Identifier: BSD-3-Clause
#include "room_dealer.h"

#include "joint_step.h"
#include "packing.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>

namespace pcl::sedr::tools {

namespace {

/** @brief Describes a job: "the mesh of room 3". */
std::string
textOf(const RoomJob& job)
{
  const std::string what = std::holds_alternative<WallJob>(job)     ? "the walls"
                           : std::holds_alternative<RepairJob>(job) ? "the points"
                                                                    : "the mesh";
  return what + " of room " + std::to_string(roomOf(job));
}

} // namespace

RoomResult
workSafely(int rank, const RoomJob& job, const RoomWork& work)
{
  try {
    return work(job);
  }
  catch (...) {
    return LostRoom{nameOf(rank) + " failed at " + textOf(job) + ": " +
                    currentProblem()};
  }
}

RoomDealer::RoomDealer(RankMail& mail, RoomHooks hooks)
    : mail_(mail)
    , hooks_(std::move(hooks))
    , busy_(static_cast<std::size_t>(mail.size()))
{}

void
RoomDealer::work(const std::vector<std::size_t>& sizes,
                 const Job& job,
                 const Take& take)
{
  std::vector<std::size_t> left(sizes.size());
  std::iota(left.begin(), left.end(), 0);
  std::stable_sort(left.begin(), left.end(), [&](std::size_t a, std::size_t b) {
    return sizes[a] < sizes[b]; // the largest is last
  });
  try {
    dealOut(std::move(left), job, take);
  }
  catch (...) {
    mail_.leave(); // other ranks are still working and will send results
    throw;
  }
}

void
RoomDealer::dealOut(std::vector<std::size_t> left, const Job& job, const Take& take)
{
  for (std::size_t to_come = left.size(); to_come > 0;) {
    // This rank comes last, as it also serves the others.
    for (int rank = mail_.size() - 1; rank >= 0 && !left.empty(); --rank)
      if (!busy_[static_cast<std::size_t>(rank)]) {
        give(rank, left.back(), job(left.back()));
        left.pop_back();
      }
    if (takeOne(take))
      --to_come;
    else
      rest();
  }
}

void
RoomDealer::give(int rank, std::size_t number, RoomJob job)
{
  busy_[static_cast<std::size_t>(rank)] = Task{number, roomOf(job)};
  hooks_.note(rank, textOf(job));
  if (rank > 0)
    mail_.send(rank, Subject::Order, hooks_.order(job));
  else
    own_ = std::async(std::launch::async, [this, job = std::move(job)] {
      return workSafely(0, job, hooks_.work);
    });
}

bool
RoomDealer::takeOne(const Take& take)
{
  RoomResult result;
  int rank = mail_.pending(Subject::Result);
  if (rank > 0)
    result = unpack<RoomResult>(mail_.receive(rank, Subject::Result));
  else if (busy_[0] &&
           own_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    rank = 0;
    result = own_.get();
  }
  else
    return false;
  const Task task = *busy_[static_cast<std::size_t>(rank)];
  busy_[static_cast<std::size_t>(rank)].reset();
  hooks_.note(rank, "");
  hooks_.finished(task.room, result);
  if (const auto* lost = std::get_if<LostRoom>(&result))
    losses_.push_back(lost->reason);
  take(task.number, std::move(result));
  return true;
}

} // namespace pcl::sedr::tools
