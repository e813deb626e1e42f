#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "benchmark/command.h"
#include "benchmark/cycle_command.h"
#include "benchmark/drive_command.h"
#include "benchmark/mapping_command.h"
#include "benchmark/planner_command.h"
#include "benchmark/simulator_command.h"
#include "vfh_astar/parameters.h"

namespace {

namespace po = boost::program_options;
using vfh_astar::Command;

std::vector<Command> Commands() {
  return {vfh_astar::CycleCommand(), vfh_astar::DriveCommand(),
          vfh_astar::MappingCommand(), vfh_astar::PlannerCommand(),
          vfh_astar::SimulatorCommand()};
}

int FailUsage(const std::string& program) {
  std::cerr << "usage: " << program << " COMMAND [OPTION ...]\ncommands:";
  for (const Command& command : Commands()) std::cerr << ' ' << command.name;
  std::cerr << "\n";
  return 2;
}

/// @return false when help was asked for and given instead.
bool Parse(Command& command, const std::vector<std::string>& arguments,
           po::variables_map* given) {
  command.options.add_options()("help,h", "print this");
  po::store(po::command_line_parser(arguments).options(command.options).run(),
            *given);
  if (given->count("help") != 0) {
    std::cout << "usage: " << command.name << " [OPTION ...]\n"
              << command.options;
    return false;
  }
  po::notify(*given);
  return true;
}

/// @return the exit status: 0 when there are figures, whatever they are; 1 for
///   a failure; 2 for unusable arguments; 3 for parameters of the stack that it
///   does not take.
int Run(Command& command, const std::vector<std::string>& arguments) {
  const auto fail = [&command](const std::exception& error, int status) {
    std::cerr << command.name << ": " << error.what() << "\n";
    if (status == 2) std::cerr << command.options;
    return status;
  };
  try {
    po::variables_map given;
    if (!Parse(command, arguments, &given)) return 0;
    std::cout << command.run(given).dump(2) << "\n";
    return 0;
  } catch (const po::error& error) {
    return fail(error, 2);
  } catch (const vfh_astar::OptionError& error) {
    return fail(error, 2);
  } catch (const vfh_astar::ParameterError& error) {
    return fail(error, 3);
  } catch (const std::exception& error) {
    return fail(error, 1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return FailUsage(argv[0]);
  for (Command& command : Commands()) {
    if (command.name == argv[1]) {
      return Run(command, std::vector<std::string>(argv + 2, argv + argc));
    }
  }
  return FailUsage(argv[0]);
}
