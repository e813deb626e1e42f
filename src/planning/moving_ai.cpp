#include "vfh_astar/planning/moving_ai.h"

#include <fstream>
#include <sstream>

namespace vfh_astar {
namespace {

// Rows are held in memory whole, and a header may say anything.
constexpr int kLargestSide = 16384;

[[noreturn]] void Fail(const std::string& file, int line,
                       const std::string& message) {
  throw MovingAiError(file + ":" + std::to_string(line) + ": " + message);
}

std::ifstream Open(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw MovingAiError(file + ": cannot be read");
  return stream;
}

/// The next line without a trailing carriage return.
std::string NextLine(std::istream& stream, const std::string& file, int line,
                     const std::string& expected) {
  std::string text;
  if (!std::getline(stream, text)) {
    Fail(file, line, "the file ends; expected " + expected);
  }
  if (!text.empty() && text.back() == '\r') text.pop_back();
  return text;
}

int ReadSide(std::istream& stream, const std::string& file, int line,
             const std::string& name) {
  const std::string expected =
      "'" + name + " N' with N from 1 to " + std::to_string(kLargestSide);
  const std::string text = NextLine(stream, file, line, expected);
  std::istringstream fields(text);
  std::string key;
  int value = 0;
  if (!(fields >> key >> value) || key != name || value < 1 ||
      value > kLargestSide) {
    Fail(file, line, "'" + text + "'; expected " + expected);
  }
  return value;
}

}  // namespace

Grid<std::uint8_t> ReadMovingAiMap(const std::string& file) {
  std::ifstream stream = Open(file);
  const std::string type = NextLine(stream, file, 1, "'type octile'");
  if (type != "type octile") {
    Fail(file, 1, "'" + type.substr(0, 80) + "'; expected 'type octile'");
  }
  GridGeometry geometry;
  geometry.resolution = 1.0;
  geometry.height = ReadSide(stream, file, 2, "height");
  geometry.width = ReadSide(stream, file, 3, "width");
  if (NextLine(stream, file, 4, "'map'") != "map") {
    Fail(file, 4, "expected 'map'");
  }
  Grid<std::uint8_t> blocked(geometry, 0);
  for (int y = 0; y < geometry.height; ++y) {
    const int line = y + 5;
    const std::string row = NextLine(
        stream, file, line, std::to_string(geometry.height) + " rows of cells");
    if (static_cast<int>(row.size()) != geometry.width) {
      Fail(file, line,
           std::to_string(row.size()) + " cells; expected " +
               std::to_string(geometry.width));
    }
    for (int x = 0; x < geometry.width; ++x) {
      const std::size_t kind = std::string(".G@OTSW").find(row[x]);
      if (kind == std::string::npos) {
        Fail(file, line,
             std::string("cell '") + row[x] + "' in column " +
                 std::to_string(x) + "; expected one of .G@OTSW");
      }
      blocked[{x, y}] = kind >= 2 ? 1 : 0;
    }
  }
  return blocked;
}

std::vector<MovingAiQuery> ReadMovingAiScenario(const std::string& file,
                                                const GridGeometry& geometry) {
  std::ifstream stream = Open(file);
  const std::string version = NextLine(stream, file, 1, "'version 1'");
  if (version.rfind("version 1", 0) != 0) {
    Fail(file, 1, "'" + version.substr(0, 80) + "'; expected 'version 1'");
  }
  std::vector<MovingAiQuery> queries;
  std::string text;
  for (int line = 2; std::getline(stream, text); ++line) {
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::istringstream fields(text);
    int bucket = 0;
    std::string map;
    int width = 0;
    int height = 0;
    MovingAiQuery query;
    if (!(fields >> bucket >> map >> width >> height >> query.start.x >>
          query.start.y >> query.goal.x >> query.goal.y >> query.length)) {
      Fail(file, line,
           "'" + text.substr(0, 80) +
               "'; expected bucket, map, width, height, start x and y, goal x "
               "and y, optimal length");
    }
    if (width != geometry.width || height != geometry.height ||
        !geometry.Contains(query.start) || !geometry.Contains(query.goal)) {
      Fail(file, line,
           "'" + text.substr(0, 80) + "'; expected cells of a map of " +
               std::to_string(geometry.width) + " by " +
               std::to_string(geometry.height));
    }
    queries.push_back(query);
  }
  return queries;
}

}  // namespace vfh_astar
