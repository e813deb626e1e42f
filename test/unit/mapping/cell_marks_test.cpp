#include "vfh_astar/mapping/cell_marks.h"

#include <gtest/gtest.h>

#include <bitset>
#include <random>
#include <set>
#include <utility>

namespace vfh_astar {
namespace {

constexpr int kColumns = 5;
constexpr int kRows = 16;

using Cells = std::set<std::pair<int, int>>;

Cells Marked(const CellMarks& marks) {
  Cells cells;
  for (int y = 0; y < kRows * CellMarks::kBlockHeight; ++y) {
    for (int x = 0; x < kColumns * CellMarks::kBlockWidth; ++x) {
      const std::uint64_t word = *marks.Words(x / CellMarks::kBlockWidth, y);
      if ((word >> x % CellMarks::kBlockWidth & 1) != 0) cells.emplace(x, y);
    }
  }
  return cells;
}

Cells Traversed(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  Cells cells;
  TraverseCells(from, to, [&cells](const Cell& cell) {
    cells.emplace(cell.x, cell.y);
    return true;
  });
  return cells;
}

CellMarks Empty() {
  CellMarks marks;
  marks.Reset(kColumns, kRows);
  return marks;
}

TEST(CellMarks, MarksSingleCells) {
  CellMarks marks = Empty();
  marks.Mark(0, 3);
  marks.Mark(63, 3);
  marks.Mark(64, 255);
  EXPECT_EQ(*marks.Words(0, 3), std::uint64_t{1} << 63 | 1);
  EXPECT_EQ(*marks.Words(1, 255), std::uint64_t{1});
  EXPECT_EQ(Marked(marks), (Cells{{0, 3}, {63, 3}, {64, 255}}));
}

TEST(CellMarks, MarksAFlatLineAcrossBlocks) {
  CellMarks marks = Empty();
  marks.MarkLine({200.5, 7.5}, {62.5, 7.5});
  EXPECT_EQ(*marks.Words(0, 7), std::uint64_t{3} << 62);
  EXPECT_EQ(*marks.Words(1, 7), ~std::uint64_t{0});
  EXPECT_EQ(*marks.Words(2, 7), ~std::uint64_t{0});
  EXPECT_EQ(*marks.Words(3, 7), std::uint64_t{0x1ff});
  EXPECT_EQ(Marked(marks).size(), 139u);
}

TEST(CellMarks, ForgetsOnReset) {
  CellMarks marks = Empty();
  marks.CloseBlocks([](int, int) { return true; });
  marks.MarkLine({1.5, 1.5}, {300.5, 200.5});
  marks.Reset(kColumns, kRows);
  EXPECT_TRUE(Marked(marks).empty());
  marks.MarkLine({1.5, 1.5}, {300.5, 200.5});
  EXPECT_EQ(Marked(marks), Traversed({1.5, 1.5}, {300.5, 200.5}));
}

/// Ends anywhere, on the cells' edges and corners among them.
class Ends {
 public:
  Eigen::Vector2d Next() {
    Eigen::Vector2d end(319.0 * share_(random_), 255.0 * share_(random_));
    if (random_() % 4 == 0) end.x() = std::floor(end.x());
    if (random_() % 4 == 0) end.y() = std::floor(end.y());
    return end;
  }

  /// Another end, often straight up, on a diagonal or near.
  Eigen::Vector2d NextFrom(const Eigen::Vector2d& from) {
    Eigen::Vector2d end = Next();
    switch (random_() % 6) {
      case 0:
        end.x() = from.x();
        break;
      case 1:
        end.x() = std::floor(from.x());
        break;
      case 2:
        end = from + Eigen::Vector2d::Constant(
                         std::min(319.0 - from.x(), 255.0 - from.y()) *
                         share_(random_));
        break;
      case 3:
        end.y() = from.y() + (from.y() < 100.0 ? 3.0 : -3.0) * share_(random_);
        break;
    }
    return end;
  }

  std::mt19937& random() { return random_; }

 private:
  std::mt19937 random_{5};
  std::uniform_real_distribution<double> share_{0.0, 1.0};
};

TEST(CellMarks, MarksWhatATraversalVisits) {
  Ends ends;
  CellMarks marks;
  for (int round = 0; round < 2000; ++round) {
    const Eigen::Vector2d from = ends.Next();
    const Eigen::Vector2d to = ends.NextFrom(from);
    marks.Reset(kColumns, kRows);
    marks.MarkLine(from, to);
    ASSERT_EQ(Marked(marks), Traversed(from, to))
        << from.transpose() << " to " << to.transpose();
  }
}

TEST(CellMarks, MarksAllOfALineThatLiesInOpenBlocks) {
  Ends ends;
  CellMarks marks;
  for (int round = 0; round < 2000; ++round) {
    std::bitset<kColumns * kRows> closed;
    for (int i = 0; i < kColumns * kRows; ++i) {
      closed[i] = ends.random()() % 2 == 0;
    }
    const auto is_closed = [&closed](int column, int row) {
      return closed[row * kColumns + column];
    };
    const Eigen::Vector2d from = ends.Next();
    const Eigen::Vector2d to = ends.NextFrom(from);
    marks.Reset(kColumns, kRows);
    marks.CloseBlocks(is_closed);
    marks.MarkLine(from, to);
    const Cells marked = Marked(marks);
    const Cells traversed = Traversed(from, to);
    for (const auto& cell : marked) ASSERT_EQ(traversed.count(cell), 1u);
    for (const auto& [x, y] : traversed) {
      if (is_closed(x / CellMarks::kBlockWidth, y / CellMarks::kBlockHeight))
        continue;
      ASSERT_EQ(marked.count({x, y}), 1u)
          << x << ", " << y << " of " << from.transpose() << " to "
          << to.transpose();
    }
  }
}

TEST(CellMarks, JumpsOverClosedBlocks) {
  CellMarks marks = Empty();
  marks.CloseBlocks([](int, int) { return true; });
  marks.MarkLine({1.5, 1.5}, {150.5, 250.5});
  EXPECT_LT(Marked(marks).size(), 60u) << "of 399";
}

}  // namespace
}  // namespace vfh_astar
