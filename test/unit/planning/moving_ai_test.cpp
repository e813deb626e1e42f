#include "vfh_astar/planning/moving_ai.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <functional>
#include <string>

namespace vfh_astar {
namespace {

/// A file that goes when it is no longer needed.
class TextFile {
 public:
  explicit TextFile(const std::string& text)
      : name_(::testing::TempDir() + "moving_ai_test.txt") {
    std::ofstream(name_) << text;
  }
  ~TextFile() { std::remove(name_.c_str()); }
  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

const char kMap[] =
    "type octile\nheight 2\nwidth 3\nmap\n"
    ".G@\n"
    "TSW\n";

std::string ErrorOf(const std::function<void()>& read) {
  try {
    read();
  } catch (const MovingAiError& error) {
    return error.what();
  }
  return "";
}

TEST(MovingAi, ReadsAMapFromTheTop) {
  const TextFile file(kMap);
  const Grid<std::uint8_t> blocked = ReadMovingAiMap(file.name());
  EXPECT_EQ(blocked.geometry().width, 3);
  EXPECT_EQ(blocked.geometry().height, 2);
  EXPECT_EQ(blocked.cells(), (std::vector<std::uint8_t>{0, 0, 1, 1, 1, 1}));
}

TEST(MovingAi, SaysWhatIsWrongWithAMap) {
  const auto error = [](const std::string& text) {
    const TextFile file(text);
    return ErrorOf([&file] { ReadMovingAiMap(file.name()); });
  };
  EXPECT_NE(error("").find(":1: the file ends"), std::string::npos);
  EXPECT_NE(error("type tile\n").find("'type tile'"), std::string::npos);
  EXPECT_NE(error("type octile\nheight -4\n").find(":2: 'height -4'"),
            std::string::npos);
  EXPECT_NE(error("type octile\nheight 2\nwidth 3\nmap\n...\n").find(":6:"),
            std::string::npos);
  EXPECT_NE(
      error("type octile\nheight 1\nwidth 3\nmap\n....\n").find("4 cells"),
      std::string::npos);
  EXPECT_NE(error("type octile\nheight 1\nwidth 3\nmap\n..x\n").find("'x'"),
            std::string::npos);
  EXPECT_NE(ErrorOf([] { ReadMovingAiMap("/nowhere.map"); }).find("nowhere"),
            std::string::npos);
}

TEST(MovingAi, ReadsAScenario) {
  GridGeometry geometry;
  geometry.width = 3;
  geometry.height = 2;
  const TextFile file(
      "version 1\n0\tmaps/a.map\t3\t2\t0\t1\t2\t0\t2.41421356\n");
  const auto queries = ReadMovingAiScenario(file.name(), geometry);
  ASSERT_EQ(queries.size(), 1u);
  EXPECT_EQ(queries[0].start, (Cell{0, 1}));
  EXPECT_EQ(queries[0].goal, (Cell{2, 0}));
  EXPECT_EQ(queries[0].length, 2.41421356);
}

TEST(MovingAi, SaysWhatIsWrongWithAScenario) {
  GridGeometry geometry;
  geometry.width = 3;
  geometry.height = 2;
  const auto error = [&geometry](const std::string& text) {
    const TextFile file(text);
    return ErrorOf([&] { ReadMovingAiScenario(file.name(), geometry); });
  };
  EXPECT_NE(error("0 a.map").find("version 1"), std::string::npos);
  EXPECT_NE(error("version 1\n0 a.map 3 2 0 1 2\n").find(":2:"),
            std::string::npos);
  EXPECT_NE(error("version 1\n0 a.map 3 2 0 1 3 0 1.0\n").find("3 by 2"),
            std::string::npos);
  EXPECT_NE(error("version 1\n0 a.map 9 2 0 1 1 0 1.0\n").find("3 by 2"),
            std::string::npos);
}

}  // namespace
}  // namespace vfh_astar
