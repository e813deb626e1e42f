#include "benchmark/stage_times.h"

#include <time.h>

namespace vfh_astar {

std::string ToString(Stage stage) {
  switch (stage) {
    case Stage::kLocalize:
      return "localize";
    case Stage::kMapInsert:
      return "map_insert";
    case Stage::kInflationUpdate:
      return "inflation_update";
    case Stage::kPlan:
      return "plan";
    case Stage::kFit:
      return "fit";
    case Stage::kControlTick:
      return "control_tick";
  }
  return "";
}

double StageTimer::ThreadTime() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * now.tv_nsec;
}

void StageTimer::Stop() {
  if (times_ == nullptr) return;
  times_->Add(stage_, ThreadTime() - begin_);
  times_ = nullptr;
}

}  // namespace vfh_astar
