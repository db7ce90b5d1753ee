// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "edit/edit_options.h"
#include "edit/edited_model.h"
#include "plan_file.h"
#include "run_tool.h"
#include "tool_error.h"

#include <pcl/sedr_filters/floorplan_io.h>

#include <boost/algorithm/string/join.hpp>

#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

using namespace pcl::sedr::tools;
using pcl::sedr::PlanEditor;

int
main(int argc, char** argv)
{
  std::string plan;
  std::string output;
  bool undo = false;
  EditOptions edits;
  Options options(
      "pcl_floorplan_edit",
      "Changes a floor plan by hand. Of a folder of pcl_sedr, all files that follow "
      "from the plan are written anew.\n"
      "Several edits of a kind are parted by semicolons: --merge \"3,5;7,8\". "
      "Kinds are done in the\n"
      "order below, so numbers of walls are those of the plan.");
  options.file("MODEL", plan,
               "folder of pcl_sedr, or a floor plan, as pcl_sedr and "
               "pcl_floorplan_fitting write it");
  options.optionalFile("OUTPUT.json", output,
                       "changed floor plan to write, if MODEL is one");
  edits.declare(options);
  options.flag("undo", undo, "take back the last edits of a folder instead");
  return runTool(options, argc, argv, [&] {
    const bool is_folder = std::filesystem::is_directory(plan);
    if (!std::filesystem::exists(plan))
      throw ToolError("there is no folder or floor plan '" + plan + "'");
    if (is_folder != output.empty())
      throw ToolError(is_folder
                          ? "the files of a folder are written in it, there is no "
                            "'" +
                                output + "' to write"
                          : "the name of the changed floor plan is missing");
    if (undo && (edits.isGiven() || !is_folder))
      throw ToolError("--undo is for a folder and takes no edits");
    if (!undo && !edits.isGiven())
      throw ToolError("there is no edit to do, such as --name 3=Kitchen; "
                      "pcl_floorplan_edit -h tells all");
    std::vector<std::string> done;
    const auto edit = [&](PlanEditor& editor) { return done = edits.apply(editor); };
    if (is_folder) {
      const auto kept = undo ? undoEdit(plan) : editModel(plan, edit);
      done.push_back((undo ? "the plan is the one before the last edits; " : "") +
                     std::string("all files that follow from the plan are written") +
                     (kept.empty() ? ""
                                   : ", still of the scan: " +
                                         boost::algorithm::join(kept, ", ")));
    }
    else {
      checkOutput(output, "a floor plan", {".json"});
      pcl::sedr::PlanDocument document = loadPlan(plan);
      PlanEditor editor(std::move(document.plan), document.max_wall);
      edit(editor);
      document.plan = editor.getFloorplan();
      writeWhole(output, documentToJson(document));
    }
    for (const std::string& sentence : done)
      std::cout << sentence << '\n';
    std::cout << std::flush;
    return Done;
  });
}
