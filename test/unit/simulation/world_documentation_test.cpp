#include <gtest/gtest.h>

#include <fstream>
#include <vector>

#include "temporary_folder.h"
#include "vfh_astar/simulation/world.h"

namespace vfh_astar {
namespace {

/// The YAML blocks of doc/worlds.md.
std::vector<std::string> ReadExamples() {
  std::ifstream page(VFH_ASTAR_SOURCE_DIR "/doc/worlds.md");
  std::vector<std::string> examples;
  bool in_example = false;
  for (std::string line; std::getline(page, line);) {
    if (line == "```yaml") {
      examples.emplace_back();
      in_example = true;
    } else if (line == "```") {
      in_example = false;
    } else if (in_example) {
      examples.back() += line + "\n";
    }
  }
  return examples;
}

TEST(WorldDocumentation, ItsExamplesAreWorlds) {
  const TemporaryFolder folder;
  folder.Write("office.pgm", std::string("P5\n2 1\n255\n\xcc\xfe", 13));
  folder.Write("office.yaml",
               "{image: office.pgm, resolution: 1.0, origin: [0, 0, 0], "
               "negate: 0, occupied_thresh: 0.65, free_thresh: 0.196}");
  std::size_t solids = 0;
  for (const std::string& example : ReadExamples()) {
    SCOPED_TRACE(example);
    World world;
    ASSERT_NO_THROW(world = LoadWorld(folder.Write("world.yaml", example)));
    solids += world.obstacles.size() + world.movers.size() +
              world.pop_ups.size() + world.walkers.size() + world.ground.size();
  }
  // One of each static kind, two movers, two pop-ups, one walker, one patch
  // of ground.
  EXPECT_EQ(solids, 11u);
}

}  // namespace
}  // namespace vfh_astar
