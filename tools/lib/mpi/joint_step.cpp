// SPDX-License-Identifier: BSD-3-Clause
#include "joint_step.h"

#include "tool_error.h"

#include <boost/mpi/environment.hpp>

#include <new>

namespace pcl::sedr::tools {

std::string
currentProblem()
{
  try {
    throw;
  }
  catch (const std::bad_alloc&) {
    return "the memory does not suffice";
  }
  catch (const std::exception& error) {
    return error.what();
  }
  catch (...) {
    return "for an unknown reason";
  }
}

std::string
nameOf(int rank)
{
  return "rank " + std::to_string(rank) + " on '" +
         boost::mpi::environment::processor_name() + "'";
}

void
together(RankMail& mail, const std::string& held, const std::function<void()>& step)
{
  std::string problem;
  try {
    step();
  }
  catch (...) {
    problem = nameOf(mail.rank()) + " failed at " + held + ": " + currentProblem();
  }
  std::string all;
  for (const std::string& one : mail.gather(problem))
    all += (all.empty() || one.empty() ? "" : "; ") + one;
  all = mail.fromFirst(all);
  if (all.empty())
    return;
  if (mail.isFirst())
    throw ToolError(all);
  throw StepFailed();
}

} // namespace pcl::sedr::tools
