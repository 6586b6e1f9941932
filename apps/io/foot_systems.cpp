// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "foot_systems.h"

#include <algorithm>
#include <iterator>

namespace pcl_ops::apps {

namespace {

/** \brief The numbers first, first + step, first + 2 step and so on, up to last, which
 * is one of them. */
struct NumberRange {
  unsigned first, last, step;
};

/** \brief The numbers of the 933 projected systems of the EPSG Geodetic Parameter
 * Dataset, version 10.076, whose axes are in feet (unit 9002) or US survey feet (unit
 * 9003). To have fewer rows, the table also has numbers that the dataset gives to no
 * projected system. It has no number of a projected or compound system in another unit.
 */
constexpr NumberRange systems_in_feet[] = {
    {2155, 2155, 1},   {2194, 2194, 1},   {2204, 2204, 1},   {2222, 2289, 1},
    {2867, 2930, 1},   {2964, 2968, 1},   {2992, 2994, 2},   {3080, 3080, 1},
    {3089, 3091, 2},   {3102, 3102, 1},   {3359, 3365, 2},   {3404, 3404, 1},
    {3417, 3438, 1},   {3441, 3446, 1},   {3451, 3459, 1},   {3479, 3487, 2},
    {3490, 3512, 2},   {3515, 3553, 2},   {3560, 3570, 1},   {3582, 3590, 2},
    {3590, 3593, 3},   {3598, 3600, 2},   {3605, 3608, 3},   {3608, 3636, 2},
    {3640, 3664, 2},   {3668, 3676, 2},   {3674, 3686, 3},   {3676, 3682, 3},
    {3686, 3692, 2},   {3696, 3700, 2},   {3728, 3739, 1},   {3753, 3760, 1},
    {3991, 3992, 1},   {4217, 4217, 1},   {4399, 4413, 1},   {4418, 4433, 1},
    {4438, 4457, 1},   {5588, 5588, 1},   {5623, 5625, 1},   {5646, 5646, 1},
    {5654, 5655, 1},   {6128, 6129, 1},   {6141, 6141, 1},   {6200, 6202, 1},
    {6391, 6391, 1},   {6405, 6413, 2},   {6416, 6438, 2},   {6441, 6479, 2},
    {6484, 6496, 2},   {6499, 6507, 2},   {6507, 6510, 3},   {6515, 6565, 2},
    {6568, 6578, 2},   {6582, 6590, 2},   {6593, 6609, 2},   {6612, 6618, 2},
    {6625, 6627, 1},   {6633, 6633, 1},   {6785, 6863, 2},   {6868, 6880, 12},
    {6885, 6887, 2},   {6923, 6925, 2},   {6966, 6966, 1},   {6997, 6997, 1},
    {7057, 7070, 1},   {7119, 7128, 1},   {7132, 7132, 1},   {7258, 7370, 2},
    {7587, 7645, 1},   {8035, 8036, 1},   {8065, 8068, 1},   {8091, 8093, 2},
    {8096, 8182, 2},   {8177, 8177, 1},   {8185, 8197, 4},   {8200, 8210, 2},
    {8210, 8216, 3},   {8220, 8220, 1},   {8224, 8348, 2},   {8380, 8384, 2},
    {8384, 8387, 3},   {8518, 8540, 1},   {9748, 9749, 1},   {20050, 20050, 1},
    {26729, 26813, 1}, {26847, 26870, 1}, {32001, 32058, 1}, {32064, 32077, 1},
    {32099, 32099, 1}, {32164, 32167, 1}, {32664, 32667, 1}};

} // namespace

bool
isInFeet (unsigned epsg)
{
  return std::any_of (std::begin (systems_in_feet),
                      std::end (systems_in_feet),
                      [epsg] (const NumberRange& range) {
                        return epsg >= range.first && epsg <= range.last &&
                               (epsg - range.first) % range.step == 0;
                      });
}

} // namespace pcl_ops::apps
