// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tables.h"

#include "paper_figures.h"

#include <functional>

namespace pcl_ops::evaluation {

namespace {

constexpr double milliseconds_per_second = 1000.0;

/** What the cells of a row are made of. */
struct TableRow {
  const ConfigurationSummary& ours;
  PaperFigures paper;

  double
  seconds (const std::string& column) const
  {
    return ours.mean.at (column) / milliseconds_per_second;
  }

  /** Over all clouds, of what is a whole number for each. */
  std::string
  total (const std::string& column) const
  {
    return decimal (ours.mean.at (column) * double (ours.clouds), 0);
  }

  double
  secondsWithoutMerging () const
  {
    return seconds ("detection_ms") - seconds ("merging_ms");
  }
};

struct Column {
  std::string header;
  std::function<std::string (const TableRow&)> cell;
};

Column
fractionColumn (const std::string& header, const std::string& column)
{
  return {header, [column] (const TableRow& row) {
            return percent (row.ours.mean.at (column));
          }};
}

Column
numberColumn (const std::string& header, const std::string& column, int decimals)
{
  return {header, [column, decimals] (const TableRow& row) {
            return decimal (row.ours.mean.at (column), decimals);
          }};
}

Column
secondsColumn (const std::string& header, const std::string& column)
{
  return {header,
          [column] (const TableRow& row) { return decimal (row.seconds (column), 4); }};
}

Column
paperColumn (double PaperFigures::*figure,
             const std::function<std::string (double)>& text)
{
  return {"paper",
          [figure, text] (const TableRow& row) { return text (row.paper.*figure); }};
}

Column
paperSeconds (double PaperFigures::*figure)
{
  return paperColumn (figure, [] (double seconds) { return decimal (seconds, 4); });
}

Column
planesColumn (double PaperFigures::*figure)
{
  return paperColumn (figure, [] (double planes) { return decimal (planes, 2); });
}

/** A table before it has rows. */
struct TableKind {
  std::string title;
  /** Its configurations; empty: all. */
  std::string group;
  std::vector<Column> columns;
};

std::vector<TableKind>
paperTables ()
{
  const Column accuracy = fractionColumn ("accuracy %", "classification_accuracy");
  const Column paper_accuracy =
      paperColumn (&PaperFigures::classification_accuracy, percent);
  const Column total = secondsColumn ("total s", "detection_ms");
  const Column paper_total = paperSeconds (&PaperFigures::total);
  const Column detection{"before merging s", [] (const TableRow& row) {
                           return decimal (row.secondsWithoutMerging(), 4);
                         }};
  const Column paper_detection = paperSeconds (&PaperFigures::detection);
  const Column merging = secondsColumn ("merging s", "merging_ms");
  const Column paper_merging = paperSeconds (&PaperFigures::merging);
  return {{"Table I, FSPF by radii [m]",
           "table1",
           {accuracy,
            paper_accuracy,
            detection,
            paper_detection,
            merging,
            paper_merging,
            total,
            paper_total}},
          {"Table II, 3D-KHT by angular and radial bins",
           "table2",
           {accuracy, paper_accuracy, total, paper_total}},
          {"Table III, OPS by sampling rate [%] and neighbours; s1: strategy 1",
           "table3",
           {accuracy, paper_accuracy, detection, paper_detection, total, paper_total}},
          {"Table IV, segmentation accuracy",
           "table4",
           {fractionColumn ("accuracy %", "segmentation_accuracy"),
            paperColumn (&PaperFigures::segmentation_accuracy, percent)}}};
}

TableKind
planesTable ()
{
  return {"Planes per cloud (the paper's truth: " + decimal (paper_truth_planes, 2) +
              ")",
          "",
          {numberColumn ("before merging", "planes_before_merging", 2),
           planesColumn (&PaperFigures::planes_before_merging),
           numberColumn ("found", "result_planes", 2),
           planesColumn (&PaperFigures::planes),
           numberColumn ("truth", "truth_planes", 2)}};
}

TableKind
metricsTable ()
{
  return {"All metrics",
          "",
          {fractionColumn ("class. %", "classification_accuracy"),
           fractionColumn ("segm. %", "segmentation_accuracy"),
           fractionColumn ("all points %", "segmentation_accuracy_all"),
           numberColumn ("F 0.5", "f_score", 3),
           numberColumn ("F 0.75", "f_score_75", 3),
           numberColumn ("precision", "precision", 3),
           numberColumn ("recall", "recall", 3),
           numberColumn ("mean IoU", "mean_iou", 3),
           numberColumn ("PQ", "panoptic_quality", 3),
           numberColumn ("over", "over_segmentation", 3),
           numberColumn ("under", "under_segmentation", 3),
           numberColumn ("noise", "noise", 3),
           numberColumn ("missed", "missed", 3),
           secondsColumn ("total s", "detection_ms"),
           fractionColumn ("off planes %", off_planes_name)}};
}

template <typename Size>
TableKind
classesTable (const std::string& title,
              const char* by,
              const std::vector<SizeClass<Size>>& classes)
{
  TableKind table{title + ", found at 0.5 / at 0.75 / all", "", {}};
  for (const SizeClass<Size>& size : classes)
    table.columns.push_back (
        {rangeName (size), [names = countNames (by, size)] (const TableRow& row) {
           return row.total (names.found_50) + " / " + row.total (names.found_75) +
                  " / " + row.total (names.planes);
         }});
  return table;
}

TableKind
stagesTable ()
{
  const auto perPoint = [] (const TableRow& row) {
    constexpr double microseconds_per_millisecond = 1000.0;
    return decimal (microseconds_per_millisecond * row.ours.mean.at ("detection_ms") /
                        row.ours.mean.at ("points"),
                    3);
  };
  return {"Time per stage [s]",
          "",
          {secondsColumn ("search", "search_ms"),
           secondsColumn ("normals", "normals_ms"),
           secondsColumn ("extraction", "extraction_ms"),
           secondsColumn ("assignment", "assignment_ms"),
           secondsColumn ("merging", "merging_ms"),
           secondsColumn ("total", "detection_ms"),
           {"us per point", perPoint}}};
}

TextTable
tableOf (const DataSetSummary& summary, const TableKind& kind)
{
  TextTable table{
      kind.title + ": " + summary.data_set + ", truth " + summary.truth, {}, {}};
  table.header = {"configuration", "clouds"};
  for (const Column& column : kind.columns)
    table.header.push_back (column.header);
  for (const ConfigurationSummary& ours : summary.configurations) {
    if (!kind.group.empty() && !isInGroup (ours.configuration, kind.group))
      continue;
    const TableRow row{ours, paperFiguresOf (ours.configuration)};
    table.rows.push_back ({ours.configuration, std::to_string (ours.clouds)});
    for (const Column& column : kind.columns)
      table.rows.back().push_back (column.cell (row));
  }
  return table;
}

} // namespace

std::vector<TextTable>
tablesOf (const DataSetSummary& summary)
{
  std::vector<TableKind> kinds = paperTables();
  kinds.push_back (planesTable());
  kinds.push_back (metricsTable());
  kinds.push_back (classesTable ("True planes by points", by_points, sizeClasses ({})));
  kinds.push_back (
      classesTable ("True planes by width [m]", by_width, widthClasses ({}, {})));
  kinds.push_back (stagesTable());
  std::vector<TextTable> tables;
  for (const TableKind& kind : kinds) {
    TextTable table = tableOf (summary, kind);
    if (!table.rows.empty())
      tables.push_back (std::move (table));
  }
  return tables;
}

} // namespace pcl_ops::evaluation
