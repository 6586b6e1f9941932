// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::evaluation {

/** \brief An image of one 16-bit value per pixel, row by row from the top. */
struct DepthImage {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint16_t> values;
};

/** \brief Reads a 16-bit greyscale PNG file (ISO/IEC 15948), the format of depth
 * images. By libpng itself because VTK's reader, the one PCL brings, crashes on a
 * truncated file.
 * \throw apps::WorkError that names the file if it cannot be read, is truncated
 * or damaged or has another pixel format */
DepthImage
readDepthPng (const std::string& file);

} // namespace pcl_ops::evaluation
