#include "navigation_panel.h"

#include <ros/service.h>
#include <std_msgs/Empty.h>
#include <std_srvs/Empty.h>

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>
#include <pluginlib/class_list_macros.hpp>

namespace vfh_astar {
namespace {

constexpr double kSilence = 1.0;  // s of the wall's without a message.
constexpr int kDecimals = 2;

QString Number(double value, const char* unit) {
  if (!std::isfinite(value)) return "-";
  return QString("%1 %2").arg(value, 0, 'f', kDecimals).arg(unit);
}

}  // namespace

NavigationPanel::NavigationPanel(QWidget* parent) : rviz::Panel(parent) {
  auto* layout = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  layout->addLayout(form);
  state_ = AddRow(form, "State");
  reason_ = AddRow(form, "Reason");
  error_ = AddRow(form, "Error x, y, turn");
  clearance_ = AddRow(form, "Clearance");
  speed_ = AddRow(form, "Speed");
  distance_ = AddRow(form, "To the goal");
  replans_ = AddRow(form, "Replans");
  reason_->setWordWrap(true);

  auto* buttons = new QHBoxLayout;
  layout->addLayout(buttons);
  layout->addStretch();
  auto* pause = new QPushButton("Pause");
  auto* resume = new QPushButton("Resume");
  auto* cancel = new QPushButton("Cancel");
  for (QPushButton* button : {pause, resume, cancel}) {
    buttons->addWidget(button);
  }
  connect(pause, &QPushButton::clicked, this, [this] { Call("pause"); });
  connect(resume, &QPushButton::clicked, this, [this] { Call("resume"); });
  connect(cancel, &QPushButton::clicked, this,
          [this] { cancel_publisher_.publish(std_msgs::Empty()); });

  cancel_publisher_ = node_.advertise<std_msgs::Empty>("cancel", 1);
  state_subscriber_ = node_.subscribe<NavigationState>(
      "navigation_state", 1,
      [this](const NavigationStateConstPtr& state) { Show(*state); });
  silence_timer_ = new QTimer(this);
  connect(silence_timer_, &QTimer::timeout, this, [this] { NoticeSilence(); });
  silence_timer_->start(static_cast<int>(500.0 * kSilence));
  NoticeSilence();
}

QLabel* NavigationPanel::AddRow(QFormLayout* layout, const QString& title) {
  auto* label = new QLabel("-");
  layout->addRow(title, label);
  return label;
}

void NavigationPanel::Show(const NavigationState& state) {
  last_message_ = ros::WallTime::now();
  state_->setText(QString::fromStdString(state.state));
  reason_->setText(QString::fromStdString(state.reason));
  error_->setText(Number(state.error_x, "m, ") + Number(state.error_y, "m, ") +
                  Number(state.error_theta, "rad"));
  clearance_->setText(Number(state.clearance, "m"));
  speed_->setText(Number(state.speed, "m/s") +
                  (state.limited ? ", limited" : ""));
  distance_->setText(Number(state.distance_to_goal, "m"));
  replans_->setText(QString::number(state.replans));
}

void NavigationPanel::Call(const std::string& service) {
  std_srvs::Empty empty;
  if (!ros::service::call(node_.resolveName(service), empty)) {
    reason_->setText(
        QString::fromStdString("nobody answers the service " + service));
  }
}

void NavigationPanel::NoticeSilence() {
  if ((ros::WallTime::now() - last_message_).toSec() < kSilence) return;
  for (QLabel* label :
       {error_, clearance_, speed_, distance_, replans_, state_}) {
    label->setText("-");
  }
  reason_->setText("nothing comes on " +
                   QString::fromStdString(state_subscriber_.getTopic()));
}

}  // namespace vfh_astar

PLUGINLIB_EXPORT_CLASS(vfh_astar::NavigationPanel, rviz::Panel)
