#ifndef VFH_ASTAR_TEST_SHARED_DATA_H_
#define VFH_ASTAR_TEST_SHARED_DATA_H_

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace vfh_astar {

/// Where third-party test data lies: VFH_ASTAR_DATA, else beside the checkout.
inline std::string SharedData(const std::string& path) {
  const char* const folder = std::getenv("VFH_ASTAR_DATA");
  const std::filesystem::path root =
      folder != nullptr ? folder : VFH_ASTAR_SOURCE_DIR "/../shared/data";
  return (root / path).string();
}

}  // namespace vfh_astar

/// Ends a test with one line where the data is absent.
#define VFH_ASTAR_SKIP_WITHOUT(path)                                  \
  if (!std::filesystem::exists(path)) {                               \
    GTEST_SKIP() << "no test data at " << (path)                      \
                 << "; the variable VFH_ASTAR_DATA names its folder"; \
  }

#endif  // VFH_ASTAR_TEST_SHARED_DATA_H_
