#include "vfh_astar/simulation/normal_noise.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace vfh_astar {
namespace {

constexpr int kLayers = 128;
/// Where the lowest layer ends and the tail begins, and the area under
/// exp(-x^2 / 2) of each layer: the pair with which 128 layers end at 0.
constexpr double kTail = 3.442619855899;
constexpr double kArea = 9.91256303526217e-3;

/// exp(-x^2 / 2) lies between steps: layer i reaches to edges[i] on its lower
/// side and to edges[i + 1] on its upper one.
struct Ziggurat {
  std::array<double, kLayers + 1> edges;

  Ziggurat() {
    // As wide as if the tail were part of a rectangle.
    edges[0] = kArea / std::exp(-0.5 * kTail * kTail);
    edges[1] = kTail;
    for (int i = 2; i < kLayers; ++i) {
      const double below = edges[i - 1];
      edges[i] = std::sqrt(
          -2.0 * std::log(kArea / below + std::exp(-0.5 * below * below)));
    }
    edges[kLayers] = 0.0;
  }
};

/// In (0, 1).
double DrawUniform(std::mt19937* random) {
  return ((*random)() + 0.5) * 0x1p-32;
}

double DrawTail(std::mt19937* random) {
  double beyond = 0.0;
  double height = 0.0;
  do {
    beyond = -std::log(DrawUniform(random)) / kTail;
    height = -std::log(DrawUniform(random));
  } while (2.0 * height < beyond * beyond);
  return kTail + beyond;
}

}  // namespace

double DrawNormal(std::mt19937* random) {
  static const Ziggurat ziggurat;
  for (;;) {
    const std::uint32_t bits = (*random)();
    const std::uint32_t layer = bits % kLayers;
    const double sign = (bits & kLayers) != 0 ? -1.0 : 1.0;
    const double x = (bits >> 8) * 0x1p-24 * ziggurat.edges[layer];
    const double upper = ziggurat.edges[layer + 1];
    if (x < upper) return sign * x;
    if (layer == 0) return sign * DrawTail(random);
    // In the part of the layer that the curve cuts.
    const double lower = ziggurat.edges[layer];
    const double top = std::exp(-0.5 * upper * upper);
    const double bottom = std::exp(-0.5 * lower * lower);
    if (bottom + DrawUniform(random) * (top - bottom) <
        std::exp(-0.5 * x * x)) {
      return sign * x;
    }
  }
}

}  // namespace vfh_astar
