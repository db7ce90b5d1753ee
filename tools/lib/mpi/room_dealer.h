// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rank_mail.h"

#include <pcl/sedr_surface/room_jobs.h>

#include <cstdint>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Runs a job; workOn() except in tests. */
using RoomWork = std::function<RoomResult(const RoomJob&)>;

/** @brief Runs a job; an exception becomes a LostRoom that names the rank. */
RoomResult workSafely(int rank, const RoomJob& job, const RoomWork& work);

/** @brief Callbacks of a dealer. */
struct RoomHooks {
  RoomWork work; ///< on rank 0
  /** Returns the message that orders a job from another rank, which answers with a
   * packed RoomResult. */
  std::function<std::string(const RoomJob&)> order;
  /** Called when a rank starts a job, with its description; empty when it ends. */
  std::function<void(int rank, const std::string& held)> note;
  /** Called with the result of a room. */
  std::function<void(std::uint32_t room, const RoomResult&)> finished;
};

/** @brief Distributes rooms to all ranks including rank 0: a free rank gets the largest
 * remaining room. */
class RoomDealer : public RoomWorkers {
public:
  RoomDealer(RankMail& mail, RoomHooks hooks);

  void work(const std::vector<std::size_t>& sizes,
            const std::function<RoomJob(std::size_t)>& job,
            const std::function<void(std::size_t, RoomResult)>& take) override;

  /** @brief Returns the reasons why rooms were lost so far, a sentence each. */
  const std::vector<std::string>& losses() const { return losses_; }

private:
  using Job = std::function<RoomJob(std::size_t)>;
  using Take = std::function<void(std::size_t, RoomResult)>;

  void dealOut(std::vector<std::size_t> left, const Job& job, const Take& take);

  /** @brief Gives job `number` to a rank. */
  void give(int rank, std::size_t number, RoomJob job);

  /** @brief Takes a result, if any.
   * @return whether there was one */
  bool takeOne(const Take& take);

  RankMail& mail_;
  RoomHooks hooks_;

  /** @brief The job of a rank. */
  struct Task {
    std::size_t number;
    std::uint32_t room;
  };
  std::vector<std::optional<Task>> busy_; ///< per rank
  std::future<RoomResult> own_;           ///< result of this rank
  std::vector<std::string> losses_;
};

} // namespace pcl::sedr::tools
