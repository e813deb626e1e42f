#ifndef VFH_ASTAR_PLANNING_PLANNING_THREAD_H_
#define VFH_ASTAR_PLANNING_PLANNING_THREAD_H_

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "vfh_astar/grid/grid.h"
#include "vfh_astar/grid/map_window.h"
#include "vfh_astar/planning/path_planner.h"

namespace vfh_astar {

/// A PathPlanner in a thread of its own, so that no search makes a caller wait
/// who does not want to. Idle, it waits and costs nothing. All but Close may be
/// called from any thread.
///
/// A request by who drives cuts short whatever is being planned. Others are
/// answered by the same planner while no request waits: a plan takes
/// milliseconds, a second planner as much memory again as the first.
class PlanningThread {
 public:
  using TakeResult = std::function<void(const PlanResult&)>;
  using TakeMap = std::function<void(const OccupancyGrid&)>;

  explicit PlanningThread(const PathPlannerParameters& parameters);
  ~PlanningThread();

  void SetMap(OccupancyGrid map);

  /// See PathPlanner::UpdateMap. Some windows are gathered while nobody asks
  /// for anything.
  void UpdateMap(MapWindow window);

  /// Takes the place of the request before it. Keeps to the path that was found
  /// for the last one, in place of what `request` has as its previous path.
  /// @param[in] take called in the planning thread, unless another request
  ///   comes before the plan is made.
  void Request(const PlanRequest& request, TakeResult take);

  /// Waits for the plan, and for requests that come before it is made.
  /// @return as PathPlanner::Plan; kCancelled when closed.
  PlanResult Plan(const PlanRequest& request);

  /// @param[in] take called in the planning thread with the inflated map.
  void InflateMap(TakeMap take);

  /// Ends the thread. Whoever waits in Plan is answered at once, and so are
  /// those who come later; requests are dropped. For who owns this object, in a
  /// thread of its own: the others keep to the rest.
  void Close();

 private:
  /// Somebody's wish for a plan who waits for it.
  struct Question {
    PlanRequest request;
    std::promise<PlanResult> answer;
  };
  struct Order {
    PlanRequest request;
    TakeResult take;
  };

  /// What the callers leave for the planning thread.
  struct Desk {
    std::optional<OccupancyGrid> map;
    std::vector<MapWindow> windows;  ///< of the map, or of the one before it.
    std::optional<Order> order;      ///< goes before the questions.
    std::deque<Question> questions;
    TakeMap take_map;
    bool is_closing = false;

    bool HasWork() const {
      return is_closing || map || windows.size() >= kMostGatheredWindows ||
             order || !questions.empty() || take_map;
    }
  };

  /// Changes what lies on the desk, and wakes the planning thread when that is
  /// work.
  template <typename Change>
  void Leave(Change change);
  void PlanUntilClosed();
  Desk TakeWork();
  void Plan(Order& order);
  void Plan(Question& question);

  std::mutex mutex_;
  std::condition_variable wake_;
  Desk desk_;                             ///< under mutex_.
  std::atomic<bool> is_outdated_{false};  ///< what is being planned is; written
                                          ///< under mutex_.
  // The planning thread's:
  PathPlanner planner_;
  std::vector<Eigen::Vector2d> path_;  ///< the last one found for a request.

  std::thread thread_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_PLANNING_PLANNING_THREAD_H_
