// SPDX-License-Identifier: BSD-3-Clause
#include <boost/mpi/environment.hpp>

#include <gtest/gtest.h>

int
main(int argc, char** argv)
{
  boost::mpi::environment environment(argc, argv, boost::mpi::threading::funneled);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
