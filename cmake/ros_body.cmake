# What runs under ROS: the nodelets, the simulator node, the RViz panel, and the
# install rules of the whole package.
function(vfh_astar_use_ros target)
  target_include_directories(${target}
    PRIVATE ${CATKIN_DEVEL_PREFIX}/${CATKIN_GLOBAL_INCLUDE_DESTINATION})
  target_include_directories(${target} SYSTEM PRIVATE ${catkin_INCLUDE_DIRS})
  target_link_libraries(${target} PRIVATE ${catkin_LIBRARIES})
  add_dependencies(${target}
    ${${PROJECT_NAME}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS})
endfunction()

set(VFH_ASTAR_ROS_TARGETS)

file(GLOB VFH_ASTAR_NODELET_SOURCES CONFIGURE_DEPENDS
  src/ros/*.cpp src/nodelets/*.cpp)
if(VFH_ASTAR_NODELET_SOURCES)
  add_library(${PROJECT_NAME}_nodelets ${VFH_ASTAR_NODELET_SOURCES})
  target_link_libraries(${PROJECT_NAME}_nodelets PRIVATE ${PROJECT_NAME}_core)
  vfh_astar_use_ros(${PROJECT_NAME}_nodelets)
  list(APPEND VFH_ASTAR_ROS_TARGETS ${PROJECT_NAME}_nodelets)
endif()

set(VFH_ASTAR_NAVIGATION_NODE_SOURCE
  ${CMAKE_CURRENT_SOURCE_DIR}/src/nodes/navigation_node.cpp)
add_executable(navigation_node ${VFH_ASTAR_NAVIGATION_NODE_SOURCE})
target_include_directories(navigation_node SYSTEM PRIVATE ${OpenCV_INCLUDE_DIRS})
target_link_libraries(navigation_node PRIVATE opencv_core)
vfh_astar_use_ros(navigation_node)
list(APPEND VFH_ASTAR_ROS_TARGETS navigation_node)

file(GLOB VFH_ASTAR_SIMULATOR_NODE_SOURCES CONFIGURE_DEPENDS src/nodes/*.cpp)
list(REMOVE_ITEM VFH_ASTAR_SIMULATOR_NODE_SOURCES
  ${VFH_ASTAR_NAVIGATION_NODE_SOURCE})
if(VFH_ASTAR_SIMULATOR_NODE_SOURCES)
  add_executable(simulator_node ${VFH_ASTAR_SIMULATOR_NODE_SOURCES})
  target_link_libraries(simulator_node
    PRIVATE ${PROJECT_NAME}_simulation ${PROJECT_NAME}_nodelets)
  vfh_astar_use_ros(simulator_node)
  list(APPEND VFH_ASTAR_ROS_TARGETS simulator_node)
endif()

# A robot has no RViz; the panel is built where RViz's headers are.
file(GLOB VFH_ASTAR_RVIZ_SOURCES CONFIGURE_DEPENDS src/rviz/*.cpp)
find_package(rviz QUIET)
if(VFH_ASTAR_RVIZ_SOURCES AND rviz_FOUND)
  find_package(Qt5 REQUIRED COMPONENTS Widgets)
  add_library(${PROJECT_NAME}_rviz ${VFH_ASTAR_RVIZ_SOURCES})
  set_target_properties(${PROJECT_NAME}_rviz PROPERTIES AUTOMOC ON)
  target_compile_definitions(${PROJECT_NAME}_rviz PRIVATE QT_NO_KEYWORDS)
  target_include_directories(${PROJECT_NAME}_rviz
    SYSTEM PRIVATE ${rviz_INCLUDE_DIRS} ${OGRE_INCLUDE_DIRS})
  target_link_libraries(${PROJECT_NAME}_rviz
    PRIVATE ${PROJECT_NAME}_core ${rviz_LIBRARIES} Qt5::Widgets)
  vfh_astar_use_ros(${PROJECT_NAME}_rviz)
  list(APPEND VFH_ASTAR_ROS_TARGETS ${PROJECT_NAME}_rviz)
endif()

install(
  TARGETS ${PROJECT_NAME}_core ${PROJECT_NAME}_simulation
    ${PROJECT_NAME}_benchmark ${VFH_ASTAR_ROS_TARGETS}
  ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(DIRECTORY include/${PROJECT_NAME}/
  DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
install(FILES nodelets.xml
  DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
install(DIRECTORY config launch rviz urdf worlds
  DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
