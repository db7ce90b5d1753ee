// SPDX-License-Identifier: BSD-3-Clause
#include "rank_mail.h"

#include <boost/mpi/nonblocking.hpp>

#include <algorithm>
#include <chrono>
#include <thread>

namespace pcl::sedr::tools {

namespace {

using Requests = std::vector<boost::mpi::request>;

constexpr std::size_t sheet = std::size_t{1} << 26; // MPI counts with int

void
finish(Requests& requests)
{
  for (auto& request : requests)
    while (!request.test())
      rest();
}

/** @brief Starts sending: the size, then the bytes, in chunks. The arguments must stay
 * valid until the requests are done. */
void
begin(const boost::mpi::communicator& ranks,
      int to,
      Subject subject,
      const std::uint64_t& size,
      const void* bytes,
      Requests& requests)
{
  const auto tag = static_cast<int>(subject);
  requests.push_back(ranks.isend(to, tag, size));
  const auto* at = static_cast<const char*>(bytes);
  for (std::size_t done = 0; done < size; done += sheet)
    requests.push_back(
        ranks.isend(to, tag, at + done,
                    static_cast<int>(std::min<std::size_t>(sheet, size - done))));
}

} // namespace

void
rest()
{
  std::this_thread::sleep_for(std::chrono::microseconds(200));
}

RankMail::RankMail(const boost::mpi::communicator& ranks)
    : ranks_(ranks)
{}

void
RankMail::send(int to, Subject subject, const void* bytes, std::size_t size)
{
  const std::uint64_t length = size;
  Requests requests;
  begin(ranks_, to, subject, length, bytes, requests);
  finish(requests);
  sent_ += size;
}

std::string
RankMail::receive(int from, Subject subject)
{
  const auto tag = static_cast<int>(subject);
  std::uint64_t length = 0;
  Requests requests{ranks_.irecv(from, tag, length)};
  finish(requests);
  std::string bytes(length, '\0');
  requests.clear();
  for (std::size_t done = 0; done < length; done += sheet)
    requests.push_back(
        ranks_.irecv(from, tag, &bytes[done],
                     static_cast<int>(std::min<std::size_t>(sheet, length - done))));
  finish(requests);
  return bytes;
}

int
RankMail::pending(Subject subject) const
{
  const auto status = ranks_.iprobe(boost::mpi::any_source, static_cast<int>(subject));
  return status ? status->source() : -1;
}

int
RankMail::waitFor(Subject subject) const
{
  int from = pending(subject);
  for (; from < 0; from = pending(subject))
    rest();
  return from;
}

std::vector<std::string>
RankMail::gather(const std::string& mine)
{
  if (!isFirst()) {
    send(0, Subject::Step, mine);
    return {};
  }
  std::vector<std::string> all{mine};
  for (int r = 1; r < size(); ++r)
    all.push_back(receive(r, Subject::Step));
  return all;
}

std::string
RankMail::fromFirst(const std::string& bytes)
{
  if (!isFirst())
    return receive(0, Subject::Step);
  for (int r = 1; r < size(); ++r)
    send(r, Subject::Step, bytes);
  return bytes;
}

std::vector<std::string>
RankMail::exchange(const std::vector<Parcel>& parcels)
{
  std::vector<std::string> received(parcels.size());
  for (int step = 1; step < size(); ++step) {
    const int to = (rank() + step) % size();
    const int from = (rank() - step + size()) % size();
    const Parcel& parcel = parcels[static_cast<std::size_t>(to)];
    const std::uint64_t length = parcel.size;
    Requests requests;
    begin(ranks_, to, Subject::Step, length, parcel.bytes, requests);
    received[static_cast<std::size_t>(from)] = receive(from, Subject::Step);
    finish(requests);
    sent_ += parcel.size;
  }
  return received;
}

} // namespace pcl::sedr::tools
