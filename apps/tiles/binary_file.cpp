// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "binary_file.h"

#include <cli/errors.h>

namespace pcl_ops::apps {

void
putMoments (std::ostream& stream, const Moments& moments)
{
  putBytes (stream, moments.origin.data(), 3);
  put (stream, moments.count);
  putBytes (stream, moments.sum.data(), 3);
  put (stream, moments.products);
}

Moments
getMoments (std::istream& stream)
{
  Moments moments;
  getBytes (stream, moments.origin.data(), 3);
  moments.count = get<double> (stream);
  getBytes (stream, moments.sum.data(), 3);
  moments.products = get<std::array<double, 6>> (stream);
  return moments;
}

std::ifstream
openBinary (const std::string& file)
{
  std::ifstream stream (file, std::ios::binary);
  if (!stream)
    throw WorkError (file, "cannot be read; remove its folder and run it again");
  return stream;
}

void
checkWasRead (const std::istream& stream, const std::string& file)
{
  if (!stream)
    throw WorkError (file, "is damaged; remove its folder and run it again");
}

} // namespace pcl_ops::apps
