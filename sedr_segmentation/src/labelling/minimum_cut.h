// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A sum of costs of yes-or-no questions, of each alone and of pairs of them, to
 * be made as small as possible by a minimum cut (Kolmogorov and Zabih 2004). */
class BinaryEnergy {
public:
  explicit BinaryEnergy(std::size_t variables)
      : yes_(variables, 0)
  {}

  /** @brief What the two answers of a question cost. */
  void addTerm(std::size_t variable, double if_no, double if_yes)
  {
    yes_[variable] += if_yes - if_no;
  }

  /** @brief What the answers of two questions cost: no_no + yes_yes must be at most
   * no_yes + yes_no. */
  void addPair(std::size_t a,
               std::size_t b,
               double no_no,
               double no_yes,
               double yes_no,
               double yes_yes);

  /** @brief Returns the answers that cost least, 1 for yes. Throws std::length_error
   * for more than 2^31 - 1 questions and pairs together: arcs have 32-bit numbers, and
   * each question and each pair has two. */
  std::vector<std::uint8_t> minimise() const;

private:
  struct Pair {
    std::size_t a;
    std::size_t b;
    double capacity; ///< what it costs that a is no and b yes
  };

  /** @brief Numbers the questions that are not surely answered by no: those of which a
   * yes gains something if all others say yes. What their pairs with others cost is
   * added to `yes`. O(questions and pairs). */
  std::vector<std::uint32_t> openQuestions(std::vector<double>& yes) const;

  std::vector<double> yes_; ///< what a yes costs more than a no
  std::vector<Pair> pairs_;
};

} // namespace pcl::sedr
