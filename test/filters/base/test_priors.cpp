// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/priors.h>

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

namespace {

using namespace pcl::sedr;

TEST(Priors, TheTableHoldsEveryNumberOnceInOrder)
{
  const Priors defaults;
  const auto* const first = reinterpret_cast<const double*>(&defaults);
  ASSERT_EQ(priorTable().size() * sizeof(double), sizeof(Priors));
  std::set<std::string> names;
  for (std::size_t k = 0; k < priorTable().size(); ++k) {
    const Prior& prior = priorTable()[k];
    EXPECT_EQ(&(defaults.*prior.member), first + k) << prior.name;
    EXPECT_TRUE(names.insert(prior.name).second) << prior.name;
    EXPECT_LT(prior.low, prior.high) << prior.name;
  }
}

TEST(Priors, DefaultsAreInTheirRanges)
{
  EXPECT_EQ(problemOf(Priors()), "");
}

TEST(Priors, ANumberIsSetByItsNameAndNothingElse)
{
  for (const Prior& prior : priorTable()) {
    Priors priors;
    EXPECT_EQ(setPrior(prior.name, prior.high, priors), "");
    for (const Prior& other : priorTable())
      EXPECT_EQ(priors.*other.member,
                other.name == prior.name ? prior.high : Priors().*other.member)
          << prior.name << " set, " << other.name;
  }
}

TEST(Priors, RefusesWhatIsOutOfRangeAndSaysTheRange)
{
  Priors priors;
  EXPECT_EQ(setPrior("max_wall", 30, priors),
            "the prior max_wall must be from 0.1 to 3 m, not 30");
  EXPECT_EQ(setPrior("max_wal", 0.5, priors), "there is no prior max_wal");
  EXPECT_NE(setPrior("max_wall", std::numeric_limits<double>::quiet_NaN(), priors), "");
  EXPECT_EQ(priors.max_wall, Priors().max_wall);
  priors.max_door_width = -1;
  EXPECT_NE(problemOf(priors).find("max_door_width"), std::string::npos);
}

} // namespace
