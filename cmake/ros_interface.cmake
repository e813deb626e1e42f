# Messages, services, dynamic_reconfigure headers and what catkin tells other
# packages. Included before any target, as catkin_package() sets where they go.
set(VFH_ASTAR_CATKIN_DEPENDENCIES
  actionlib
  actionlib_msgs
  diagnostic_updater
  dynamic_reconfigure
  geometry_msgs
  map_msgs
  move_base_msgs
  nav_msgs
  nodelet
  pluginlib
  rosgraph_msgs
  roscpp
  sensor_msgs
  std_msgs
  std_srvs
  tf2
  tf2_geometry_msgs
  tf2_ros
  visualization_msgs)
find_package(catkin REQUIRED
  COMPONENTS ${VFH_ASTAR_CATKIN_DEPENDENCIES} message_generation)

function(vfh_astar_file_names variable pattern)
  file(GLOB paths CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${pattern})
  set(names)
  foreach(path IN LISTS paths)
    get_filename_component(name ${path} NAME)
    list(APPEND names ${name})
  endforeach()
  set(${variable} ${names} PARENT_SCOPE)
endfunction()

vfh_astar_file_names(VFH_ASTAR_MESSAGES msg/*.msg)
if(VFH_ASTAR_MESSAGES)
  add_message_files(DIRECTORY msg FILES ${VFH_ASTAR_MESSAGES})
endif()
vfh_astar_file_names(VFH_ASTAR_SERVICES srv/*.srv)
if(VFH_ASTAR_SERVICES)
  add_service_files(DIRECTORY srv FILES ${VFH_ASTAR_SERVICES})
endif()
generate_messages(DEPENDENCIES geometry_msgs nav_msgs sensor_msgs std_msgs)

file(GLOB VFH_ASTAR_RECONFIGURABLES CONFIGURE_DEPENDS cfg/*.cfg)
if(VFH_ASTAR_RECONFIGURABLES)
  generate_dynamic_reconfigure_options(${VFH_ASTAR_RECONFIGURABLES})
endif()

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES ${PROJECT_NAME}_core ${PROJECT_NAME}_simulation
    ${PROJECT_NAME}_nodelets
  CATKIN_DEPENDS ${VFH_ASTAR_CATKIN_DEPENDENCIES} message_runtime
  DEPENDS EIGEN3 OpenCV)

# The generators put ROS's folders on the include path of every target to come.
# The core must do without, so only the targets that name them get them.
set_property(DIRECTORY PROPERTY INCLUDE_DIRECTORIES "")
