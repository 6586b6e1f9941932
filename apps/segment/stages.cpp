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

/** \brief Returns a copy of a cloud that has the fields x, y and z alone, in the types
 * of the cloud. */
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

/** \brief Number of points that a region and a plane have in common. */
struct SharedPoints {
  std::int32_t region, plane;
  std::size_t points;
};

/** \brief Returns the pairs of a region and a plane with common points, by falling
 * number of these.
 * \param[in] regions, planes label of each point */
std::vector<SharedPoints>
sharedPoints (const pcl_ops::Labels& regions, const pcl_ops::Labels& planes)
{
  using RegionAndPlane = std::pair<std::int32_t, std::int32_t>;
  std::map<RegionAndPlane, std::size_t> counts;
  for (std::size_t i = 0; i < regions.size(); ++i)
    if (regions[i] != no_plane && planes[i] != no_plane)
      ++counts[{regions[i], planes[i]}];
  std::vector<SharedPoints> shared;
  for (const auto& [pair, points] : counts)
    shared.push_back ({pair.first, pair.second, points});
  std::stable_sort (
      shared.begin(), shared.end(), [] (const SharedPoints& a, const SharedPoints& b) {
        return a.points > b.points;
      });
  return shared;
}

/** \brief Returns the number of different labels, which are counted from 0 on. */
std::int32_t
numberOfLabels (const pcl_ops::Labels& labels)
{
  return labels.empty() ? 0 : *std::max_element (labels.begin(), labels.end()) + 1;
}

/** \brief Returns a new number for each region, so that a region and its plane have the
 * same color in all pictures. Pairs of a region and a plane come by falling number of
 * common points: the region takes the number of the plane if neither has a partner yet.
 * Regions without a plane get numbers above those of all planes.
 * \param[in] regions labels of Stage::Regions
 * \param[in] joined labels of Stage::Joined, some of those in \p regions
 * \param[in] planes labels of Stage::Labels */
std::vector<std::int32_t>
numbersOfRegions (const pcl_ops::Labels& regions,
                  const pcl_ops::Labels& joined,
                  const pcl_ops::Labels& planes)
{
  std::vector<std::int32_t> numbers (std::size_t (numberOfLabels (regions)), no_plane);
  std::set<std::int32_t> used_planes;
  for (const SharedPoints& shared : sharedPoints (joined, planes))
    if (numbers[shared.region] == no_plane && used_planes.insert (shared.plane).second)
      numbers[shared.region] = shared.plane;
  std::int32_t next = numberOfLabels (planes);
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
  const std::vector<std::int32_t> numbers =
      numbersOfRegions (result_of (Stage::Regions).labels,
                        result_of (Stage::Joined).labels,
                        result_of (Stage::Labels).labels);
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

/** \brief Writes the points with the labels and values that the stage has, and rgb. */
void
saveStageCloud (const std::string& file,
                const FileCloud& coordinates,
                const StageResult& result,
                const std::vector<pcl::RGB>& colors)
{
  using pcl::PCLPointField;
  const std::vector<std::uint32_t> labels = fileLabels (result.labels);
  // Called for each part of the points; first is the index of the first point in it.
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
