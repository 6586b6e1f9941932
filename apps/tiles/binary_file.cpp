// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "binary_file.h"

#include <cli/errors.h>

namespace pcl_ops::apps {

std::uint64_t
getCount (std::istream& stream, std::size_t part_size)
{
  const auto count = get<std::uint64_t> (stream);
  const std::istream::pos_type place = stream.tellg();
  stream.seekg (0, std::ios::end);
  const auto left = static_cast<std::uint64_t> (stream.tellg() - place);
  stream.seekg (place);
  if (stream && count <= left / part_size)
    return count;
  stream.setstate (std::ios::failbit);
  return 0;
}

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
failDamaged (const std::string& file)
{
  throw WorkError (file, "is damaged; remove its folder and run it again");
}

void
checkWasRead (const std::istream& stream, const std::string& file)
{
  if (!stream)
    failDamaged (file);
}

} // namespace pcl_ops::apps
