// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/mpi/communicator.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What a letter between ranks is about. */
enum class Subject : int {
  Step,   ///< of something that all ranks do together
  Order,  ///< of rank 0 to another
  Result, ///< of another rank to rank 0
};

/** @brief Bytes from rank to rank, of any size. Who waits for some sleeps: on one
 * machine, ranks that have nothing to do leave the processors to the others. */
class RankMail {
public:
  explicit RankMail(const boost::mpi::communicator& ranks);

  int rank() const { return ranks_.rank(); }
  int size() const { return ranks_.size(); }
  bool isFirst() const { return rank() == 0; }

  void send(int to, Subject subject, const std::string& bytes)
  {
    send(to, subject, bytes.data(), bytes.size());
  }
  void send(int to, Subject subject, const void* bytes, std::size_t size);

  std::string receive(int from, Subject subject);

  /** @brief The rank that has sent something; -1: none has. */
  int pending(Subject subject) const;

  /** @brief Waits until a rank has sent something. */
  int waitFor(Subject subject) const;

  /** @brief What every rank gives, in their order, at rank 0; nothing at the others. */
  std::vector<std::string> gather(const std::string& mine);

  /** @brief What rank 0 gives, at every rank. */
  std::string fromFirst(const std::string& bytes);

  /** @brief Bytes for a rank. */
  struct Parcel {
    const void* bytes = nullptr;
    std::size_t size = 0;
  };

  /** @brief Gives every other rank its parcel.
   * @param parcels of every rank; that of this one stays
   * @return what every other rank had for this one */
  std::vector<std::string> exchange(const std::vector<Parcel>& parcels);

  /** @brief Notes that something failed here while other ranks wait for an answer: they
   * can only be aborted. */
  void leave() { has_left_ = true; }
  bool hasLeft() const { return has_left_; }

  /** @brief Bytes that this rank has sent. */
  std::uint64_t sent() const { return sent_; }

private:
  boost::mpi::communicator ranks_;
  std::uint64_t sent_ = 0;
  bool has_left_ = false;
};

/** @brief A little sleep between two looks at something. */
void rest();

} // namespace tools
} // namespace sedr
} // namespace pcl
