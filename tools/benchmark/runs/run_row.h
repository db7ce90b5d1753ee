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

namespace pcl {
namespace sedr {
namespace benchmark {

/** @brief Recall and precision of a label, from 0 to 1; NaN where nothing has it. */
struct LabelFigures {
  double recall = not_known;
  double precision = not_known;
};

/** @brief Name and seconds of each stage, in order. */
using StageSeconds = std::vector<std::pair<std::string, double>>;

/** @brief One run of the proving ground: what was asked for and what came out. */
struct RunRow {
  std::string scene;
  double noise = 0; ///< metres
  std::uint64_t seed = 1;
  bool with_mesh = true;

  std::size_t points = 0; ///< of the scan
  std::string failure;    ///< why there is no result, a sentence; empty if there is
  RoomFigures rooms;
  PlanFigures plan;
  SolidFigures solid;
  ModelFigures mesh;
  StructureFigures structure;
  std::array<LabelFigures, scored_labels.size()> labels;
  double seconds = not_known; ///< of all stages
  StageSeconds stage_seconds;
  std::string warnings;

  /** @brief Whether both are runs of the same scene, noise, seed and kind. */
  bool isSameRun(const RunRow& other) const;
};

/** @brief The names of all columns, a line of CSV without its end. */
std::string csvHeader();

/** @brief A row as a line of CSV, without its end. Text that needs it is quoted, line
 * ends in it become blanks; what is not known is empty. */
std::string toCsv(const RunRow& row);

/** @brief Reads a row.
 * @param header the line of names of its file: columns may be missing, be in another
 * order or unknown
 * @throw std::invalid_argument, a sentence, if a cell cannot be read */
RunRow rowFromCsv(const std::string& header, const std::string& line);

} // namespace benchmark
} // namespace sedr
} // namespace pcl
