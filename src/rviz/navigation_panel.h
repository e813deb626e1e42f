#ifndef VFH_ASTAR_RVIZ_NAVIGATION_PANEL_H_
#define VFH_ASTAR_RVIZ_NAVIGATION_PANEL_H_

#ifndef Q_MOC_RUN
#include <ros/node_handle.h>
#include <rviz/panel.h>
#include <vfh_astar/NavigationState.h>
#endif

#include <QFormLayout>
#include <QLabel>
#include <QString>
#include <QTimer>
#include <string>

namespace vfh_astar {

/// An RViz panel that shows `navigation_state` and has buttons for `pause`,
/// `resume` and `cancel`. RViz takes its messages in the thread of its windows,
/// so nothing here is shared between threads.
class NavigationPanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit NavigationPanel(QWidget* parent = nullptr);

 private:
  QLabel* AddRow(QFormLayout* layout, const QString& title);
  void Show(const NavigationState& state);
  void Call(const std::string& service);
  void NoticeSilence();

  ros::NodeHandle node_;
  ros::Subscriber state_subscriber_;
  ros::Publisher cancel_publisher_;
  ros::WallTime last_message_;
  QTimer* silence_timer_;

  QLabel* state_;
  QLabel* reason_;
  QLabel* error_;
  QLabel* clearance_;
  QLabel* speed_;
  QLabel* distance_;
  QLabel* replans_;
};

}  // namespace vfh_astar

#endif  // VFH_ASTAR_RVIZ_NAVIGATION_PANEL_H_
