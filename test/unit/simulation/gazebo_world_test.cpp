#include "vfh_astar/simulation/gazebo_world.h"

#include <gtest/gtest.h>

#include "temporary_folder.h"

namespace vfh_astar {
namespace {

const std::string kBegin = "<sdf version='1.6'>\n<world name='w'>\n";
const std::string kEnd = "</world></sdf>\n";
const std::string kCylinder =
    "<cylinder><radius>0.5</radius><length>1</length></cylinder>";

std::string Collision(const std::string& geometry,
                      const std::string& pose = "0 0 0 0 0 0") {
  return "<collision name='c'><pose>" + pose + "</pose><geometry>" + geometry +
         "</geometry></collision>";
}

/// A static model with one link.
std::string Model(const std::string& content, const std::string& name = "m") {
  return "<model name='" + name + "'><static>1</static>" + content +
         "</model>\n";
}

std::string Link(const std::string& content) {
  return "<link name='l'>" + content + "</link>";
}

World Read(const std::string& content) {
  const TemporaryFolder folder;
  return LoadWorld(folder.Write("a.world", kBegin + content + kEnd));
}

/// What is wrong with a world of this content, which begins at line 3.
std::string ErrorOf(const std::string& content) {
  const TemporaryFolder folder;
  const std::string file = folder.Write("a.world", kBegin + content + kEnd);
  try {
    LoadWorld(file);
  } catch (const WorldFileError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind(file + ":", 0), 0u) << message;
    return message.substr(file.size() + 1);
  }
  return "no error";
}

std::string ErrorOfGeometry(const std::string& geometry) {
  return ErrorOf(Model(Link(Collision(geometry))));
}

TEST(GazeboWorld, ReadsBoxesAndCylinders) {
  const World world =
      Read(Model(Link(Collision("<box><size> 4 2\n 1 </size></box>",
                                "1 2 0.5 0 0 1.5707963"))) +
           Model(Link(Collision(kCylinder)), "n"));
  EXPECT_EQ(world.name, "a");
  ASSERT_EQ(world.obstacles.size(), 2u);
  EXPECT_EQ(world.obstacles[0].name, "m");
  const Shape& box = world.obstacles[0].shapes[0];
  EXPECT_TRUE(Contains(box, {1.99, 3.99}));
  EXPECT_FALSE(Contains(box, {2.01, 2.0}));
  EXPECT_TRUE(world.obstacles[1].shapes[0].IsDisc());
  EXPECT_EQ(world.obstacles[1].shapes[0].radius, 0.5);
}

TEST(GazeboWorld, PosesCompose) {
  // The collision is 1 m ahead of the link, the link 2 m ahead of the inner
  // model, that one 3 m ahead of the outer one, and each but the collision
  // turns left by a quarter.
  const std::string quarter = " 0 0 0 1.5707963267948966</pose>";
  const World world =
      Read(Model("<pose>10 20" + quarter + "<model name='inner'><pose>3" +
                 " 0" + quarter + "<link name='l'><pose>2 0" + quarter +
                 Collision(kCylinder, "1 0 0 0 0 0") + "</link></model>"));
  ASSERT_EQ(world.obstacles.size(), 1u);
  ASSERT_EQ(world.obstacles[0].shapes.size(), 1u);
  // (10, 20), up by 3, left by 2, down by 1.
  EXPECT_TRUE(
      world.obstacles[0].shapes[0].center.isApprox(Eigen::Vector2d(8.0, 22.0)));
}

TEST(GazeboWorld, StateMovesModelsAndDoublesNone) {
  const std::string model =
      Model("<pose>1 1 0 0 0 0</pose>" + Link(Collision(kCylinder)));
  const auto state = [](const std::string& pose) {
    return "<state world_name='w'><model name='m'><pose>" + pose +
           "</pose><scale>1 1 1</scale><link name='l'><pose>9 9 9 0 0 0</pose>"
           "</link></model></state>";
  };
  for (const World& world : {Read(model + state("2 3 0 0 0 0")),
                             Read(state("2 3 0 0 0 0") + model)}) {
    ASSERT_EQ(world.obstacles.size(), 1u);
    ASSERT_EQ(world.obstacles[0].shapes.size(), 1u);
    EXPECT_EQ(world.obstacles[0].shapes[0].center, Eigen::Vector2d(2.0, 3.0));
  }
  EXPECT_EQ(Read(model).obstacles[0].shapes[0].center,
            Eigen::Vector2d(1.0, 1.0));
}

TEST(GazeboWorld, LeavesOutWhatARobotCannotMeet) {
  const std::string plane = "<plane><normal>0 0 1</normal></plane>";
  const World world = Read(
      "<include><uri>model://ground_plane</uri></include>\n"
      "<include><uri> model://sun </uri></include>\n"
      "<light name='sun'/><gravity>0 0 -9.8</gravity>"
      "<model name='ground'>" +
      Link(Collision(plane)) + "</model>" +
      Model(Link("<visual name='v'><geometry><sphere/></geometry>"
                 "</visual>"),
            "seen") +
      Model(Link(Collision(kCylinder, "0 0 1.1 0 0 0")), "lamp") +
      Model(Link(Collision(kCylinder, "0 0 -0.6 0 0 0")), "buried") +
      Model(Link(Collision(kCylinder, "0 0 0.9 0 0 0")), "low_bridge"));
  ASSERT_EQ(world.obstacles.size(), 1u);
  EXPECT_EQ(world.obstacles[0].name, "low_bridge");
}

TEST(GazeboWorld, WhiteSpaceMeansNothing) {
  const TemporaryFolder folder;
  const World world = LoadWorld(folder.Write(
      "a.world",
      "\xef\xbb\xbf \n\n<?xml version='1.0' ?>\r\n" + kBegin +
          Model("<pose frame=''>\r\n  1\t2  0\n0 -0 0 </pose>" +
                Link(Collision("<cylinder>\n<radius>\n0.5 </radius><length> 1 "
                               "</length></cylinder>"))) +
          kEnd));
  ASSERT_EQ(world.obstacles.size(), 1u);
  EXPECT_EQ(world.obstacles[0].shapes[0].center, Eigen::Vector2d(1.0, 2.0));
}

TEST(GazeboWorld, RefusesGeometryThatItCannotShow) {
  EXPECT_EQ(ErrorOfGeometry("<sphere><radius>1</radius></sphere>"),
            "3: <sphere>: a shape that has no counterpart here; expected a "
            "box, a cylinder or a plane");
  EXPECT_EQ(ErrorOfGeometry("<box><size>1 2</size></box>"),
            "3: <size>: '1 2'; expected 3 numbers");
  EXPECT_EQ(ErrorOfGeometry("<box><size>1 0 1</size></box>"),
            "3: <size>: '1 0 1'; expected three lengths above 0 m");
  EXPECT_EQ(ErrorOfGeometry("<box/>"),
            "3: <box>: no <size> in it; expected a <size>");
  EXPECT_EQ(ErrorOfGeometry("<cylinder><radius>nan</radius></cylinder>"),
            "3: <radius>: 'nan'; expected a number");
  EXPECT_EQ(ErrorOfGeometry("<cylinder><radius>-1</radius></cylinder>"),
            "3: <radius>: '-1'; expected a length above 0 m");
  EXPECT_EQ(ErrorOf(Model(Link("<collision name='c'/>"))),
            "3: <collision>: no <geometry> in it; expected a <geometry>");
}

TEST(GazeboWorld, RefusesModelsThatItCannotShow) {
  const std::string link = Link(Collision(kCylinder));
  EXPECT_EQ(ErrorOf("\n<model name='m'>" + link + "</model>"),
            "4: <model>: 'm' is not static; expected <static>1</static>");
  EXPECT_EQ(
      ErrorOf("<model name='m'><static>maybe</static>" + link + "</model>"),
      "3: <static>: 'maybe'; expected true, false, 1 or 0");
  EXPECT_EQ(ErrorOf("<model>" + link + "</model>"),
            "3: <model>: no name; expected a name");
  EXPECT_EQ(ErrorOf(Model(link + "<plugin name='p' filename='p.so'/>")),
            "3: <plugin>: a program that may move the model; expected models "
            "that stand still");
  EXPECT_EQ(ErrorOf(Model("<pose>0 0 0 1.57 0 0</pose>" + link)),
            "3: <pose>: '0 0 0 1.57 0 0'; expected roll and pitch of 0");
  EXPECT_EQ(ErrorOf(Model("<pose>0 0 0 0 0</pose>" + link)),
            "3: <pose>: '0 0 0 0 0'; expected 6 numbers");
  EXPECT_EQ(ErrorOf(Model("<pose>0 0 0 0 0 x</pose>" + link)),
            "3: <pose>: '0 0 0 0 0 x'; expected 6 numbers");
  EXPECT_EQ(ErrorOf(Model("<pose relative_to='n'>0 0 0 0 0 0</pose>" + link)),
            "3: <pose>: relative_to='n'; expected a pose relative to its "
            "parent, in m and rad");
  EXPECT_EQ(ErrorOf(Model(link) + Model(link)),
            "4: <model>: 'm'; expected a name that nothing else has");
}

TEST(GazeboWorld, RefusesWorldsThatItCannotShow) {
  EXPECT_EQ(ErrorOf("<include><uri>model://house</uri></include>"),
            "3: <include>: 'model://house'; expected models written out in "
            "full");
  EXPECT_EQ(ErrorOf("<actor name='a'/>"),
            "3: <actor>: no counterpart here; expected static models");
  EXPECT_EQ(ErrorOf("<state><model name='m'><scale>1 2 1</scale></model>"
                    "</state>"),
            "3: <scale>: '1 2 1'; expected a scale of 1 1 1");
}

TEST(GazeboWorld, RefusesFilesThatAreTruncatedOrMalformed) {
  const std::string whole = kBegin + Model(Link(Collision(kCylinder))) + kEnd;
  const TemporaryFolder folder;
  for (std::size_t size = 1; size < whole.size() - 1; ++size) {
    const std::string file = folder.Write("cut.world", whole.substr(0, size));
    EXPECT_THROW(LoadWorld(file), WorldFileError) << whole.substr(0, size);
  }
  EXPECT_NE(ErrorOf("<model name='m'>\n</link>")
                .find("expected well-formed "
                      "XML"),
            std::string::npos);
  const std::string other = folder.Write("other.world", "<html>\n</html>");
  EXPECT_THROW(LoadWorld(other), WorldFileError);
  EXPECT_THROW(LoadWorld(folder.Write("no.world", "<!-- no -->")),
               WorldFileError);
  EXPECT_THROW(LoadWorld(folder.Write("no.world", "<sdf/>")), WorldFileError);
}

}  // namespace
}  // namespace vfh_astar
