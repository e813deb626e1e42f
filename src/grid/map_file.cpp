#include "vfh_astar/grid/map_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "vfh_astar/yaml_field.h"

namespace vfh_astar {
namespace {

constexpr double kFarthestOrigin = 1e6;  // m
constexpr int kOccupied = 100;
constexpr int kWhite = 255;

// What map_saver takes as free and as occupied, percent, and draws it with.
constexpr int kSavedFreeUpTo = 25;
constexpr int kSavedOccupiedFrom = 65;
constexpr char kFreeGrey = static_cast<char>(254);
constexpr char kUnknownGrey = static_cast<char>(205);
constexpr char kOccupiedGrey = 0;

/// The yaml beside a map's image.
struct MapDescription {
  std::string image;
  double resolution = 0.0;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  bool negate = false;
  double occupied_threshold = 0.0;
  double free_threshold = 0.0;
  std::string mode = "trinary";
};

MapDescription ReadDescription(const std::string& yaml_file) {
  const YamlField root = YamlField::LoadFile(yaml_file);
  MapDescription description;
  // A path that starts at the root stays what it is.
  description.image =
      (std::filesystem::path(yaml_file).parent_path() / root["image"].Text())
          .string();
  if (!std::filesystem::is_regular_file(description.image)) {
    root["image"].Fail("an image (PGM, PNG), from the folder of this file on");
  }
  description.resolution = root["resolution"].Number(1e-4, 1e3);
  const std::vector<double> origin =
      root["origin"].Numbers(3, kFarthestOrigin, "[x, y, yaw] in m and rad");
  if (origin[2] != 0.0) root["origin"].Fail("a yaw of 0");
  description.origin = Eigen::Vector2d(origin[0], origin[1]);
  description.negate = root["negate"].Flag();
  description.occupied_threshold = root["occupied_thresh"].Number(0.0, 1.0);
  description.free_threshold = root["free_thresh"].Number(0.0, 1.0);
  if (description.free_threshold >= description.occupied_threshold) {
    root["free_thresh"].Fail("less than occupied_thresh");
  }
  if (root["mode"].Exists()) {
    description.mode = root["mode"].Choice({"trinary", "scale", "raw"});
  }
  return description;
}

cv::Mat ReadImage(const std::string& file) {
  const std::string expected = "; expected an image (PGM, PNG) of 8 or 16 bit";
  cv::Mat image;
  try {
    image = cv::imread(file, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception& error) {
    throw MapFileError(file + ": " + error.err + expected);
  }
  if (image.empty()) {
    throw MapFileError(file + ": truncated or malformed" + expected);
  }
  if (image.depth() == CV_16U) {
    image.convertTo(image, CV_8U, 1.0 / 257.0);
  } else if (image.depth() != CV_8U) {
    throw MapFileError(file + ": another depth" + expected);
  }
  return image;
}

/// A pixel as map_server sees it.
struct Pixel {
  double grey = 0.0;  // 0 to 255.
  bool transparent = false;
};

Pixel ReadPixel(const cv::Mat& image, int row, int column, bool mix_alpha) {
  const int channels = image.channels();
  const bool has_alpha = channels == 4;
  const int averaged = has_alpha && !mix_alpha ? channels - 1 : channels;
  const unsigned char* values = image.ptr(row) + column * channels;
  int sum = 0;
  for (int i = 0; i < averaged; ++i) sum += values[i];
  return {static_cast<double>(sum) / averaged,
          has_alpha && values[channels - 1] == 0};
}

std::int8_t ToOccupancy(const MapDescription& description, const Pixel& pixel) {
  const double grey = description.negate ? kWhite - pixel.grey : pixel.grey;
  if (description.mode == "raw") {
    // 255 is how map_server writes unknown; what lies between is no occupancy.
    return grey <= kOccupied ? static_cast<std::int8_t>(grey) : kUnknown;
  }
  const double occupied = (kWhite - grey) / kWhite;
  if (occupied > description.occupied_threshold) return kOccupied;
  if (occupied < description.free_threshold) return 0;
  if (description.mode == "trinary" || pixel.transparent) return kUnknown;
  return static_cast<std::int8_t>(
      99.0 * (occupied - description.free_threshold) /
      (description.occupied_threshold - description.free_threshold));
}

std::int8_t ToSolid(const MapDescription& description, const Pixel& pixel,
                    int solid_below) {
  const double grey = description.negate ? kWhite - pixel.grey : pixel.grey;
  return grey < solid_below ? kOccupied : 0;
}

void WriteWhole(const std::string& file, const std::string& content) {
  std::FILE* stream = std::fopen(file.c_str(), "wb");
  const auto fail = [&file] {
    const std::string reason = std::strerror(errno);
    std::remove(file.c_str());
    throw MapFileError(file + ": cannot be written: " + reason);
  };
  if (stream == nullptr) fail();
  // Without the sync, a power cut after the rename may leave an empty file.
  const bool written = std::fwrite(content.data(), 1, content.size(), stream) ==
                           content.size() &&
                       std::fflush(stream) == 0 && fsync(fileno(stream)) == 0;
  if (std::fclose(stream) != 0 || !written) fail();
}

std::string DrawPgm(const OccupancyGrid& map) {
  const GridGeometry& geometry = map.geometry();
  std::string pgm = "P5\n" + std::to_string(geometry.width) + " " +
                    std::to_string(geometry.height) + "\n255\n";
  pgm.reserve(pgm.size() + geometry.size());
  for (int y = geometry.height - 1; y >= 0; --y) {
    for (int x = 0; x < geometry.width; ++x) {
      const int value = map[Cell{x, y}];
      pgm += value >= kSavedOccupiedFrom             ? kOccupiedGrey
             : 0 <= value && value <= kSavedFreeUpTo ? kFreeGrey
                                                     : kUnknownGrey;
    }
  }
  return pgm;
}

/// The shortest text that reads back as the same number.
std::string ToText(double value) {
  for (int digits = std::numeric_limits<double>::digits10;; ++digits) {
    std::stringstream text;
    text << std::setprecision(digits) << value;
    double back = 0.0;
    text >> back;
    if (back == value) return text.str();
  }
}

std::string Describe(const GridGeometry& geometry, const std::string& image) {
  std::ostringstream yaml;
  yaml << "image: " << YAML::Dump(YAML::Node(image))
       << "\nresolution: " << ToText(geometry.resolution) << "\norigin: ["
       << ToText(geometry.origin.x()) << ", " << ToText(geometry.origin.y())
       << ", 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  return yaml.str();
}

}  // namespace

OccupancyGrid LoadMap(const std::string& yaml_file,
                      const MapLoadOptions& options) {
  MapDescription description;
  try {
    description = ReadDescription(yaml_file);
  } catch (const YamlFieldError& error) {
    throw MapFileError(error.what());
  }
  const cv::Mat image = ReadImage(description.image);
  GridGeometry geometry;
  geometry.resolution = description.resolution;
  geometry.origin = description.origin;
  geometry.width = image.cols;
  geometry.height = image.rows;
  OccupancyGrid map(geometry, kUnknown);
  // Odd, but what map_server does: in its trinary mode alpha counts as colour.
  const bool mix_alpha = description.mode == "trinary" && !options.solid_below;
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      const Pixel pixel = ReadPixel(image, row, column, mix_alpha);
      map[Cell{column, image.rows - 1 - row}] =
          options.solid_below
              ? ToSolid(description, pixel, *options.solid_below)
              : ToOccupancy(description, pixel);
    }
  }
  return map;
}

void SaveMap(const OccupancyGrid& map, const std::string& stem) {
  const std::string name = std::filesystem::path(stem).filename().string();
  if (name.empty()) {
    throw MapFileError("'" + stem + "' names no file; expected a path that " +
                       "ends in the map's name");
  }
  if (map.geometry().size() == 0) {
    throw MapFileError(stem + ": a map without cells cannot be written");
  }
  const std::string part = ".part";
  const std::string image = stem + ".pgm";
  const std::string yaml = stem + ".yaml";
  for (const std::string& file : {image, yaml}) {
    // Found out only at its renaming, it would leave one of two files behind.
    if (std::filesystem::is_directory(file)) {
      throw MapFileError(file + ": cannot be written: is a directory");
    }
  }
  WriteWhole(image + part, DrawPgm(map));
  try {
    WriteWhole(yaml + part, Describe(map.geometry(), name + ".pgm"));
    std::filesystem::rename(image + part, image);
    std::filesystem::rename(yaml + part, yaml);
  } catch (const std::filesystem::filesystem_error& error) {
    std::remove((image + part).c_str());
    std::remove((yaml + part).c_str());
    throw MapFileError(error.path2().string() +
                       ": cannot be written: " + error.code().message());
  } catch (const MapFileError&) {
    std::remove((image + part).c_str());
    throw;
  }
}

}  // namespace vfh_astar
