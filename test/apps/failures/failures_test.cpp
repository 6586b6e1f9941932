// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include "failing_program.h"
#include <io/laz_file.h>
#include <support/las_bytes.h>

#include <fstream>

namespace fs = std::filesystem;

namespace {

/** \brief A floor and a wall of 2 m by 2 m.
 * \param[in] side how many points there are along each edge */
void
saveScene (const std::string& file, int side = 50)
{
  const float step = 2.0f / static_cast<float> (side);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const float x = step * static_cast<float> (i);
      const float y = step * static_cast<float> (j);
      cloud.emplace_back (x, y, 0.0f);
      cloud.emplace_back (2.0f, y, x + step / 2.0f);
    }
  pcl::io::savePCDFileBinary (file, cloud);
}

void
saveLas (const std::string& file)
{
  LasRecipe recipe;
  recipe.points.clear();
  for (std::int32_t i = 0; i < 50; ++i)
    for (std::int32_t j = 0; j < 50; ++j) {
      recipe.points.push_back ({40 * i, 40 * j, 0});
      recipe.points.push_back ({2000, 40 * j, 40 * i + 20});
    }
  std::ofstream (file, std::ios::binary) << lasBytes (recipe);
}

void
saveText (const std::string& file)
{
  std::ofstream text (file);
  for (int i = 0; i < 2500; ++i)
    text << 500000 + i / 50 << ' ' << 5400000 + i % 50 << " 100\n";
}

const std::string segment = PCL_OPS_SEGMENT_PROGRAM, tiles = PCL_OPS_TILES_PROGRAM,
                  simulate = PCL_OPS_SIMULATE_PROGRAM;

/** \brief Every output of every program that needs no display. */
std::vector<Output>
allOutputs ()
{
  std::vector<Output> outputs = {
      {"Cloud", segment, "in.pcd OUT", "out/a.pcd", "out/a.pcd"},
      {"Ply", segment, "in.pcd OUT", "out/a.ply", "out/a.ply"},
      {"Las", segment, "in.las OUT", "out/a.las", "out/a.las"},
      {"LasDistances", segment, "in.las OUT --distances", "out/a.las", "out/a.las"},
      {"OfText", segment, "in.xyz OUT", "out/a.pcd", "out/a.pcd"},
      {"Threads", segment, "in.pcd OUT --threads 4", "out/a.pcd", "out/a.pcd"},
      {"Rest", segment, "in.pcd --rest OUT", "out/a.pcd", "out/a.pcd"},
      {"PlyRest", segment, "in.pcd --rest OUT", "out/a.ply", "out/a.ply"},
      {"Json", segment, "in.pcd --planes OUT", "out/a.json", "out/a.json"},
      {"GeoJson", segment, "in.pcd --planes OUT", "out/a.geojson", "out/a.geojson"},
      {"Csv", segment, "in.pcd --planes OUT", "out/a.csv", "out/a.csv"},
      {"Picture", segment, "in.pcd --image OUT", "out/a.png", "out/a.png"},
      {"PlyMesh", segment, "in.pcd --mesh OUT", "out/a.ply", "out/a.ply"},
      {"VtkMesh", segment, "in.pcd --mesh OUT", "out/a.vtk", "out/a.vtk"},
      {"PlyEdges", segment, "in.pcd --edges OUT", "out/a.ply", "out/a.ply"},
      {"VtkEdges", segment, "in.pcd --edges OUT", "out/a.vtk", "out/a.vtk"},
      {"JsonEdges", segment, "in.pcd --edges OUT", "out/a.json", "out/a.json"},
      {"Planes", segment, "in.pcd --planes-dir OUT", "out", "out/plane_017_other.pcd"},
      {"PlyPlanes",
       segment,
       "in.pcd --format ply --planes-dir OUT",
       "out",
       "out/plane_017_other.pcd"},
      {"PlyBatch",
       segment,
       "in.pcd --format ply --output-dir OUT",
       "out",
       "out/in.json"},
      {"Batch", segment, "in.pcd --output-dir OUT", "out", "out/in.json"},
      {"Track",
       segment,
       "clouds --output-dir OUT --track --poses poses.txt --jobs 2",
       "out",
       "out/scene.json"},
      {"Walk",
       simulate,
       "OUT --scene walk --frames 2 --width 16 --height 16",
       "out",
       "out/poses.txt"},
      {"Tiles", tiles, "in.las --output-dir OUT", "out", "out/planes.json"},
      {"Town",
       simulate,
       "OUT --scene town --points 500",
       "out",
       "out/town_001_001.las"},
      {"Simulated", simulate, "OUT --points 500", "out/a.pcd", "out/a.pcd"}};
#ifdef PCL_OPS_BENCHMARK_PROGRAM
  const std::string benchmark = PCL_OPS_BENCHMARK_PROGRAM,
                    measured = "simulated:500 --no-peers --runs 1 --memory-points 500 "
                               "--scaling-points 500,1000 ";
  outputs.push_back (
      {"Numbers", benchmark, measured + "--json OUT", "out/a.json", "out/a.json"});
  outputs.push_back (
      {"Scaling", benchmark, measured + "--scaling OUT", "out", "out/scaling.csv"});
#endif
  if (pcl_ops::apps::hasLaszip())
    outputs.push_back ({"Laz", segment, "in.las OUT", "out/a.laz", "out/a.laz"});
  return outputs;
}

constexpr int most_writes = 100;

/** \brief A folder with a scene, a folder for the output, and the program. */
class Failures : public testing::TestWithParam<Output> {
protected:
  Failures()
  {
    fs::create_directories (program_.folder() / "clouds");
    fs::create_directories (program_.folder() / "out");
    saveScene (program_.folder() / "in.pcd");
    saveLas (program_.folder() / "in.las");
    saveText (program_.folder() / "in.xyz");
    saveScene (program_.folder() / "clouds/scene.pcd");
    std::ofstream (program_.folder() / "poses.txt") << "0 0 0 0 0 0 0 1\n";
    program_.protect();
  }

  bool
  isFolder () const
  {
    return fs::path (GetParam().file).extension().empty();
  }

  FailingProgram program_{GetParam()};
};

/** \brief Gives a program more and more memory until it has enough; before, it says
 * that it has not. */
void
expectMemoryIsMissed (const FailingProgram& program)
{
  constexpr int step = 4'000, most = 1'000'000; // [kB]
  int limit = step;
  const auto run = [&] {
    return program.run ("", "ulimit -v " + std::to_string (limit));
  };
  // Until there is room for the program itself.
  constexpr int not_loaded = 127;
  while (run().exit_code == not_loaded && limit < most)
    limit += step;
  // With luck that run had enough: a run of many files would find its work done.
  fs::remove_all (program.folder() / "out");
  fs::create_directories (program.folder() / "out");
  program.protect();
  for (; limit < most; limit += step) {
    SCOPED_TRACE (std::to_string (limit) + " kB");
    const Ending ending = run();
    if (ending.exit_code == 0)
      break;
    program.expectPromise (ending, "memory");
    if (testing::Test::HasFailure())
      return;
  }
  EXPECT_LT (limit, most);
}

std::string
nameOf (const testing::TestParamInfo<Output>& info)
{
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P (All, Failures, testing::ValuesIn (allOutputs()), nameOf);

} // namespace

TEST_P (Failures, ADiskThatIsFullAtAnyWriteIsSaidAndHarmsNothing)
{
  int write = 1;
  for (; write < most_writes; ++write) {
    SCOPED_TRACE ("full at write " + std::to_string (write));
    const Ending ending = program_.run ("FULL_AT_WRITE=" + std::to_string (write));
    if (ending.exit_code == 0)
      break;
    program_.expectPromise (ending, GetParam().file);
    if (HasFailure())
      return;
    fs::remove_all (program_.folder() / "out"); // or a run of many files goes on
    fs::create_directories (program_.folder() / "out");
    program_.protect();
  }
  EXPECT_GT (write, 1) << "nothing was written";
  EXPECT_LT (write, most_writes);
}

TEST_P (Failures, ARunKilledAtAnyWriteLeavesTheOldFileAndIsRunAgain)
{
  int write = 1;
  for (; write < most_writes; ++write) {
    SCOPED_TRACE ("killed at write " + std::to_string (write));
    const Ending ending = program_.run ("KILLED_AT_WRITE=" + std::to_string (write));
    if (ending.exit_code == 0)
      break;
    EXPECT_EQ (ending.exit_code, killed) << ending.errors;
    ASSERT_TRUE (program_.isAsBefore());
  }
  EXPECT_GT (write, 1) << "nothing was written";
  EXPECT_FALSE (program_.isAsBefore()) << "the last run was not hindered";
}

TEST_P (Failures, AFolderThatCannotBeWrittenToIsNamed)
{
  program_.expectPromise (program_.run ("READ_ONLY=1"), GetParam().file);
}

TEST_P (Failures, ANameTooLongIsSaidToBe)
{
  const std::string name = (isFolder() ? "" : "out/") + std::string (256, 'n') +
                           fs::path (GetParam().file).extension().string();
  const Ending ending = program_.run ("", "", name);
  program_.expectPromise (ending, name);
  EXPECT_NE (ending.errors.find ("too long"), std::string::npos) << ending.errors;
}

TEST_P (Failures, ANameAsLongAsTheFolderTakesIsFine)
{
  const std::string extension = fs::path (GetParam().file).extension().string();
  const Ending ending =
      program_.run ("",
                    "",
                    (isFolder() ? "" : "out/") +
                        std::string (255 - extension.size(), 'n') + extension);
  EXPECT_EQ (ending.exit_code, 0) << ending.errors;
}

TEST_P (Failures, AnEmptyNameIsWrongUsage)
{
  program_.expectPromise (program_.run ("", "", ""), "", 2);
}

TEST_P (Failures, TooLittleMemoryIsSaidAndHarmsNothing)
{
  expectMemoryIsMissed (program_);
}

TEST_P (Failures, NoThreadIsNoFailure)
{
  const Ending ending = program_.run ("THREADS_TO_START=0");
  EXPECT_EQ (ending.exit_code, 0) << ending.errors;
}

TEST (FailingThreads, DoNotKeepABatchFromItsClouds)
{
  const FailingProgram program (
      {"", segment, "a.pcd b.pcd --output-dir OUT --jobs 4", "out", ""});
  saveScene (program.folder() / "a.pcd");
  saveScene (program.folder() / "b.pcd");
  const Ending ending = program.run ("THREADS_TO_START=0");
  EXPECT_EQ (ending.exit_code, 0) << ending.errors;
  EXPECT_TRUE (fs::exists (program.folder() / "out/b.json"));
}

TEST (FailingMemory, IsNotTakenForADamagedCloud)
{
  const FailingProgram program ({"", segment, "in.pcd OUT --quiet", "a.pcd", "a.pcd"});
  saveScene (program.folder() / "in.pcd", 500);
  program.protect();
  expectMemoryIsMissed (program);
}

TEST (FailingFile, ThatOutgrowsTheLimitOfTheUserIsNotTheProgramsEnd)
{
  const FailingProgram program ({"", segment, "in.pcd OUT", "a.pcd", "a.pcd"});
  saveScene (program.folder() / "in.pcd");
  program.protect();
  program.expectPromise (program.run ("", "ulimit -f 1"), "a.pcd");
}

TEST (FailingPipe, IsSaidToNeedRoomForTemporaryFiles)
{
  const FailingProgram program ({"", segment, "- OUT <in.pcd", "a.pcd", "a.pcd"});
  saveScene (program.folder() / "in.pcd");
  program.protect();
  program.expectPromise (program.run ("FULL_AT_WRITE=1", "export TMPDIR=."),
                         "standard input");
}
