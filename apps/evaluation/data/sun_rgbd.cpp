// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sun_rgbd.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cli/errors.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>

namespace pcl_ops::evaluation {

namespace {

namespace fs = std::filesystem;

constexpr double meters_per_unit = 0.001;
constexpr double max_depth = 8.0; // [m]
constexpr double max_rotation_error = 1e-3;

const char*
folderOf (SunRgbdDepth depth)
{
  return depth == SunRgbdDepth::Raw ? "depth" : "depth_bfx";
}

/** The files of a folder with an extension, by name; none if there is no such folder.
 */
std::vector<fs::path>
filesIn (const fs::path& folder, const std::string& extension)
{
  std::vector<fs::path> files;
  std::error_code ignored;
  for (fs::directory_iterator entry (folder, ignored), end; entry != end;
       entry.increment (ignored))
    if (entry->path().extension() == extension)
      files.push_back (entry->path());
  std::sort (files.begin(), files.end());
  return files;
}

fs::path
lastFileIn (const fs::path& folder, const std::string& extension)
{
  const std::vector<fs::path> files = filesIn (folder, extension);
  if (files.empty())
    throw apps::WorkError (folder.string(),
                           "has no " + extension + " file; the frame is incomplete");
  return files.back();
}

/** A matrix as text, row by row, with nothing behind it. */
template <int Rows, int Columns>
Eigen::Matrix<double, Rows, Columns>
readMatrix (const fs::path& file)
{
  std::ifstream stream (file);
  if (!stream)
    throw apps::WorkError (file.string(), "cannot be read; the frame is incomplete");
  Eigen::Matrix<double, Rows, Columns> matrix;
  for (int row = 0; row < Rows; ++row)
    for (int column = 0; column < Columns; ++column)
      stream >> matrix (row, column);
  std::string rest;
  if (!stream || stream >> rest || !matrix.allFinite())
    throw apps::WorkError (file.string(),
                           "is no matrix of " + std::to_string (Rows) + " x " +
                               std::to_string (Columns) +
                               " numbers; get the file again");
  return matrix;
}

Eigen::Matrix3d
readIntrinsics (const fs::path& file)
{
  const Eigen::Matrix3d intrinsics = readMatrix<3, 3> (file);
  if (!(intrinsics (0, 0) > 0.0 && intrinsics (1, 1) > 0.0))
    throw apps::WorkError (
        file.string(), "has a focal length that is not positive; get the file again");
  return intrinsics;
}

Eigen::Matrix3d
readExtrinsics (const fs::path& file)
{
  const Eigen::Matrix3d rotation = readMatrix<3, 4> (file).leftCols<3>();
  const Eigen::Matrix3d error =
      rotation * rotation.transpose() - Eigen::Matrix3d::Identity();
  if (error.cwiseAbs().maxCoeff() > max_rotation_error || rotation.determinant() < 0.0)
    throw apps::WorkError (file.string(), "holds no rotation; get the file again");
  return rotation;
}

/** A 16-bit grayscale PNG file (ISO/IEC 15948). By libpng itself because VTK's reader,
 * the one PCL brings, crashes on a truncated file. */
DepthImage
readDepthPng (const std::string& file)
{
  const auto require = [&file] (bool is_right, const std::string& problem) {
    if (!is_right)
      throw apps::WorkError (file, problem + "; get the file again");
  };
  static const std::string end ("\0\0\0\0IEND\xae\x42\x60\x82", 12);
  std::ifstream stream (file, std::ios::binary);
  const std::string bytes (std::istreambuf_iterator<char> (stream), {});
  require (bytes.size() > end.size() &&
               bytes.compare (bytes.size() - end.size(), end.size(), end) == 0,
           "cannot be read, or is no whole PNG file");
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const bool is_begun =
      png_image_begin_read_from_memory (&png, bytes.data(), bytes.size()) != 0;
  const std::unique_ptr<png_image, void (*) (png_imagep)> owner (&png, png_image_free);
  require (is_begun, std::string ("is no whole PNG file (") + png.message + ")");
  // Values of other images would be brightened.
  require (png.format == PNG_FORMAT_LINEAR_Y &&
               bytes.find ("gAMA") > bytes.find ("IDAT"),
           "is no depth image, which is 16-bit gray without a gamma");
  /** Far above any depth camera, far below what would exhaust the memory. */
  constexpr std::size_t max_pixels = 100'000'000;
  require (png.width <= max_pixels / png.height, "has an impossible size");
  DepthImage image{png.width, png.height, {}};
  image.values.resize (image.width * image.height);
  const int is_read =
      png_image_finish_read (&png, nullptr, image.values.data(), 0, nullptr);
  require (is_read != 0, std::string ("is damaged (") + png.message + ")");
  return image;
}

bool
isFrame (const fs::path& folder)
{
  std::error_code ignored;
  return fs::is_directory (folder / folderOf (SunRgbdDepth::Raw), ignored) ||
         fs::is_directory (folder / folderOf (SunRgbdDepth::Refined), ignored);
}

void
collectFrames (const fs::path& folder, std::vector<fs::path>& frames)
{
  if (isFrame (folder)) {
    frames.push_back (folder);
    return;
  }
  std::error_code ignored;
  for (fs::directory_iterator entry (folder, ignored), end; entry != end;
       entry.increment (ignored))
    if (entry->is_directory (ignored))
      collectFrames (entry->path(), frames);
}

} // namespace

XyzCloud::Ptr
sunRgbdCloud (const DepthImage& image,
              const Eigen::Matrix3d& intrinsics,
              const Eigen::Matrix3d& extrinsics)
{
  Eigen::Matrix3d z_up; // from x right, y along gravity, z forward
  z_up << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  const Eigen::Matrix3d rotation = z_up * extrinsics;
  const double focal_x = intrinsics (0, 0), focal_y = intrinsics (1, 1);
  const double center_x = intrinsics (0, 2), center_y = intrinsics (1, 2);

  XyzCloud::Ptr cloud (new XyzCloud);
  cloud->sensor_orientation_ = Eigen::Quaterniond (rotation).cast<float>();
  for (std::size_t row = 0; row < image.height; ++row)
    for (std::size_t column = 0; column < image.width; ++column) {
      const std::uint16_t stored = image.values[row * image.width + column];
      if (stored == 0)
        continue;
      const auto millimeters = static_cast<std::uint16_t> (stored >> 3 | stored << 13);
      const double depth = std::min (millimeters * meters_per_unit, max_depth);
      const Eigen::Vector3d point (
          (static_cast<double> (column) - center_x) / focal_x * depth,
          (static_cast<double> (row) - center_y) / focal_y * depth,
          depth);
      pcl::PointXYZ rotated;
      rotated.getVector3fMap() = (rotation * point).cast<float>();
      cloud->push_back (rotated);
    }
  return cloud;
}

EvaluationCloud
readSunRgbdFrame (const std::string& folder, SunRgbdDepth depth)
{
  const fs::path frame (folder);
  const Eigen::Matrix3d intrinsics = readIntrinsics (frame / "intrinsics.txt");
  const Eigen::Matrix3d extrinsics =
      readExtrinsics (lastFileIn (frame / "extrinsics", ".txt"));
  const fs::path file = lastFileIn (frame / folderOf (depth), ".png");
  const DepthImage image = readDepthPng (file.string());
  EvaluationCloud result;
  result.cloud = sunRgbdCloud (image, intrinsics, extrinsics);
  if (result.cloud->empty())
    throw apps::WorkError (file.string(), "has no reading at all; leave the frame out");
  result.grid =
      ImageGrid{std::uint32_t (image.width), std::uint32_t (image.height), {}};
  for (std::size_t i = 0; i < image.values.size(); ++i)
    if (image.values[i] != 0)
      result.grid->pixels.push_back (std::uint32_t (i));
  return result;
}

DataSet
sunRgbdDataSet (const std::string& folder, SunRgbdDepth depth)
{
  std::vector<fs::path> frames;
  collectFrames (fs::path (folder), frames);
  if (frames.empty())
    throw apps::WorkError (folder,
                           "has no SUN RGB-D frame (a folder with depth or depth_bfx, "
                           "intrinsics.txt and extrinsics); give the folder SUNRGBD");
  std::sort (frames.begin(), frames.end());
  DataSet data_set{depth == SunRgbdDepth::Raw ? "sunrgbd-raw" : "sunrgbd", {}};
  for (const fs::path& frame : frames)
    data_set.clouds.push_back (
        {frame.lexically_relative (folder).generic_string(),
         [path = frame.string(), depth] { return readSunRgbdFrame (path, depth); }});
  return data_set;
}

} // namespace pcl_ops::evaluation
