#include "vfh_astar/planning/band_queue.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <vector>

namespace vfh_astar {
namespace {

int Take(BandQueue<int>& queue) {
  queue.LeastKey();
  return queue.Pop();
}

TEST(BandQueue, GoesByBandThenByOrder) {
  BandQueue<int> queue(4, 0, 1000, 1000);
  queue.Restart(0);
  queue.Push(40, 1, 5);
  queue.Push(3, 9, 2);
  queue.Push(15, 7, 1);
  queue.Push(20, 8, 3);
  queue.Push(31, 9, 4);
  for (int i = 1; i <= 5; ++i) EXPECT_EQ(Take(queue), i);
  EXPECT_TRUE(queue.empty());
}

TEST(BandQueue, TellsItsBand) {
  BandQueue<int> queue(4, 0, 1000, 1000);
  queue.Restart(5);
  queue.Push(50, 0, 1);
  EXPECT_EQ(queue.LeastKey(), 48u);
  EXPECT_EQ(queue.EndOfBand(), 64u);
}

TEST(BandQueue, TakesWhatComesToThePresentBandWhateverItsOrder) {
  BandQueue<int> queue(4, 0, 1000, 8);
  queue.Restart(0);
  queue.Push(1, 500, 1);
  EXPECT_EQ(Take(queue), 1);
  queue.Push(2, 3, 2);
  queue.Push(3, 5000, 3);
  EXPECT_EQ(Take(queue), 2);
  EXPECT_EQ(Take(queue), 3);
}

// As a search pushes: keys of the present band and of some later ones.
TEST(BandQueue, LosesNothingAndNeverGoesBack) {
  constexpr unsigned kBits = 4;
  std::mt19937 random(5);
  BandQueue<unsigned> queue(kBits, 2, 200, 300);
  for (int round = 0; round < 20; ++round) {
    unsigned least = random() % 1000;
    queue.Restart(least);
    std::multiset<unsigned> keys;
    const auto push = [&](unsigned key) {
      keys.insert(key);
      queue.Push(key, random() % 500, key);
    };
    push(least);
    int pushes = 3000;
    while (!keys.empty()) {
      ASSERT_FALSE(queue.empty());
      ASSERT_GE(queue.LeastKey(), least >> kBits << kBits);
      least = queue.LeastKey();
      const unsigned key = queue.Pop();
      ASSERT_EQ(key >> kBits, *keys.begin() >> kBits);
      keys.erase(keys.find(key));
      for (int i = random() % 3; i > 0 && pushes > 0; --i, --pushes) {
        push(key + random() % 150);
      }
    }
    ASSERT_TRUE(queue.empty());
  }
}

}  // namespace
}  // namespace vfh_astar
