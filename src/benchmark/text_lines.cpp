#include "benchmark/text_lines.h"

#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace vfh_astar {
namespace {

using GzFile = std::unique_ptr<gzFile_s, int (*)(gzFile)>;

/// The text, and whether it ends where the file means it to.
std::pair<std::string, bool> ReadText(const std::string& file) {
  const GzFile stream(gzopen(file.c_str(), "rb"), gzclose);
  if (!stream) {
    throw std::runtime_error(file +
                             ": cannot be read: " + std::strerror(errno));
  }
  std::string text;
  std::array<char, 1 << 16> buffer;
  int count = 0;
  while ((count = gzread(stream.get(), buffer.data(), buffer.size())) > 0) {
    text.append(buffer.data(), count);
  }
  int status = Z_OK;
  const char* const message = gzerror(stream.get(), &status);
  if (status == Z_BUF_ERROR) return {std::move(text), false};
  if (status != Z_OK && status != Z_STREAM_END) {
    throw std::runtime_error(
        file + ": cannot be read: " +
        (status == Z_ERRNO ? std::strerror(errno) : message));
  }
  return {std::move(text), true};
}

}  // namespace

TextLines ReadTextLines(const std::string& file) {
  const auto [text, is_whole] = ReadText(file);
  TextLines result;
  result.is_complete = is_whole && (text.empty() || text.back() == '\n');
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    result.lines.push_back(text.substr(begin, end - begin));
    std::string& line = result.lines.back();
    if (!line.empty() && line.back() == '\r') line.pop_back();
    begin = end + 1;
  }
  return result;
}

}  // namespace vfh_astar
