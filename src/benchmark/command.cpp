#include "benchmark/command.h"

#include <sstream>

namespace vfh_astar {

template <typename T>
T NumberOption(const boost::program_options::variables_map& options,
               const std::string& name, T min, T max) {
  const T value = options[name].as<T>();
  // Written so that NaN fails.
  if (min <= value && value <= max) return value;
  std::ostringstream message;
  message << "--" << name << " is " << value << "; expected " << min << " to "
          << max;
  throw OptionError(message.str());
}

template int NumberOption(const boost::program_options::variables_map&,
                          const std::string&, int, int);
template double NumberOption(const boost::program_options::variables_map&,
                             const std::string&, double, double);

}  // namespace vfh_astar
