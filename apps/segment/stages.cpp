// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stages.h"

#include <cli/program.h>
#include <io/output_folder.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

/** \brief Returns "1_density" and so on. */
std::string
nameOfStage (Stage stage)
{
  return std::to_string (static_cast<int> (stage) + 1) + "_" + toString (stage);
}

/** \brief Returns a cloud with the fields x, y and z alone, of unchanged type. */
FileCloud
coordinatesOf (const FileCloud& cloud)
{
  const pcl::PCLPointCloud2& points = cloud.points;
  FileCloud alone{{}, cloud.origin, cloud.orientation};
  alone.points.width = points.width;
  alone.points.height = points.height;
  std::vector<std::pair<std::size_t, std::size_t>> parts; // offset, bytes
  for (const char* axis : {"x", "y", "z"}) {
    const int index = pcl::getFieldIndex (points, axis);
    const pcl::PCLPointField& field = points.fields.at (std::size_t (index));
    addField (axis, field.datatype, alone.points);
    parts.emplace_back (field.offset, numberType (field.datatype).size);
  }
  alone.points.data.reserve (cloud.size() * alone.points.point_step);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (const auto& [offset, size] : parts) {
      const std::uint8_t* const from =
          points.data.data() + i * points.point_step + offset;
      alone.points.data.insert (alone.points.data.end(), from, from + size);
    }
  return alone;
}

/** \brief Returns a new number for each region: that of the plane that shares most
 * points with it, so that both have the same color in all pictures. Each plane gives
 * its number to one region. Other regions get numbers after those of all planes. */
std::vector<std::int32_t>
numbersOfRegions (const StageResult& grown,
                  const StageResult& joined,
                  const StageResult& result)
{
  const auto numberOf = [] (const pcl_ops::Labels& labels) {
    return labels.empty() ? 0 : *std::max_element (labels.begin(), labels.end()) + 1;
  };
  using RegionAndPlane = std::pair<std::int32_t, std::int32_t>;
  std::map<RegionAndPlane, std::size_t> shared;
  for (std::size_t i = 0; i < joined.labels.size(); ++i)
    if (joined.labels[i] != no_plane && result.labels[i] != no_plane)
      ++shared[{joined.labels[i], result.labels[i]}];
  std::vector<std::pair<RegionAndPlane, std::size_t>> pairs (shared.begin(),
                                                             shared.end());
  std::stable_sort (pairs.begin(), pairs.end(), [] (const auto& a, const auto& b) {
    return a.second > b.second;
  });
  std::vector<std::int32_t> numbers (std::size_t (numberOf (grown.labels)), no_plane);
  std::set<std::int32_t> taken;
  for (const auto& [pair, points] : pairs)
    if (numbers[pair.first] == no_plane && taken.insert (pair.second).second)
      numbers[pair.first] = pair.second;
  std::int32_t next = numberOf (result.labels);
  for (std::int32_t& number : numbers)
    if (number == no_plane)
      number = next++;
  return numbers;
}

/** \brief Renumbers the regions of the stages by \ref numbersOfRegions. */
std::vector<StageResult>
numberedAlike (std::vector<StageResult> stages)
{
  if (stages.size() < std::size (all_stages))
    return stages;
  const auto of = [&] (Stage stage) -> StageResult& {
    return stages[static_cast<std::size_t> (stage)];
  };
  const std::vector<std::int32_t> numbers =
      numbersOfRegions (of (Stage::Regions), of (Stage::Joined), of (Stage::Labels));
  for (const Stage stage : {Stage::Regions, Stage::Joined, Stage::Planes})
    for (std::int32_t& label : of (stage).labels)
      if (label != no_plane)
        label = numbers[label];
  return stages;
}

/** \brief Converts labels to those of files: from 1 on, 0 for no label. */
std::vector<std::uint32_t>
writtenLabels (const pcl_ops::Labels& labels)
{
  std::vector<std::uint32_t> written;
  written.reserve (labels.size());
  for (const std::int32_t label : labels)
    written.push_back (static_cast<std::uint32_t> (label + 1));
  return written;
}

/** \brief Colors points by their value, or by their label if the stage has no values.
 * Points labeled no_plane are gray. */
std::vector<pcl::RGB>
colorsOf (const StageResult& result, const ColorScale& scale)
{
  const bool has_values = !result.values.empty();
  std::vector<pcl::RGB> colors (has_values ? result.values.size()
                                           : result.labels.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const bool is_none = !result.labels.empty() && result.labels[i] == no_plane;
    colors[i] = is_none      ? colorOfLabel (0)
                : has_values ? scale (result.values[i])
                             : colorOfLabel (std::uint32_t (result.labels[i] + 1));
  }
  return colors;
}

void
saveStageCloud (const std::string& file,
                const FileCloud& coordinates,
                const StageResult& result,
                const std::vector<pcl::RGB>& colors)
{
  using pcl::PCLPointField;
  const std::vector<std::uint32_t> labels = writtenLabels (result.labels);
  saveCloud (file, coordinates, [&] (FileCloud& part, std::size_t first) {
    if (!labels.empty())
      setField (part, "label", PCLPointField::UINT32, labels.data() + first);
    if (!result.values.empty())
      setField (part, "value", PCLPointField::FLOAT32, result.values.data() + first);
    setField (part, "rgb", PCLPointField::FLOAT32, colors.data() + first);
  });
}

} // namespace

std::vector<std::string>
stageFiles ()
{
  std::vector<std::string> files;
  for (const Stage stage : all_stages)
    for (const char* extension : {".pcd", ".png"})
      files.push_back (nameOfStage (stage) + extension);
  return files;
}

std::string
saveStages (const std::string& folder,
            const FileCloud& cloud,
            const std::vector<StageResult>& stages,
            const CloudPicture& picture)
{
  const std::vector<std::string> files = stageFiles();
  const auto is_ours = [&] (const std::string& name) {
    return std::find (files.begin(), files.end(), name) != files.end();
  };
  fillFolder (folder, is_ours, [&] (const fs::path& written) {
    const FileCloud coordinates = coordinatesOf (cloud);
    for (const StageResult& result : numberedAlike (stages)) {
      stopIfInterrupted();
      const ColorScale scale (result.values);
      const std::vector<pcl::RGB> colors = colorsOf (result, scale);
      const std::string file = (written / nameOfStage (result.stage)).string();
      saveStageCloud (file + ".pcd", coordinates, result, colors);
      picture.save (file + ".png", colors, result.values.empty() ? nullptr : &scale);
    }
  });
  return stages.size() == 1 ? "a stage, as a cloud and a picture"
                            : std::to_string (stages.size()) +
                                  " stages, each as a cloud and a picture";
}

} // namespace pcl_ops::apps
