#include "vfh_astar/mapping/scan_inserter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "vfh_astar/grid/ray_traversal.h"

namespace vfh_astar {
namespace {

/// m between two neighbouring hits; farther apart they say nothing of what is
/// between them.
constexpr double kWidestGap = 2.0;

constexpr int kTile = LogOddsGrid::kTileSize;
static_assert(kTile == CellMarks::kBlockWidth);
/// In a tile, one above the other.
constexpr int kBlocks = kTile / CellMarks::kBlockHeight;

// Beams run alongside each other as far as these hold: at larger angles they
// are not near enough to parallel within a cell, and at more than half a cell
// apart (less a tenth for what is not quite parallel) one may lie between them.
constexpr double kWidestSharing = 0.04;  // rad
constexpr double kSharedWidth = 0.45;    // cells

cv::Rect Hull(const cv::Rect& a, const cv::Rect& b) {
  return a.empty() ? b : b.empty() ? a : a | b;
}

/// The cells that a box of the grid's frame touches.
cv::Rect CellsOf(const Eigen::AlignedBox2d& box, const GridGeometry& geometry) {
  // Far outside of every grid, and still a whole number.
  constexpr double kFar = 1 << 28;
  const auto cells = [&](const Eigen::Vector2d& point) {
    const Eigen::Vector2d at = ToCellUnits(geometry, point);
    return cv::Point(
        static_cast<int>(std::floor(std::clamp(at.x(), -kFar, kFar))),
        static_cast<int>(std::floor(std::clamp(at.y(), -kFar, kFar))));
  };
  return {cells(box.min()), cells(box.max()) + cv::Point(1, 1)};
}

/// For eight bits a byte of ones for each that is set.
constexpr std::array<std::array<std::uint8_t, 8>, 256> MakeSpreadBits() {
  std::array<std::array<std::uint8_t, 8>, 256> spread{};
  for (int bits = 0; bits < 256; ++bits) {
    for (int i = 0; i < 8; ++i) {
      spread[bits][i] = (bits >> i & 1) != 0 ? 0xff : 0;
    }
  }
  return spread;
}
constexpr auto kSpreadBits = MakeSpreadBits();

void ExpandBits(std::uint64_t bits, std::uint8_t* bytes) {
  for (int i = 0; i < 64; i += 8) {
    const auto& spread = kSpreadBits[bits >> i & 0xff];
    std::copy(spread.begin(), spread.end(), bytes + i);
  }
}

}  // namespace

bool IsOneSurface(const Eigen::Vector2d* before, const Eigen::Vector2d& from,
                  const Eigen::Vector2d& to, const Eigen::Vector2d* after) {
  constexpr double kStraight = 0.95;  // cosine of the turn between two gaps
  const Eigen::Vector2d gap = to - from;
  const auto goes_on = [&gap](const Eigen::Vector2d& other) {
    // A gap much shorter than this one has no direction to speak of.
    return 4.0 * other.norm() >= gap.norm() &&
           gap.dot(other) > kStraight * gap.norm() * other.norm();
  };
  return (before != nullptr && goes_on(from - *before)) ||
         (after != nullptr && goes_on(*after - to));
}

void ScanInserterParameters::Read(ParameterReader& reader) {
  reader.Number("max_urange", max_urange, 0.1, 200.0);
  reader.Number("max_range", max_range, 0.1, 1000.0);
  reader.Number("hit_probability", hit_probability, 0.51, 0.99);
  reader.Number("miss_probability", miss_probability, 0.01, 0.49);
  reader.Number("min_probability", min_probability, 0.002, 0.49);
  reader.Number("max_probability", max_probability, 0.51, 0.998);
}

ScanInserter::ScanInserter(const ScanInserterParameters& parameters)
    : parameters_(parameters),
      hit_steps_(ToLogOdds(parameters.hit_probability) - kEvenOdds),
      miss_steps_(kEvenOdds - ToLogOdds(parameters.miss_probability)),
      lowest_(ToLogOdds(parameters.min_probability)),
      highest_(ToLogOdds(parameters.max_probability)) {
  cleared_.fill(lowest_);
}

cv::Rect ScanInserter::Insert(const LaserScan& scan, const Pose2D& laser_pose,
                              LogOddsGrid& grid) {
  assert(laser_pose.IsFinite());
  if (!TraceBeams(scan, laser_pose)) return {};

  Eigen::AlignedBox2d reach(laser_pose.position());
  for (const Beam& beam : beams_) reach.extend(beam.end);
  grid.GrowToHold(CellsOf(reach, grid.geometry()));
  const cv::Rect observed = CellsOf(reach, grid.geometry());
  if ((observed & grid.geometry().Bounds()) != observed) return {};
  tiles_.x = observed.x / kTile;
  tiles_.y = observed.y / kTile;
  tiles_.width = (observed.br().x - 1) / kTile + 1 - tiles_.x;
  tiles_.height = (observed.br().y - 1) / kTile + 1 - tiles_.y;

  const Eigen::Vector2d corner(tiles_.x * kTile, tiles_.y * kTile);
  for (Beam& beam : beams_) {
    beam.end = ToCellUnits(grid.geometry(), beam.end) - corner;
  }
  MarkBeams(ToCellUnits(grid.geometry(), laser_pose.position()) - corner,
            scan.angle_increment, grid);
  SpareSurfaces(grid.geometry().resolution);

  cv::Rect changed;
  for (int row = tiles_.y; row < tiles_.br().y; ++row) {
    for (int column = tiles_.x; column < tiles_.br().x; ++column) {
      changed = Hull(changed, ApplyTile(column, row, grid));
    }
  }
  return changed;
}

void ScanInserter::FindDirections(const LaserScan& scan) {
  if (directions_.size() == scan.ranges.size() &&
      angle_min_ == scan.angle_min &&
      angle_increment_ == scan.angle_increment) {
    return;
  }
  angle_min_ = scan.angle_min;
  angle_increment_ = scan.angle_increment;
  directions_.clear();
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    directions_.emplace_back(std::cos(scan.Angle(i)), std::sin(scan.Angle(i)));
  }
}

bool ScanInserter::TraceBeams(const LaserScan& scan, const Pose2D& laser_pose) {
  FindDirections(scan);
  const Eigen::Matrix2d rotation =
      Eigen::Rotation2Dd(laser_pose.theta).toRotationMatrix();
  const Eigen::Vector2d laser = laser_pose.position();
  beams_.clear();
  bool is_any = false;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const float range = scan.ranges[i];
    double length = 0.0;
    bool is_hit = false;
    if (scan.IsFree(range)) {
      length = std::min(parameters_.max_urange, scan.range_max);
    } else if (scan.IsHit(range) && range <= parameters_.max_range) {
      is_hit = range <= parameters_.max_urange;
      length = is_hit ? range : parameters_.max_urange;
    }
    is_any = is_any || length > 0.0;
    const Eigen::Vector2d way = rotation * (length * directions_[i]);
    beams_.push_back({laser + way, length, is_hit});
  }
  return is_any;
}

double ScanInserter::SharedLength(std::size_t beam, double increment,
                                  double resolution) const {
  // Every second beam is left to its two neighbours, every fourth to those two
  // beams away, and so on.
  const std::size_t away = beam & (~beam + 1);
  if (away == 0 || beam + away >= beams_.size()) return 0.0;
  const double angle = away * std::abs(increment);
  if (angle > kWidestSharing) return 0.0;
  // Whatever its angle, a cell on the beam reaches half a cell to one side.
  const double apart = kSharedWidth * resolution / angle;
  const double reached =
      std::min(beams_[beam - away].length, beams_[beam + away].length);
  return std::max(
      0.0, std::min({apart, reached, beams_[beam].length}) - 2.0 * resolution);
}

void ScanInserter::MarkBeams(const Eigen::Vector2d& laser, double increment,
                             const LogOddsGrid& grid) {
  const double resolution = grid.geometry().resolution;
  passed_.Reset(tiles_.width, tiles_.height * kBlocks);
  passed_.CloseBlocks([&](int column, int row) {
    // Misses change nothing there.
    const LogOddsGrid::Tile* tile =
        grid.FindTile(tiles_.x + column, tiles_.y + row / kBlocks);
    return tile && std::equal(cleared_.begin(), cleared_.end(),
                              tile->begin() + row % kBlocks * cleared_.size());
  });
  ended_.Reset(tiles_.width, tiles_.height * kBlocks);
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    const Beam& beam = beams_[i];
    if (beam.length == 0.0) continue;
    const double shared = SharedLength(i, increment, resolution) / beam.length;
    passed_.MarkLine(laser + shared * (beam.end - laser), beam.end);
    if (!beam.is_hit) continue;
    ended_.Mark(static_cast<int>(beam.end.x()), static_cast<int>(beam.end.y()));
  }
}

void ScanInserter::SpareSurfaces(double resolution) {
  spared_.Reset(tiles_.width, tiles_.height * kBlocks);
  const double widest = kWidestGap / resolution;
  const auto hit_at = [this](std::size_t i) {
    return i < beams_.size() && beams_[i].is_hit ? &beams_[i].end : nullptr;
  };
  for (std::size_t i = 0; i + 1 < beams_.size(); ++i) {
    if (!beams_[i].is_hit || !beams_[i + 1].is_hit) continue;
    const Eigen::Vector2d& from = beams_[i].end;
    const Eigen::Vector2d& to = beams_[i + 1].end;
    const double gap = (to - from).norm();
    if (gap < 1.0 || gap > widest) continue;
    // Before the first beam comes none: size_t wraps beyond all.
    if (!IsOneSurface(hit_at(i - 1), from, to, hit_at(i + 2))) continue;
    spared_.MarkLine(from, to);
  }
}

cv::Rect ScanInserter::ApplyTile(int column, int row, LogOddsGrid& grid) const {
  const int strip = column - tiles_.x;
  const int first_row = (row - tiles_.y) * kTile;
  const std::uint64_t* const passed = passed_.Words(strip, first_row);
  const std::uint64_t* const ended = ended_.Words(strip, first_row);
  const std::uint64_t* const spared = spared_.Words(strip, first_row);
  LogOdds* tile = nullptr;
  std::array<std::uint8_t, kTile> changed_columns{};
  int first_changed = kTile;
  int last_changed = -1;
  for (int y = 0; y < kTile; ++y) {
    const std::uint64_t hits = ended[y];
    const std::uint64_t misses = passed[y] & ~(hits | spared[y]);
    if ((hits | misses) == 0) continue;
    if (!tile) tile = grid.MutableTile(column, row).data();
    if (!UpdateRow(misses, hits, tile + y * kTile, changed_columns)) continue;
    first_changed = std::min(first_changed, y);
    last_changed = y;
  }
  if (last_changed < 0) return {};
  const auto is_changed = [](std::uint8_t bits) { return bits != 0; };
  const auto left =
      std::find_if(changed_columns.begin(), changed_columns.end(), is_changed) -
      changed_columns.begin();
  const auto right =
      changed_columns.rend() - std::find_if(changed_columns.rbegin(),
                                            changed_columns.rend(), is_changed);
  return {column * kTile + static_cast<int>(left), row * kTile + first_changed,
          static_cast<int>(right - left), last_changed + 1 - first_changed};
}

bool ScanInserter::UpdateRow(
    std::uint64_t misses, std::uint64_t hits, LogOdds* cells,
    std::array<std::uint8_t, kTile>& changed_columns) const {
  std::array<LogOdds, kTile> old;
  std::copy(cells, cells + kTile, old.begin());
  std::array<std::uint8_t, kTile> mask;
  ExpandBits(misses, mask.data());
  const LogOdds miss = miss_steps_;
  const LogOdds highest = highest_;
  const LogOdds floor = lowest_ + miss_steps_;
  for (int x = 0; x < kTile; ++x) {
    const LogOdds known = old[x] == kUnexplored ? kEvenOdds : old[x];
    // Values beyond the limits come from a given map.
    const LogOdds held = std::min(known, highest);
    const LogOdds missed = std::max(held, floor) - miss;
    cells[x] = (missed & mask[x]) | (old[x] & ~mask[x]);
  }
  for (std::uint64_t left = hits; left != 0; left &= left - 1) {
    const int x = __builtin_ctzll(left);
    const int known = old[x] == kUnexplored ? kEvenOdds : old[x];
    cells[x] = static_cast<LogOdds>(
        std::min<int>(std::max<int>(known, lowest_) + hit_steps_, highest_));
  }
  std::uint8_t any = 0;
  for (int x = 0; x < kTile; ++x) {
    const std::uint8_t difference = old[x] ^ cells[x];
    changed_columns[x] |= difference;
    any |= difference;
  }
  return any != 0;
}

}  // namespace vfh_astar
