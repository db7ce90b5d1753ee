// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/figures/label_scores.h"
#include "benchmark/figures/model_figures.h"
#include "benchmark/figures/plan_figures.h"
#include "benchmark/figures/room_match.h"
#include "benchmark/figures/solid_figures.h"
#include "benchmark/figures/structure_figures.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr::benchmark {

/** @brief Recall and precision of a label, from 0 to 1; NaN without points. */
struct LabelFigures {
  double recall = not_known;
  double precision = not_known;
};

/** @brief Name and seconds of each stage, in order. */
using StageSeconds = std::vector<std::pair<std::string, double>>;

/** @brief Parameters and results of one benchmark run. */
struct RunRow {
  std::string scene;
  double noise = 0; ///< metres
  std::uint64_t seed = 1;
  bool with_mesh = true;

  std::size_t points = 0; ///< of the scan
  std::string failure;    ///< reason for a missing result, a sentence; empty on success
  RoomFigures rooms;
  PlanFigures plan;
  SolidFigures solid;
  ModelFigures mesh;
  StructureFigures structure;
  std::array<LabelFigures, scored_labels.size()> labels;
  double seconds = not_known; ///< of all stages
  StageSeconds stage_seconds;
  std::string warnings;

  /** @brief Returns true if one of some lines of CSV is of the same scene, noise, seed
   * and kind. */
  bool isIn(const std::vector<std::string>& lines) const;
};

/** @brief Returns the names of all columns as a line of CSV without line end. */
std::string csvHeader();

/** @brief Returns a row as a line of CSV without line end. Text is quoted if necessary,
 * and its line ends become blanks; unknown values are empty. */
std::string toCsv(const RunRow& row);

} // namespace pcl::sedr::benchmark
