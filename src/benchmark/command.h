#ifndef VFH_ASTAR_BENCHMARK_COMMAND_H_
#define VFH_ASTAR_BENCHMARK_COMMAND_H_

#include <boost/program_options.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace vfh_astar {

/// An option whose value cannot be used; the message names it, the value and
/// what was expected.
class OptionError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// One of the benchmark program's commands.
struct Command {
  std::string name;
  boost::program_options::options_description options;
  /// Gives the figures that are printed as JSON.
  /// @throws OptionError; anything else that is thrown is a failure of the run.
  std::function<nlohmann::json(const boost::program_options::variables_map&)>
      run;
};

/// The value of a numeric option.
/// @throws OptionError outside of `min` to `max`.
template <typename T>
T NumberOption(const boost::program_options::variables_map& options,
               const std::string& name, T min, T max);

extern template int NumberOption(const boost::program_options::variables_map&,
                                 const std::string&, int, int);
extern template double NumberOption(
    const boost::program_options::variables_map&, const std::string&, double,
    double);

}  // namespace vfh_astar

#endif  // VFH_ASTAR_BENCHMARK_COMMAND_H_
