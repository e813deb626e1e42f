#include "vfh_astar/grid/map_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "shared_data.h"
#include "temporary_folder.h"

namespace vfh_astar {
namespace {

constexpr char kYaml[] =
    "image: map.pgm\n"
    "resolution: 0.1\n"
    "origin: [-1.5, 2.0, 0.0]\n"
    "negate: 0\n"
    "occupied_thresh: 0.65\n"
    "free_thresh: 0.196\n";

std::string Replace(std::string text, const std::string& from,
                    const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string Pgm(int width, int height, const std::vector<int>& greys) {
  std::string pgm =
      "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
  for (const int grey : greys) pgm += static_cast<char>(grey);
  return pgm;
}

std::string FromHex(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  }
  return bytes;
}

std::vector<int> Values(const OccupancyGrid& map) {
  return {map.cells().begin(), map.cells().end()};
}

/// The error that loading the map gives, without the folder's name.
std::string ErrorOf(const TemporaryFolder& folder, const std::string& yaml) {
  try {
    LoadMap(folder.Write("map.yaml", yaml));
  } catch (const MapFileError& error) {
    return Replace(error.what(), folder.Path(""), "");
  }
  return "no error";
}

TEST(LoadMap, PutsTheLowestRowFirst) {
  const TemporaryFolder folder;
  folder.Write("map.pgm", Pgm(3, 2, {0, 254, 205, 254, 254, 0}));
  const OccupancyGrid map = LoadMap(folder.Write("map.yaml", kYaml));
  EXPECT_EQ(map.geometry().width, 3);
  EXPECT_EQ(map.geometry().height, 2);
  EXPECT_EQ(map.geometry().resolution, 0.1);
  EXPECT_EQ(map.geometry().origin, Eigen::Vector2d(-1.5, 2.0));
  EXPECT_EQ(Values(map), (std::vector<int>{0, 0, 100, 100, 0, -1}));
}

TEST(LoadMap, TrinaryThresholdsAreStrict) {
  const TemporaryFolder folder;
  // (255 - grey) / 255: 0.2, 0.6 and one grey value to each side.
  folder.Write("map.pgm", Pgm(6, 1, {205, 204, 203, 103, 102, 101}));
  std::string yaml = Replace(kYaml, "0.196", "0.2");
  yaml = Replace(yaml, "0.65", "0.6");
  EXPECT_EQ(Values(LoadMap(folder.Write("map.yaml", yaml))),
            (std::vector<int>{0, -1, -1, -1, -1, 100}));
}

TEST(LoadMap, NegateTurnsBlackAndWhite) {
  const TemporaryFolder folder;
  folder.Write("map.pgm", Pgm(3, 1, {255, 0, 100}));
  const std::string yaml = Replace(kYaml, "negate: 0", "negate: 1");
  EXPECT_EQ(Values(LoadMap(folder.Write("map.yaml", yaml))),
            (std::vector<int>{100, 0, -1}));
}

TEST(LoadMap, ScaleSpreadsWhatLiesBetweenTheThresholds) {
  const TemporaryFolder folder;
  folder.Write("map.pgm", Pgm(3, 1, {0, 255, 128}));
  const std::string yaml = std::string(kYaml) + "mode: scale\n";
  // 99 * (127 / 255 - 0.196) / (0.65 - 0.196) = 65.86
  EXPECT_EQ(Values(LoadMap(folder.Write("map.yaml", yaml))),
            (std::vector<int>{100, 0, 65}));
}

TEST(LoadMap, RawTakesGreyAsPercent) {
  const TemporaryFolder folder;
  folder.Write("map.pgm", Pgm(5, 1, {0, 37, 100, 101, 255}));
  const std::string yaml = std::string(kYaml) + "mode: raw\n";
  EXPECT_EQ(Values(LoadMap(folder.Write("map.yaml", yaml))),
            (std::vector<int>{0, 37, 100, -1, -1}));
}

TEST(LoadMap, SolidBelowOverridesTheThresholds) {
  const TemporaryFolder folder;
  folder.Write("map.pgm", Pgm(4, 1, {0, 204, 205, 254}));
  MapLoadOptions options;
  options.solid_below = 205;
  EXPECT_EQ(Values(LoadMap(folder.Write("map.yaml", kYaml), options)),
            (std::vector<int>{100, 100, 0, 0}));
}

TEST(LoadMap, ReadsOtherImages) {
  const TemporaryFolder folder;
  // A PNG of the two pixels 0 and 254.
  folder.Write("two.png",
               FromHex("89504e470d0a1a0a0000000d4948445200000002000000010800"
                       "000000d14920560000000b49444154789c6360f8070001010"
                       "0ff98b25e900000000049454e44ae426082"));
  EXPECT_EQ(Values(LoadMap(folder.Write("map.yaml",
                                        Replace(kYaml, "map.pgm", "two.png")))),
            (std::vector<int>{100, 0}));
  // 16 bit, most significant byte first: 0, 0xcdcd and 0xffff.
  folder.Write("map.pgm", "P5\n3 1\n65535\n" + FromHex("0000cdcdffff"));
  EXPECT_EQ(Values(LoadMap(folder.Write("map.yaml", kYaml))),
            (std::vector<int>{100, -1, 0}));
}

TEST(LoadMap, AlphaIsColourInTrinaryModeOnly) {
  const TemporaryFolder folder;
  // Opaque black; then a transparent grey that is 62 % occupied by the mean of
  // 128, 128, 128 and 0, and an opaque one that is 37 % by the mean with 255
  // and 49.8 % by its colour.
  folder.Write("map.pgm",
               "P7\nWIDTH 3\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\n"
               "TUPLTYPE RGB_ALPHA\nENDHDR\n" +
                   FromHex("000000ff80808000808080ff"));
  const std::string low = Replace(kYaml, "0.65", "0.6");
  EXPECT_EQ(Values(LoadMap(folder.Write("map.yaml", low))),
            (std::vector<int>{100, 100, -1}));
  const std::string scale = std::string(kYaml) + "mode: scale\n";
  EXPECT_EQ(Values(LoadMap(folder.Write("map.yaml", scale))),
            (std::vector<int>{100, -1, 65}));
}

TEST(LoadMap, ErrorsNameLineFieldAndExpectation) {
  const TemporaryFolder folder;
  folder.Write("map.pgm", Pgm(1, 1, {0}));
  const auto error = [&folder](const std::string& from, const std::string& to) {
    return ErrorOf(folder, Replace(kYaml, from, to));
  };
  EXPECT_EQ(ErrorOf(folder, kYaml), "no error");
  EXPECT_EQ(error("0.1\n", "none\n"),
            "map.yaml:2: resolution: 'none'; expected a number from 0.0001 to "
            "1000");
  EXPECT_EQ(error("0.1\n", "-0.1\n"),
            "map.yaml:2: resolution: '-0.1'; expected a number from 0.0001 to "
            "1000");
  EXPECT_EQ(error("resolution: 0.1\n", ""),
            "map.yaml:1: resolution: missing; expected a number from 0.0001 "
            "to 1000");
  EXPECT_EQ(error(", 0.0]", ", 0.5]"),
            "map.yaml:3: origin: [-1.5, 2.0, 0.5]; expected a yaw of 0");
  EXPECT_EQ(error("2.0", ".nan"),
            "map.yaml:3: origin[1]: '.nan'; expected a number from -1e+06 to "
            "1e+06");
  EXPECT_EQ(error("2.0, ", ""),
            "map.yaml:3: origin: [-1.5, 0.0]; expected [x, y, yaw] in m and "
            "rad");
  EXPECT_EQ(error("0.196", "0.65"),
            "map.yaml:6: free_thresh: '0.65'; expected less than "
            "occupied_thresh");
  EXPECT_EQ(error("negate: 0", "negate: 2"),
            "map.yaml:4: negate: '2'; expected true or false");
  EXPECT_EQ(ErrorOf(folder, std::string(kYaml) + "mode: four\n"),
            "map.yaml:7: mode: 'four'; expected one of trinary, scale, raw");
  EXPECT_EQ(ErrorOf(folder, ""), "map.yaml:1: image: missing; expected a text");
  EXPECT_EQ(ErrorOf(folder, "- 1\n"),
            "map.yaml:1: [1]; expected entries with names");
  EXPECT_NE(ErrorOf(folder, "image: [\n").find("map.yaml:2: "),
            std::string::npos);
}

TEST(LoadMap, RefusesFilesThatAreMissingTruncatedOrMalformed) {
  const TemporaryFolder folder;
  EXPECT_THROW(LoadMap(folder.Path("nothing.yaml")), MapFileError);
  EXPECT_THROW(LoadMap(folder.Path("")), MapFileError);
  EXPECT_EQ(ErrorOf(folder, kYaml),
            "map.yaml:1: image: 'map.pgm'; expected an image (PGM, PNG), from "
            "the folder of this file on");
  const std::string whole = Pgm(20, 20, std::vector<int>(400, 7));
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{2}, std::size_t{9}, whole.size() - 1}) {
    folder.Write("map.pgm", whole.substr(0, size));
    EXPECT_EQ(ErrorOf(folder, kYaml),
              "map.pgm: truncated or malformed; expected an image (PGM, PNG) "
              "of 8 or 16 bit")
        << size;
  }
  folder.Write("map.pgm", whole);
  EXPECT_EQ(ErrorOf(folder, kYaml), "no error");
}

TEST(SaveMap, WritesWhatLoadsAgain) {
  const TemporaryFolder folder;
  std::mt19937 random(3);
  GridGeometry geometry;
  geometry.resolution = 0.1 / 3.0;
  geometry.origin = Eigen::Vector2d(-1.0 / 7.0, 1e3 / 9.0);
  geometry.width = 37;
  geometry.height = 11;
  OccupancyGrid map(geometry, kUnknown);
  for (std::int8_t& value : map.cells()) {
    value = std::vector<int>{-1, 0, 100}[random() % 3];
  }
  SaveMap(map, folder.Path("saved"));
  const OccupancyGrid loaded = LoadMap(folder.Path("saved.yaml"));
  EXPECT_EQ(loaded.geometry(), geometry);
  EXPECT_EQ(loaded.cells(), map.cells());
  const std::string pgm = folder.Read("saved.pgm");
  const std::string yaml = folder.Read("saved.yaml");
  SaveMap(loaded, folder.Path("saved"));
  EXPECT_EQ(folder.Read("saved.pgm"), pgm);
  EXPECT_EQ(folder.Read("saved.yaml"), yaml);
  EXPECT_EQ(folder.size(), 2);
}

TEST(SaveMap, ThresholdsAreThoseOfMapSaver) {
  const TemporaryFolder folder;
  OccupancyGrid map({1.0, {0.0, 0.0}, 4, 1}, 0);
  map.cells() = {25, 26, 64, 65};
  SaveMap(map, folder.Path("name: with 'marks'"));
  EXPECT_EQ(Values(LoadMap(folder.Path("name: with 'marks'.yaml"))),
            (std::vector<int>{0, -1, -1, 100}));
}

TEST(SaveMap, LeavesWhatIsThereWhenItFails) {
  const TemporaryFolder folder;
  const OccupancyGrid map({1.0, {0.0, 0.0}, 4, 1}, 0);
  SaveMap(map, folder.Path("a"));
  const std::string yaml = folder.Read("a.yaml");
  const OccupancyGrid other({2.0, {0.0, 0.0}, 5, 1}, 100);
  std::filesystem::create_directory(folder.Path("a.yaml.part"));
  EXPECT_THROW(SaveMap(other, folder.Path("a")), MapFileError);
  EXPECT_EQ(folder.Read("a.yaml"), yaml);
  EXPECT_EQ(LoadMap(folder.Path("a.yaml")).cells(), map.cells());
  EXPECT_FALSE(std::filesystem::exists(folder.Path("a.pgm.part")));

  std::filesystem::create_directory(folder.Path("b.yaml"));
  EXPECT_THROW(SaveMap(other, folder.Path("b")), MapFileError);
  EXPECT_FALSE(std::filesystem::exists(folder.Path("b.pgm")));
  EXPECT_THROW(SaveMap(other, folder.Path("no_folder/c")), MapFileError);
  EXPECT_THROW(SaveMap(other, folder.Path("")), MapFileError);
  EXPECT_THROW(SaveMap(OccupancyGrid(), folder.Path("d")), MapFileError);
}

TEST(LoadMap, ReadsMapsOfOthers) {
  const std::string file =
      SharedData("maps/willow/willow-2010-02-18-0.10.yaml");
  VFH_ASTAR_SKIP_WITHOUT(file);
  const auto count = [](const OccupancyGrid& map) {
    return std::count(map.cells().begin(), map.cells().end(), 100);
  };
  const OccupancyGrid map = LoadMap(file);
  EXPECT_EQ(map.geometry().width, 566);
  EXPECT_EQ(map.geometry().height, 608);
  EXPECT_EQ(count(map), 544);
  MapLoadOptions options;
  options.solid_below = 205;
  EXPECT_EQ(count(LoadMap(file, options)), 10395);
}

}  // namespace
}  // namespace vfh_astar
