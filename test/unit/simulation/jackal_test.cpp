#include "vfh_astar/simulation/jackal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vfh_astar {
namespace {

constexpr double kStep = 0.002;

class JackalTest : public testing::Test {
 protected:
  JackalTest() : robot_(&world_, JackalModel(), {1.0, 2.0, 0.5}) {}

  void Drive(const Twist2D& command, double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kStep)); ++i) {
      robot_.Control(command, kStep);
      robot_.TouchGround();
      world_.Step(kStep);
      robot_.CountWheelTurns(kStep);
    }
  }

  /// J, of the whole robot along the ground and about the vertical, and of the
  /// wheels about their axles.
  double KineticEnergy() const {
    const JackalModel& model = robot_.model();
    const double mass = model.chassis_mass + 4.0 * model.wheel_mass;
    constexpr double kChassisInertia = 0.4485;  // kg m^2
    double energy = 0.5 * mass * robot_.velocity().squaredNorm() +
                    0.5 * kChassisInertia * std::pow(robot_.twist().w, 2);
    for (const double rate : robot_.wheel_rates()) {
      energy +=
          0.25 * model.wheel_mass * std::pow(model.wheel_radius * rate, 2);
    }
    return energy;
  }

  PhysicsWorld world_;
  Jackal robot_;
  Eigen::Vector2d start_ = Eigen::Vector2d::Zero();
};

TEST_F(JackalTest, StandsStillForTenMinutes) {
  Drive({0.0, 0.0}, 1.0);
  double early = 0.0;
  double late = 0.0;
  for (int second = 1; second < 600; ++second) {
    Drive({0.0, 0.0}, 1.0);
    double& most = second < 300 ? early : late;
    most = std::max(most, KineticEnergy());
  }
  EXPECT_LT((robot_.pose().position() - Eigen::Vector2d(1.0, 2.0)).norm(),
            1e-3);
  EXPECT_NEAR(robot_.pose().theta, 0.5, 1e-3);
  EXPECT_LT(early, 1e-9);
  // Some room, as both are rounding.
  EXPECT_LE(late, 2.0 * early + 1e-15);
}

TEST_F(JackalTest, DrivesWhatIsCommanded) {
  for (const double v : {-2.0, -0.5, 0.0, 0.3, 1.0, 2.0}) {
    for (const double w : {-4.0, -1.0, 0.0, 0.5, 1.0, 2.0, 3.0, 4.0}) {
      Drive({v, w}, 2.0);
      // Over a while, as a sliding tyre sticks and slips.
      double v_sum = 0.0;
      double w_sum = 0.0;
      constexpr int kSamples = 50;
      for (int i = 0; i < kSamples; ++i) {
        Drive({v, w}, 0.02);
        v_sum += robot_.twist().v;
        w_sum += robot_.twist().w;
      }
      EXPECT_NEAR(v_sum / kSamples, v, 0.05 * std::abs(v) + 1e-3)
          << v << " m/s, " << w << " rad/s";
      EXPECT_NEAR(w_sum / kSamples, w, 0.05 * std::abs(w) + 1e-3)
          << v << " m/s, " << w << " rad/s";
    }
  }
}

TEST_F(JackalTest, RisesNoFasterThanItsControllerAndSettles) {
  for (const Twist2D& command :
       {Twist2D{0.2, 0.0}, {1.0, 0.0}, {0.0, 0.5}, {0.0, 2.0}, {0.0, 4.0}}) {
    robot_.Place({1.0, 2.0, 0.0});
    const JackalModel& model = robot_.model();
    double settled_v = 0.0;
    double settled_w = 0.0;
    for (double time = kStep; time < 1.0; time += kStep) {
      Drive(command, kStep);
      const Twist2D twist = robot_.twist();
      // Nothing pushes it beyond what its wheels are told.
      EXPECT_LE(twist.v, model.max_acceleration * time + 1e-3);
      EXPECT_LE(twist.w, model.max_angular_acceleration * time + 1e-3);
      EXPECT_LE(twist.v, 1.05 * command.v + 1e-3);
      EXPECT_LE(twist.w, 1.05 * command.w + 1e-3);
      if (std::abs(twist.v - command.v) > 0.05 * command.v) settled_v = time;
      if (std::abs(twist.w - command.w) > 0.05 * command.w) settled_w = time;
    }
    EXPECT_LT(command.v > 0.0 ? settled_v : 0.0, 0.5) << command.v << " m/s";
    EXPECT_LT(command.w > 0.0 ? settled_w : 0.0, 0.5) << command.w << " rad/s";
  }
}

TEST(PhysicsWorldTest, BoundsWhereTheyMatterAreAllBounds) {
  // From smooth driving to spinning tyres, a wall, slippery ground and back.
  const GroundPatch ice{{MakeDisc({3.0, 0.0}, 0.8)}, 0.1, 200.0};
  const Shape wall = MakeBox({2.0, 2.5, 0.0}, {10.0, 0.1});
  std::vector<std::vector<Pose2D>> tracks;
  for (const auto bounds : {PhysicsWorld::Bounds::kWhereTheyMatter,
                            PhysicsWorld::Bounds::kAlways}) {
    PhysicsWorld world(bounds);
    std::vector<Jackal> robots;
    robots.reserve(2);
    robots.emplace_back(&world, JackalModel(), Pose2D(0.0, 0.0, 0.0));
    // One slides while the other does not, and the other way round.
    robots.emplace_back(&world, JackalModel(), Pose2D(-5.0, 0.0, 1.0));
    tracks.emplace_back();
    for (int i = 0; i < 4000; ++i) {
      const double time = i * kStep;
      robots[0].Control({time < 6.0 ? 1.0 : -2.0,
                         time < 4.0 ? 0.0 : 0.8 * std::sin(5.0 * time)},
                        kStep);
      robots[1].Control({0.3, 4.0 * std::sin(time)}, kStep);
      for (Jackal& robot : robots) {
        robot.TouchGround({ice});
        for (const ContactPoint& contact : FindContact(robot.Outline(), wall)) {
          robot.Touch(contact);
        }
      }
      world.Step(kStep);
      for (Jackal& robot : robots) {
        robot.CountWheelTurns(kStep);
        tracks.back().push_back(robot.pose());
      }
    }
  }
  for (std::size_t i = 0; i < tracks[0].size(); ++i) {
    ASSERT_NEAR(tracks[0][i].x, tracks[1][i].x, 1e-7) << i;
    ASSERT_NEAR(tracks[0][i].y, tracks[1][i].y, 1e-7) << i;
    ASSERT_NEAR(tracks[0][i].theta, tracks[1][i].theta, 1e-7) << i;
  }
}

TEST_F(JackalTest, ReachesItsSpeedInTheTimeThatGripAllows) {
  Drive({2.0, 0.0}, 0.1);
  EXPECT_LT(robot_.twist().v, 1.5 * 9.81 * 0.1)
      << "no more than friction gives";
  Drive({2.0, 0.0}, 0.4);
  EXPECT_GT(robot_.twist().v, 1.9);
}

TEST_F(JackalTest, IsLimitedToWhatItsControllerAllows) {
  Drive({9.0, 0.0}, 3.0);
  EXPECT_NEAR(robot_.twist().v, 2.0, 0.02);
}

TEST_F(JackalTest, WheelTurnsMeasureTheWay) {
  const Eigen::Vector2d start = robot_.pose().position();
  Drive({1.0, 0.0}, 3.0);
  Drive({0.0, 0.0}, 1.0);
  const double driven = (robot_.pose().position() - start).norm();
  EXPECT_NEAR(robot_.wheel_angles()[0] * robot_.model().wheel_radius, driven,
              0.03 * driven);
}

TEST_F(JackalTest, PushesAgainstAWallWithoutPassingIt) {
  const Shape wall = MakeBox({3.0, 2.0, 0.0}, {0.1, 10.0});
  robot_.Place({2.0, 2.0, 0.0});
  for (int i = 0; i < 1500; ++i) {
    robot_.Control({1.0, 0.0}, kStep);
    robot_.TouchGround();
    for (const ContactPoint& contact : FindContact(robot_.Outline(), wall)) {
      robot_.Touch(contact);
    }
    world_.Step(kStep);
  }
  EXPECT_NEAR(robot_.pose().x, 2.95 - robot_.model().footprint.front, 0.02);
  EXPECT_NEAR(robot_.twist().v, 0.0, 0.02);
}

TEST_F(JackalTest, BrakesLateOnSlipperyGround) {
  const GroundPatch ice{{MakeDisc({1.0, 2.0}, 500.0)}, 0.1, 200.0};
  const auto braking_distance = [this](const std::vector<GroundPatch>& ground) {
    robot_.Place({1.0, 2.0, 0.0});
    for (int i = 0; i < 1500; ++i) {
      robot_.Control({i < 1000 ? 1.0 : 0.0, 0.0}, kStep);
      // Gets up to speed on good ground.
      robot_.TouchGround(i < 1000 ? std::vector<GroundPatch>() : ground);
      world_.Step(kStep);
      if (i == 999) start_ = robot_.pose().position();
    }
    return (robot_.pose().position() - start_).norm();
  };
  const double on_floor = braking_distance({});
  const double on_ice = braking_distance({ice});
  EXPECT_LT(on_floor, 0.12);
  // v^2 / (2 mu g) is 0.51 m.
  EXPECT_NEAR(on_ice, 0.51, 0.05);
}

TEST_F(JackalTest, SoftTyresSlipInTurnsSoThatWheelsMisjudgeThem) {
  const GroundPatch soft{{MakeDisc({1.0, 2.0}, 500.0)}, 1.5, 30.0};
  robot_.Place({1.0, 2.0, 0.0});
  for (int i = 0; i < 2000; ++i) {
    robot_.Control({1.5, 1.0}, kStep);
    robot_.TouchGround({soft});
    world_.Step(kStep);
  }
  // The robot drifts outwards: its nose points into the turn.
  const Eigen::Vector2d in_robot =
      Pose2D(0.0, 0.0, -robot_.pose().theta) * robot_.velocity();
  EXPECT_LT(in_robot.y(), -0.1);
}

}  // namespace
}  // namespace vfh_astar
