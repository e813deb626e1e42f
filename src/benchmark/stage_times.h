#ifndef VFH_ASTAR_BENCHMARK_STAGE_TIMES_H_
#define VFH_ASTAR_BENCHMARK_STAGE_TIMES_H_

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace vfh_astar {

/// What a NavigationStack does in a cycle.
enum class Stage {
  kLocalize,         ///< a scan's pose, with SLAM or in a map.
  kMapInsert,        ///< a scan into the map; scans left out do not count.
  kInflationUpdate,  ///< the planner's and the clearance map's.
  kPlan,
  kFit,
  kControlTick,
};
inline constexpr std::size_t kStageCount = 6;

/// As in the benchmark's figures.
std::string ToString(Stage stage);

/// How long the stages of a run took: the time that the thread had a processor,
/// so that what else runs on the machine does not count.
class StageTimes {
 public:
  void Add(Stage stage, double microseconds) {
    times_[static_cast<std::size_t>(stage)].push_back(microseconds);
  }

  /// us, one for each time that the stage was gone through.
  const std::vector<double>& Of(Stage stage) const {
    return times_[static_cast<std::size_t>(stage)];
  }

 private:
  std::array<std::vector<double>, kStageCount> times_;
};

/// Times a stage from its making to Stop or its end.
class StageTimer {
 public:
  /// @param[in,out] times null: nothing is timed.
  StageTimer(StageTimes* times, Stage stage)
      : times_(times), stage_(stage), begin_(ThreadTime()) {}
  ~StageTimer() { Stop(); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

  void Stop();
  /// It was no such stage after all.
  void Discard() { times_ = nullptr; }

 private:
  static double ThreadTime();  ///< us

  StageTimes* times_;
  Stage stage_;
  double begin_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_STAGE_TIMES_H_
