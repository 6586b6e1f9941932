// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plots.h"

#include "gnuplot.h"

#include <sstream>

namespace pcl_ops::evaluation {

namespace {

struct Family {
  std::string title;
  std::string prefix;
};

/** A block of data, "index" in gnuplot's words, per family of detectors. */
const std::vector<Family> families{{"OPS", "ops"},
                                   {"FSPF", "fspf"},
                                   {"3D-KHT", "kht"},
                                   {"PCL", "pcl"},
                                   {"CGAL", "cgal"}};

std::string
headOf (const DataSetSummary& summary)
{
  return "set title '" + summary.data_set + ", truth " + summary.truth +
         "' noenhanced\n"
         "set logscale x\nset ylabel 'accuracy [%]'\nset yrange [0:100]\n";
}

/** Columns: time [s], both accuracies [%], name. */
Plot
accuracyOverTime (const DataSetSummary& summary)
{
  Plot plot{"accuracy_over_time", "", headOf (summary)};
  plot.commands += "set xlabel 'time [s]'\nset multiplot layout 2,1\n";
  std::ostringstream data;
  std::vector<std::string> titles;
  for (const Family& family : families) {
    std::ostringstream block;
    for (const ConfigurationSummary& ours : summary.configurations)
      if (ours.configuration.rfind (family.prefix, 0) == 0)
        block << ours.mean.at ("detection_ms") / 1000.0 << ' '
              << 100.0 * ours.mean.at ("classification_accuracy") << ' '
              << 100.0 * ours.mean.at ("segmentation_accuracy") << ' '
              << ours.configuration << '\n';
    if (block.str().empty())
      continue;
    data << "# " << family.title << '\n' << block.str() << "\n\n";
    titles.push_back (family.title);
  }
  plot.data = data.str();
  for (const int column : {2, 3}) {
    plot.commands += "set ylabel '" +
                     std::string (column == 2 ? "classification" : "segmentation") +
                     " accuracy [%]'\nplot ";
    for (std::size_t i = 0; i < titles.size(); ++i)
      plot.commands += (i > 0 ? ", " : "") + std::string ("'") + plot.name +
                       ".dat' index " + std::to_string (i) +
                       " using 1:" + std::to_string (column) + " title '" + titles[i] +
                       "' with points pointtype 7, '' index " + std::to_string (i) +
                       " using 1:" + std::to_string (column) +
                       ":4 notitle with labels noenhanced offset 0,0.7 font ',7'";
    plot.commands += '\n';
  }
  return plot;
}

/** Columns: sampling rate [%], both accuracies [%]; a block per number of neighbours.
 */
Plot
accuracyOverRate (const DataSetSummary& summary)
{
  Plot plot{"accuracy_over_sampling_rate", "", headOf (summary)};
  plot.commands += "set xlabel 'sampling rate [%]'\nplot ";
  std::ostringstream data;
  int blocks = 0;
  for (const std::string k : {"10", "20", "30"}) {
    std::ostringstream block;
    for (const std::string rate : {"0.3", "0.5", "0.7", "1", "3"})
      if (const auto* ours = summary.find ("ops-" + rate + "-" + k))
        block << rate << ' ' << 100.0 * ours->mean.at ("classification_accuracy") << ' '
              << 100.0 * ours->mean.at ("segmentation_accuracy") << '\n';
    if (block.str().empty())
      continue;
    data << "# " << k << " neighbours\n" << block.str() << "\n\n";
    for (const int column : {2, 3})
      plot.commands += (blocks > 0 || column > 2 ? ", " : "") + std::string ("'") +
                       plot.name + ".dat' index " + std::to_string (blocks) +
                       " using 1:" + std::to_string (column) + " title '" +
                       (column == 2 ? "classification, k " : "segmentation, k ") + k +
                       "' with linespoints";
    ++blocks;
  }
  plot.commands += '\n';
  plot.data = data.str();
  return plot;
}

} // namespace

bool
writePlots (const DataSetSummary& summary, const std::string& folder)
{
  bool all_drawn = true;
  for (const Plot& plot : {accuracyOverTime (summary), accuracyOverRate (summary)}) {
    if (plot.data.empty())
      continue;
    all_drawn = writePlot (plot, folder) && all_drawn;
  }
  return all_drawn;
}

} // namespace pcl_ops::evaluation
