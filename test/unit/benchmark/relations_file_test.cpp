#include "benchmark/relations_file.h"

#include <gtest/gtest.h>

#include <string>

#include "temporary_folder.h"

namespace vfh_astar {
namespace {

std::string ErrorOf(const std::string& file) {
  try {
    ReadRelations(file, {10.0, 20.0});
  } catch (const RelationsError& error) {
    return error.what();
  }
  return "";
}

TEST(RelationsFile, FindsThePosesByTheirTimes) {
  const TemporaryFolder folder;
  const std::string file = folder.Write("a.relations",
                                        "# t1 t2 x y z roll pitch yaw\n\n"
                                        "20.04 9.98 1.5 -0.5 0 0 0 4\n"
                                        "10 15 1 1 0 0 0 0\n");
  // Out of order, as stamps may be broken.
  const std::vector<PoseRelation> relations =
      ReadRelations(file, {20.0, 10.0, 30.0});
  ASSERT_EQ(relations.size(), 1u);
  EXPECT_EQ(relations[0].from, 0u);
  EXPECT_EQ(relations[0].to, 1u);
  EXPECT_DOUBLE_EQ(relations[0].motion.x, 1.5);
  EXPECT_DOUBLE_EQ(relations[0].motion.y, -0.5);
  EXPECT_NEAR(relations[0].motion.theta, 4.0 - 2.0 * kPi, 1e-12);
}

TEST(RelationsFile, SaysWhatIsWrongAndWhere) {
  const TemporaryFolder folder;
  EXPECT_NE(ErrorOf(folder.Write("a", "10 20 1 1 0 0 0\n"))
                .find("/a:1: '10 20 1 1 0 0 0'; expected t1 t2 x y z"),
            std::string::npos);
  EXPECT_NE(ErrorOf(folder.Write("b", "1 2 1 1 0 0 0 0\n"))
                .find("none of its 1 relations"),
            std::string::npos);
}

}  // namespace
}  // namespace vfh_astar
