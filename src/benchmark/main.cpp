#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "benchmark/drive_command.h"
#include "benchmark/mapping_command.h"
#include "benchmark/planner_command.h"
#include "benchmark/simulator_command.h"

int main(int argc, char** argv) {
  using Command = std::function<int(const std::vector<std::string>&)>;
  const std::map<std::string, Command> commands = {
      {"drive", vfh_astar::RunDriveCommand},
      {"mapping", vfh_astar::RunMappingCommand},
      {"planner", vfh_astar::RunPlannerCommand},
      {"simulator", vfh_astar::RunSimulatorCommand},
  };
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const auto command =
      arguments.empty() ? commands.end() : commands.find(arguments.front());
  if (command == commands.end()) {
    std::cerr << "usage: " << argv[0] << " COMMAND [OPTION ...]\ncommands:";
    for (const auto& [name, run] : commands) std::cerr << ' ' << name;
    std::cerr << "\n";
    return 2;
  }
  try {
    return command->second({arguments.begin() + 1, arguments.end()});
  } catch (const std::exception& error) {
    std::cerr << command->first << ": " << error.what() << "\n";
    return 1;
  }
}
