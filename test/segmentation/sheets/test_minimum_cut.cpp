// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/labelling/minimum_cut.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>
#include <vector>

namespace {

using namespace pcl::sedr;

struct PairCosts {
  std::size_t a;
  std::size_t b;
  std::array<double, 4> costs; // no no, no yes, yes no, yes yes
};

TEST(BinaryEnergy, FindsTheLeastOfAllAnswers)
{
  constexpr std::size_t variables = 8;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> cost(-1, 1);
  for (int round = 0; round < 50; ++round) {
    BinaryEnergy energy(variables);
    std::vector<double> yes;
    for (std::size_t v = 0; v < variables; ++v) {
      yes.push_back(cost(random));
      energy.addTerm(v, 0.25, 0.25 + yes.back());
    }
    std::vector<PairCosts> pairs;
    for (std::size_t a = 0; a < variables; ++a)
      for (std::size_t b = a + 1; b < variables; b += 2) {
        PairCosts pair{a, b, {cost(random), cost(random), cost(random), cost(random)}};
        // Equal labels must not cost more than different ones.
        const double excess =
            pair.costs[0] + pair.costs[3] - pair.costs[1] - pair.costs[2];
        if (excess > 0)
          pair.costs[1] += excess;
        energy.addPair(a, b, pair.costs[0], pair.costs[1], pair.costs[2],
                       pair.costs[3]);
        pairs.push_back(pair);
      }
    const auto costOf = [&](unsigned answers) {
      double sum = 0;
      for (std::size_t v = 0; v < variables; ++v)
        sum += (answers >> v & 1U) != 0 ? yes[v] : 0;
      for (const PairCosts& pair : pairs)
        sum += pair.costs[2 * (answers >> pair.a & 1U) + (answers >> pair.b & 1U)];
      return sum;
    };
    double least = std::numeric_limits<double>::infinity();
    for (unsigned answers = 0; answers < 1U << variables; ++answers)
      least = std::min(least, costOf(answers));
    const auto found = energy.minimise();
    unsigned answers = 0;
    for (std::size_t v = 0; v < variables; ++v)
      answers |= found[v] ? 1U << v : 0U;
    EXPECT_NEAR(costOf(answers), least, 1e-9);
  }
}

TEST(BinaryEnergy, QuestionsThatCostNothingMayBeAnsweredAnyhow)
{
  EXPECT_EQ(BinaryEnergy(3).minimise().size(), 3U);
  EXPECT_TRUE(BinaryEnergy(0).minimise().empty());
}

} // namespace
