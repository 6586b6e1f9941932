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
