// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include <cli/command_line.h>
#include <cli/errors.h>
#include <io/output_file.h>

namespace pcl_ops::apps {

namespace {

constexpr const char* summary =
    "Finds the planes of a survey that is larger than the memory, in tiles, and "
    "labels\n"
    "every point with its plane, the same ones for any number of jobs and ranks.";

constexpr const char* in_and_out =
    "  INPUT       tiles in one frame, folders, patterns: .las (.laz by LASzip), "
    "which\n"
    "              are never whole in memory, .pcd, .ply, .xyz, .txt, .pts or .csv; "
    "they\n"
    "              may overlap\n"
    "  DIR/NAME    each input with its labels (0: no plane, 1: the largest, ...)\n"
    "  DIR/planes.json  all planes\n"
    "  DIR/work    what a run that was stopped goes on from; at the end the plan is "
    "left\n"
    "  mpirun -n 4 pcl_ops_tiles ...  shares the work among processes, all of which "
    "see\n"
    "              the same files\n"
    "  exit code   0 done; 1 failed; 2 wrong usage\n"
    "Lengths are in the unit of the inputs, meters by default.\n";

void
checkPlanes (const CommandLine& line, TilesOptions& options)
{
  checkExtension ("--planes", options.planes, {".geojson", ".csv", ".json"});
  finishChoice (line, options.choice);
  checkMap (line, options.planes);
  if (const auto given = line.givenOf (title_of_choice);
      !given.empty() && options.planes.empty() && options.image.empty())
    throw UsageError ("--" + given.front(), "is about --planes FILE; give it, too");
  checkExtension ("--image", options.image, {".png"});
}

} // namespace

bool
readOptions (int argc, const char* const* argv, TilesOptions& options)
{
  constexpr double most_jobs = 256;
  CommandLine line (program_name, summary, PCL_OPS_VERSION);
  line.setUsage ({"INPUT... --output-dir DIR [options]"}, in_and_out);
  line.addArguments ("INPUT", options.inputs, "");
  line.addText ("output-dir", "DIR", options.output_dir, "where the outputs go");
  line.addNumber ("cell",
                  "M",
                  Range::above (0),
                  options.plan.cell,
                  "edge of a cell (by the density: some 20 points in one)");
  line.addNumber ("tile",
                  "M",
                  Range::above (0),
                  options.plan.tile,
                  "edge of a tile, rounded to 4 cells (256 cells)");
  line.addNumber ("jobs",
                  "N",
                  Range::from (0).upTo (most_jobs),
                  options.jobs,
                  "tiles at a time; 0: one for each processor (1)");
  line.addText ("plan",
                "FILE",
                options.plan_file,
                "the plan to follow; written if there is none (DIR/work/plan.json)");
  line.addText ("planes",
                "FILE",
                options.planes,
                "write planes, all or those to keep: .geojson, .csv or .json");
  line.addText ("image",
                "FILE.png",
                options.image,
                "draw the same planes from above, by plane and by orientation");
  declareMap (line, options.map);
  line.addFlag ("dry-run", options.dry_run, "print the plan, and do nothing");
  line.addFlag ("quiet", options.quiet, "print nothing");
  declareChoice (line, options.choice);
  if (!line.parse (argc, argv))
    return false;
  if (options.output_dir.empty())
    throw UsageError ("--output-dir", "is missing; give a folder for the outputs");
  checkPlanes (line, options);
  return true;
}

} // namespace pcl_ops::apps
