// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/cloud_file.h>
#include <support/temporary_folder.h>
#include <support/text.h>

#include <cstring>

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

/** \brief A folder for clouds whose files are written byte by byte. */
class CloudFolder : public testing::Test {
protected:
  pcl_ops::apps::FileCloud
  load (const std::string& name, const std::string& content) const
  {
    return pcl_ops::apps::loadCloud (folder_.write (name, content));
  }

  /** \return the line that loading complains by, without the file's name */
  std::string
  complaintAbout (const std::string& file) const
  {
    const std::string text = complaintOf ([&] { pcl_ops::apps::loadCloud (file); });
    EXPECT_EQ (lines (text), 0u);
    return text.substr (text.find (file) == 0 ? file.size() + 2 : 0);
  }

  std::string
  complaintAbout (const std::string& name, const std::string& content) const
  {
    return complaintAbout (folder_.write (name, content));
  }

  TemporaryFolder folder_;
};
