// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "data_sets.h"
#include <cli/errors.h>
#include <png.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <set>

namespace pcl_ops::evaluation {

namespace {

namespace fs = std::filesystem;

const std::string raw_folder = "depth", refined_folder = "depth_bfx";

/** \throw apps::WorkError with the problem of the file if the condition is not met */
void
require (bool condition, const fs::path& file, const std::string& problem)
{
  if (!condition)
    throw apps::WorkError (file.string(), problem);
}

/** Returns the last file of a folder by name.
 * \param[in] extension of the files, with its dot
 * \throw apps::WorkError if there is no such file */
fs::path
lastFileIn (const fs::path& folder, const std::string& extension)
{
  fs::path last;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator (folder, ignored))
    if (entry.path().extension() == extension)
      last = std::max (last, entry.path());
  require (
      !last.empty(), folder, "has no " + extension + " file; the frame is incomplete");
  return last;
}

/** Reads a text file of the matrix, row by row, with no text behind it. */
template <int Rows, int Columns>
Eigen::Matrix<double, Rows, Columns>
readMatrix (const fs::path& file)
{
  std::ifstream stream (file);
  require (bool (stream), file, "cannot be read; the frame is incomplete");
  Eigen::Matrix<double, Rows, Columns> matrix;
  for (int row = 0; row < Rows; ++row)
    for (int column = 0; column < Columns; ++column)
      stream >> matrix (row, column);
  std::string rest;
  require (stream && !(stream >> rest) && matrix.allFinite(),
           file,
           "is no matrix of " + std::to_string (Rows) + " x " +
               std::to_string (Columns) + " numbers; get the file again");
  return matrix;
}

using DepthImage =
    Eigen::Matrix<std::uint16_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/** Whether a PNG file says its gamma: a chunk of a gamma, of the color space sRGB or of
 * a color profile comes before the pixels, the chunk IDAT. */
bool
hasGamma (const std::string& bytes)
{
  const std::string before_pixels = bytes.substr (0, bytes.find ("IDAT"));
  for (const char* chunk : {"gAMA", "sRGB", "iCCP"})
    if (before_pixels.find (chunk) != std::string::npos)
      return true;
  return false;
}

/** Reads a 16-bit grayscale PNG file (ISO/IEC 15948). It calls libpng directly, because
 * VTK's reader, which PCL uses, crashes on a truncated file. */
DepthImage
readDepthPng (const fs::path& file)
{
  const auto requirePng = [&file] (bool condition, const std::string& problem) {
    require (condition, file, problem + "; get the file again");
  };
  // The last chunk of every PNG file: length 0, type and checksum.
  static const std::string end_chunk ("\0\0\0\0IEND\xae\x42\x60\x82", 12);
  std::ifstream stream (file, std::ios::binary);
  const std::string bytes (std::istreambuf_iterator<char> (stream), {});
  requirePng (bytes.size() > end_chunk.size() &&
                  bytes.compare (bytes.size() - end_chunk.size(),
                                 end_chunk.size(),
                                 end_chunk) == 0,
              "cannot be read, or is no whole PNG file");
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const bool has_header =
      png_image_begin_read_from_memory (&png, bytes.data(), bytes.size()) != 0;
  const std::unique_ptr<png_image, void (*) (png_imagep)> freed (&png, png_image_free);
  requirePng (has_header, std::string ("is no whole PNG file (") + png.message + ")");
  // libpng would convert the values of an image with another format or a gamma.
  requirePng (png.format == PNG_FORMAT_LINEAR_Y && !hasGamma (bytes),
              "is no depth image, which is 16-bit gray without a gamma");
  // Far above any depth camera, far below what would exhaust the memory.
  constexpr std::size_t max_pixels = 100'000'000;
  requirePng (png.width <= max_pixels / png.height, "has an impossible size");
  DepthImage image (png.height, png.width);
  const int is_read = png_image_finish_read (&png, nullptr, image.data(), 0, nullptr);
  requirePng (is_read != 0, std::string ("is damaged (") + png.message + ")");
  return image;
}

/** Returns the points of a depth image in a frame with x to the right, y forward and z
 * against gravity [m].
 * \param[in] image depth [mm], its 16 bits rotated left by 3; 0: no reading
 * \param[in] intrinsics pinhole camera matrix [pixel]
 * \param[in] extrinsics rotation from the camera's frame (x right, y down, z forward)
 * to a frame of the same axes, but with y along gravity */
EvaluationCloud
cloudOf (const DepthImage& image,
         const Eigen::Matrix3d& intrinsics,
         const Eigen::Matrix3d& extrinsics)
{
  constexpr double meters_per_millimeter = 0.001;
  constexpr double max_depth = 8.0; // [m], see data_sets.h
  // From x right, y along gravity, z forward to x right, y forward, z against gravity.
  Eigen::Matrix3d gravity_to_z_up;
  gravity_to_z_up << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  const Eigen::Matrix3d rotation = gravity_to_z_up * extrinsics;
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const XyzCloud::Ptr cloud (
      new XyzCloud (image.cols(), image.rows(), pcl::PointXYZ (nan, nan, nan)));
  cloud->sensor_orientation_ = Eigen::Quaterniond (rotation).cast<float>();
  for (Eigen::Index i = 0; i < image.size(); ++i) {
    const std::uint16_t stored = image.data()[i];
    if (stored == 0)
      continue;
    // The stored bits are rotated back to the right by 3.
    const auto millimeters = std::uint16_t (stored >> 3 | stored << 13);
    const double depth = std::min (millimeters * meters_per_millimeter, max_depth);
    const Eigen::Index column = i % image.cols();
    const Eigen::Index row = i / image.cols();
    const double x = (column - intrinsics (0, 2)) / intrinsics (0, 0) * depth;
    const double y = (row - intrinsics (1, 2)) / intrinsics (1, 1) * depth;
    const Vector3d point (x, y, depth);
    (*cloud)[i].getVector3fMap() = (rotation * point).cast<float>();
  }
  return finiteOf (cloud, {});
}

/** \param[in] frame folder of the frame */
EvaluationCloud
readFrame (const fs::path& frame, bool is_raw)
{
  constexpr double max_rotation_error = 1e-3; // of each element of R R^T - I
  const fs::path intrinsics_file = frame / "intrinsics.txt";
  const Eigen::Matrix3d intrinsics = readMatrix<3, 3> (intrinsics_file);
  require (intrinsics (0, 0) > 0.0 && intrinsics (1, 1) > 0.0,
           intrinsics_file,
           "has a focal length that is not positive; get the file again");
  const fs::path extrinsics_file = lastFileIn (frame / "extrinsics", ".txt");
  const Eigen::Matrix3d rotation = readMatrix<3, 4> (extrinsics_file).leftCols<3>();
  const Eigen::Matrix3d error =
      rotation * rotation.transpose() - Eigen::Matrix3d::Identity();
  const bool is_rotation = error.cwiseAbs().maxCoeff() <= max_rotation_error &&
                           rotation.determinant() >= 0.0;
  require (is_rotation, extrinsics_file, "holds no rotation; get the file again");
  const fs::path depth_file =
      lastFileIn (frame / (is_raw ? raw_folder : refined_folder), ".png");
  EvaluationCloud result = cloudOf (readDepthPng (depth_file), intrinsics, rotation);
  require (
      !result.cloud->empty(), depth_file, "has no reading at all; leave the frame out");
  return result;
}

} // namespace

DataSet
sunRgbdDataSet (const std::string& folder, bool is_raw)
{
  std::set<fs::path> frames;
  std::error_code ignored; // without a folder, no frame is found
  std::error_code error;   // of a folder below that cannot be read, which ends the loop
  constexpr auto with_links = fs::directory_options::follow_directory_symlink;
  for (fs::recursive_directory_iterator entry (folder, with_links, ignored), end;
       entry != end;
       entry.increment (error)) {
    const fs::path name = entry->path().filename();
    if ((name == raw_folder || name == refined_folder) && entry->is_directory (ignored))
      frames.insert (entry->path().parent_path());
  }
  require (!error,
           folder,
           "has a folder that cannot be read (" + error.message() +
               "); change its permissions");
  require (!frames.empty(),
           folder,
           "has no SUN RGB-D frame (a folder with depth or depth_bfx, "
           "intrinsics.txt and extrinsics); give the folder SUNRGBD");
  DataSet clouds;
  fs::path root (folder); // without a slash at its end, as the paths of frames
  if (!root.has_filename())
    root = root.parent_path();
  // If the folder is itself a frame, the cloud has the name of the folder.
  const fs::path base = frames.count (root) == 0 ? root : root.parent_path();
  for (const fs::path& frame : frames)
    clouds.push_back ({is_raw ? "sunrgbd-raw" : "sunrgbd",
                       frame.lexically_relative (base).generic_string(),
                       [frame, is_raw] { return readFrame (frame, is_raw); }});
  return clouds;
}

} // namespace pcl_ops::evaluation
