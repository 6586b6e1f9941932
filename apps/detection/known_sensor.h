// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <io/shifted_cloud.h>

#include <optional>

namespace pcl_ops::apps {

/** \brief Where the one sensor of a cloud was, in the file's frame: what \ref
 * planeKinds asks for. Nothing for clouds of several scans, and where the cloud cannot
 * have been seen from where it says; of a survey, which says nothing, it is zero if
 * that is amid the points. Looking through a cloud takes some milliseconds. */
std::optional<Eigen::Vector3d>
knownSensor (const FileCloud& cloud, const ShiftedCloud& shifted);

} // namespace pcl_ops::apps
