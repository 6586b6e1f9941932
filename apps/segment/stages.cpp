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
  FileCloud only_xyz{{}, cloud.origin, cloud.orientation};
  only_xyz.points.width = points.width;
  only_xyz.points.height = points.height;
  struct BytesInPoint {
    std::size_t offset, size;
  };
  std::vector<BytesInPoint> coordinates;
  for (const char* axis : {"x", "y", "z"}) {
    const int index = pcl::getFieldIndex (points, axis);
    const pcl::PCLPointField& field = points.fields.at (std::size_t (index));
    addField (axis, field.datatype, only_xyz.points);
    coordinates.push_back ({field.offset, numberType (field.datatype).size});
  }
  only_xyz.points.data.reserve (cloud.size() * only_xyz.points.point_step);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (const BytesInPoint& bytes : coordinates) {
      const std::uint8_t* const from =
          points.data.data() + i * points.point_step + bytes.offset;
      only_xyz.points.data.insert (only_xyz.points.data.end(), from, from + bytes.size);
    }
  return only_xyz;
}

/** \brief Returns a new number for each region: that of the plane that shares most
 * points with it, so that both have the same color in all pictures. Each plane gives
 * its number to one region. Other regions get numbers above those of all planes.
 * \param[in] grown, joined, result of Stage::Regions, Stage::Joined and Stage::Labels */
std::vector<std::int32_t>
numbersOfRegions (const StageResult& grown,
                  const StageResult& joined,
                  const StageResult& result)
{
  const auto count_of = [] (const pcl_ops::Labels& labels) {
    return labels.empty() ? 0 : *std::max_element (labels.begin(), labels.end()) + 1;
  };
  using RegionAndPlane = std::pair<std::int32_t, std::int32_t>;
  std::map<RegionAndPlane, std::size_t> shared_points;
  for (std::size_t i = 0; i < joined.labels.size(); ++i)
    if (joined.labels[i] != no_plane && result.labels[i] != no_plane)
      ++shared_points[{joined.labels[i], result.labels[i]}];
  struct SharedPoints {
    std::int32_t region, plane;
    std::size_t points;
  };
  std::vector<SharedPoints> shares;
  for (const auto& [pair, points] : shared_points)
    shares.push_back ({pair.first, pair.second, points});
  std::stable_sort (
      shares.begin(), shares.end(), [] (const SharedPoints& a, const SharedPoints& b) {
        return a.points > b.points;
      });
  std::vector<std::int32_t> numbers (std::size_t (count_of (grown.labels)), no_plane);
  std::set<std::int32_t> used_planes;
  for (const SharedPoints& share : shares)
    if (numbers[share.region] == no_plane && used_planes.insert (share.plane).second)
      numbers[share.region] = share.plane;
  std::int32_t next = count_of (result.labels);
  for (std::int32_t& number : numbers)
    if (number == no_plane)
      number = next++;
  return numbers;
}

/** \brief Renumbers the regions of the stages by \ref numbersOfRegions. */
std::vector<StageResult>
numberedAsPlanes (std::vector<StageResult> stages)
{
  const bool has_regions = stages.size() >= std::size (all_stages);
  if (!has_regions) // a cloud of too few points has Stage::Labels alone
    return stages;
  const auto result_of = [&] (Stage stage) -> StageResult& {
    return stages[static_cast<std::size_t> (stage)];
  };
  const std::vector<std::int32_t> numbers = numbersOfRegions (
      result_of (Stage::Regions), result_of (Stage::Joined), result_of (Stage::Labels));
  for (const Stage stage : {Stage::Regions, Stage::Joined, Stage::Planes})
    for (std::int32_t& label : result_of (stage).labels)
      if (label != no_plane)
        label = numbers[label];
  return stages;
}

/** \brief Converts labels to those of files: from 1 on, 0 for no label. */
std::vector<std::uint32_t>
fileLabels (const pcl_ops::Labels& labels)
{
  static_assert (no_plane + 1 == 0);
  std::vector<std::uint32_t> file_labels;
  file_labels.reserve (labels.size());
  for (const std::int32_t label : labels)
    file_labels.push_back (static_cast<std::uint32_t> (label + 1));
  return file_labels;
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
    const bool is_gray = !result.labels.empty() && result.labels[i] == no_plane;
    if (is_gray)
      colors[i] = colorOfLabel (0);
    else if (has_values)
      colors[i] = scale (result.values[i]);
    else
      colors[i] = colorOfLabel (std::uint32_t (result.labels[i] + 1));
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
  const std::vector<std::uint32_t> labels = fileLabels (result.labels);
  // For a part of the points, from index first on.
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
  fillFolder (folder, is_ours, [&] (const fs::path& new_folder) {
    const FileCloud coordinates = coordinatesOf (cloud);
    for (const StageResult& result : numberedAsPlanes (stages)) {
      stopIfInterrupted();
      const ColorScale scale (result.values);
      const std::vector<pcl::RGB> colors = colorsOf (result, scale);
      const std::string file = (new_folder / nameOfStage (result.stage)).string();
      saveStageCloud (file + ".pcd", coordinates, result, colors);
      picture.save (file + ".png", colors, result.values.empty() ? nullptr : &scale);
    }
  });
  return stages.size() == 1 ? "a stage, as a cloud and a picture"
                            : std::to_string (stages.size()) +
                                  " stages, each as a cloud and a picture";
}

} // namespace pcl_ops::apps
