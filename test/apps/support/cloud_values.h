// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <io/cloud_file.h>

#include <cstring>
#include <string>
#include <vector>

/** \brief A field of a cloud that must have it. */
inline pcl::PCLPointField
fieldOf (const pcl_ops::apps::FileCloud& cloud, const std::string& name)
{
  for (const pcl::PCLPointField& field : cloud.points.fields)
    if (field.name == name)
      return field;
  ADD_FAILURE() << "no field " << name;
  return {};
}

/** \brief The values of a field, of each point. */
template <typename Number>
std::vector<Number>
valuesOf (const pcl_ops::apps::FileCloud& cloud, const std::string& name)
{
  std::vector<Number> values (cloud.size());
  const std::size_t offset = fieldOf (cloud, name).offset;
  for (std::size_t i = 0; i < values.size(); ++i)
    std::memcpy (&values[i],
                 &cloud.points.data[i * cloud.points.point_step + offset],
                 sizeof (Number));
  return values;
}
