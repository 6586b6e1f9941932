// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <segment/segment_program.h>
#include <support/las_bytes.h>
#include <sys/stat.h>

#include <map>

namespace fs = std::filesystem;

namespace {

/** \brief A LAS with a field of extra bytes of this name, but of a type that
 * pcl_ops_segment does not write. */
LasRecipe
withField (const std::string& name)
{
  LasRecipe recipe;
  recipe.extra = {"12", "34"};
  recipe.vlrs = {lasVlr ("LASF_Spec", 4, extraBytesField (name, las_uint16))};
  return recipe;
}

/** \brief A folder with the files of refusals.tsv. */
class Refusals : public Segment {
protected:
  Refusals()
  {
    for (const char* folder :
         {"scans", "more", "none", "planes", "folder.pcd", "room[1]"})
      fs::create_directory (folder_ / folder);
    writeWrongFiles();
    copyInput();
    fs::create_symlink ("loop.las", folder_ / "loop.las");
    fs::create_symlink ("gone", folder_ / "gone*.pcd");
    fs::create_symlink ("/dev/null", folder_ / "null.pcd");
    ::mkfifo ((folder_ / "pipe.pcd").c_str(), S_IRUSR | S_IWUSR);
  }

  /** \brief Writes in.las, poses.txt, and files with something wrong. */
  void
  writeWrongFiles () const
  {
    const std::string pcd = contentOf (folder_ / "in.pcd"), las = lasBytes ({});
    const std::string end_of_header = "DATA binary\n";
    const std::size_t begin_of_points = pcd.find (end_of_header) + end_of_header.size();
    const std::pair<const char*, std::string> files[] = {
        {"header.pcd", pcd.substr (0, begin_of_points)},
        {"half.pcd", pcd.substr (0, (begin_of_points + pcd.size()) / 2)},
        {"empty.pcd", ""},
        {"nan.xyz", "nan nan nan\n"},
        {"in.las", las},
        {"half.las", las.substr (0, las.size() - 30)},
        {"other.las", lasBytes (withField ("label"))},
        {"distance.las", lasBytes (withField ("distance"))},
        {"zeros.pcd", std::string (3'000'000, '\0')},
        {"comma.csv", "1,5 2,5 3,5\n"},
        {"scan.e57", "ASTM-E57"},
        {"half.ptx", "2\n1\n0 0 0\n"},
        {"half.bin", "half of a point"},
        {"half.npy", "\x93NUMPY\1"},
        {"half.off", "OFF\n3 1 0\n1 2 3\n"},
        {"half.obj", "v 1 2 3\nv 4 5"},
        {"named.obj", "o my house\nv 1 2 3\n"},
        {"short.xyz", "1 2 3\n4 5\n"},
        {"packed.xyz", "\x1f\x8b\x08"},
        {"poses.txt", "0 0 0 0 0 0 0 1\n"},
        {"W\xe4nde.xyz", "1 2 3\n"},
        {"room[1]/a.pcd", ""}};
    for (const auto& [name, content] : files)
      folder_.write (name, content);
  }

  void
  copyInput () const
  {
    for (const char* copy : {"scans/a.pcd",
                             "scans/b.pcd",
                             "more/b.pcd",
                             "more/in.ply",
                             "more/a_rest.pcd",
                             "planes/plane_001_horizontal.pcd",
                             "a_rest.pcd"})
      fs::copy_file (folder_ / "in.pcd", folder_ / copy);
    fs::create_hard_link (folder_ / "in.pcd", folder_ / "hard.pcd");
  }

  /** \brief All regular files in the folder, each with the time it was last written. */
  std::map<std::string, fs::file_time_type>
  files () const
  {
    std::map<std::string, fs::file_time_type> files;
    for (const auto& entry : fs::recursive_directory_iterator (folder_.path()))
      if (fs::is_regular_file (entry.symlink_status()))
        files[entry.path().string()] = entry.last_write_time();
    return files;
  }
};

} // namespace

TEST_F (Refusals, AreOneLineAndHarmNothing)
{
  const auto rows = tableIn (PCL_OPS_REFUSALS);
  ASSERT_FALSE (rows.empty());
  const auto before = files();
  for (const auto& row : rows) {
    const std::string& exit_code = row.at (0);
    const std::string& program = row.at (1);
    const std::string& arguments = row.at (2);
    const std::string& begin_of_line = row.at (3);
#ifndef PCL_OPS_HAS_VIEW
    if (program == "view")
      continue;
#endif
    SCOPED_TRACE (program + " " + arguments);
    // Temporary files that a program leaves would be among files().
    const Outcome done =
        shell ("env -u DISPLAY TMPDIR=. '" PCL_OPS_PROGRAMS "/pcl_ops_'" + program +
               " " + arguments);
    EXPECT_EQ (std::to_string (done.exit_code), exit_code);
    EXPECT_EQ (done.err.find ("pcl_ops_" + program + ": " + begin_of_line), 0u)
        << done.err;
    EXPECT_EQ (lines (done.err), 1u) << done.err;
    EXPECT_TRUE (contains (done.err, ";")) << "no fix: " << done.err;
    EXPECT_EQ (done.out, "");
    EXPECT_EQ (files(), before);
  }
}
