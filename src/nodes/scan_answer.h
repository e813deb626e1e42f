#ifndef VFH_ASTAR_NODES_SCAN_ANSWER_H_
#define VFH_ASTAR_NODES_SCAN_ANSWER_H_

#include <cmath>

namespace vfh_astar {

/// Whether somebody has answered a robot's newest scan, so that a clock in
/// lock-step may go on.
///
/// A navigation answers by a state that tells the scan's stamp and whether a
/// command goes with it; both have to come, in any order. Anybody else who
/// commands answers by a command that comes after the scan. One who did not in
/// time is not waited for before his next command, and after kMostMisses such
/// scans never: who commands at a pace of his own cannot be waited for.
class ScanAnswer {
 public:
  /// Scans that may go unanswered; forgotten when kTrust in a row are answered.
  static constexpr int kMostMisses = 3;
  static constexpr int kTrust = 20;

  /// @param[in] stamp s
  void TakeScan(double stamp) {
    if (!has_command_) answered_ = 0;
    stamp_ = stamp;
    is_open_ = true;
    is_used_ = has_command_ = needs_command_ = false;
  }

  void TakeCommand() {
    const bool is_answer = is_open_ && !has_command_ && !is_idle_;
    // Who is not waited for any more cannot show that he answers.
    if (is_answer && ++answered_ >= kTrust && misses_ < kMostMisses) {
      misses_ = 0;
    }
    has_command_ = true;
    is_idle_ = false;
  }

  /// @param[in] scan_stamp s, of the scan that the navigation has used.
  /// @param[in] commanded a command goes with it.
  void TakeState(double scan_stamp, bool commanded) {
    // Answers from before a reset carry stamps that are yet to come.
    if (std::abs(scan_stamp - stamp_) > kStampTolerance) return;
    is_used_ = true;
    needs_command_ = commanded;
  }

  /// @param[in] has_navigation somebody publishes such states,
  /// @param[in] has_commander and somebody commands.
  bool IsComplete(bool has_navigation, bool has_commander) const {
    if (!is_open_) return true;
    const bool is_commanded = has_command_ || !has_commander;
    if (has_navigation) return is_used_ && (!needs_command_ || is_commanded);
    return is_commanded || is_idle_ || misses_ >= kMostMisses;
  }

  /// Nobody waits any longer.
  void GiveUp() {
    is_open_ = false;
    is_idle_ = true;
    answered_ = 0;
    ++misses_;
  }

 private:
  // s by which a stamp may differ after its way through messages.
  static constexpr double kStampTolerance = 1e-6;

  double stamp_ = 0.0;          ///< s, of the newest scan.
  bool is_open_ = false;        ///< an answer to it is awaited.
  bool is_used_ = false;        ///< by the navigation,
  bool needs_command_ = false;  ///< which has sent a command with it.
  bool has_command_ = false;    ///< since the newest scan.
  bool is_idle_ = false;        ///< no command since a scan was given up.
  int misses_ = 0;
  int answered_ = 0;  ///< scans in a row.
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_NODES_SCAN_ANSWER_H_
