#include "vfh_astar/planning/planning_thread.h"

#include <iterator>
#include <utility>

namespace vfh_astar {
namespace {

PlanResult Closing() {
  PlanResult result;
  result.outcome = Outcome::kCancelled;
  result.message = "the planner is being closed";
  return result;
}

}  // namespace

PlanningThread::PlanningThread(const PathPlannerParameters& parameters)
    : planner_(parameters), thread_([this] { PlanUntilClosed(); }) {}

PlanningThread::~PlanningThread() { Close(); }

template <typename Change>
void PlanningThread::Leave(Change change) {
  bool has_work = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    change(desk_);
    has_work = desk_.HasWork();
  }
  if (has_work) wake_.notify_one();
}

void PlanningThread::SetMap(OccupancyGrid map) {
  Leave([&map](Desk& desk) {
    desk.map = std::move(map);
    desk.windows.clear();
  });
}

void PlanningThread::UpdateMap(MapWindow window) {
  Leave([&window](Desk& desk) { desk.windows.push_back(std::move(window)); });
}

void PlanningThread::Request(const PlanRequest& request, TakeResult take) {
  Leave([&](Desk& desk) {
    desk.order = Order{request, std::move(take)};
    is_outdated_ = true;
  });
}

PlanResult PlanningThread::Plan(const PlanRequest& request) {
  Question question;
  question.request = request;
  std::future<PlanResult> answer = question.answer.get_future();
  bool is_closing = false;
  Leave([&](Desk& desk) {
    is_closing = desk.is_closing;
    if (!is_closing) desk.questions.push_back(std::move(question));
  });
  return is_closing ? Closing() : answer.get();
}

void PlanningThread::InflateMap(TakeMap take) {
  Leave([&take](Desk& desk) { desk.take_map = std::move(take); });
}

void PlanningThread::Close() {
  Leave([this](Desk& desk) {
    desk.is_closing = true;
    is_outdated_ = true;
  });
  if (thread_.joinable()) thread_.join();
}

void PlanningThread::PlanUntilClosed() {
  while (true) {
    Desk work = TakeWork();
    if (work.is_closing) {
      for (Question& question : work.questions) {
        question.answer.set_value(Closing());
      }
      return;
    }
    if (work.map) planner_.SetMap(*work.map);
    if (!work.windows.empty()) planner_.UpdateMap(work.windows);
    if (work.order) Plan(*work.order);
    if (!work.questions.empty()) Plan(work.questions.front());
    if (work.take_map) work.take_map(planner_.InflatedMap());
  }
}

/// Waits for work. A question is taken only when no order is; on closing, all
/// of them.
PlanningThread::Desk PlanningThread::TakeWork() {
  std::unique_lock<std::mutex> lock(mutex_);
  wake_.wait(lock, [this] { return desk_.HasWork(); });
  Desk work = std::exchange(desk_, {});
  desk_.is_closing = work.is_closing;
  if (!work.is_closing) {
    const int taken = work.order || work.questions.empty() ? 0 : 1;
    desk_.questions.assign(
        std::make_move_iterator(work.questions.begin() + taken),
        std::make_move_iterator(work.questions.end()));
    work.questions.resize(taken);
    is_outdated_ = false;
  }
  return work;
}

void PlanningThread::Plan(Order& order) {
  order.request.previous = path_;
  const PlanResult result = planner_.Plan(order.request, &is_outdated_);
  if (result.outcome == Outcome::kCancelled) return;
  if (result.outcome == Outcome::kSuccess) path_ = result.path;
  order.take(result);
}

void PlanningThread::Plan(Question& question) {
  const PlanResult result = planner_.Plan(question.request, &is_outdated_);
  if (result.outcome != Outcome::kCancelled) {
    question.answer.set_value(result);
    return;
  }
  // It has made way for an order and is next after it.
  Leave([&question](Desk& desk) {
    desk.questions.push_front(std::move(question));
  });
}

}  // namespace vfh_astar
