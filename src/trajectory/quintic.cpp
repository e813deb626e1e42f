#include "vfh_astar/trajectory/quintic.h"

#include <cassert>

namespace vfh_astar {

Jet Evaluate(const Quintic& quintic, double duration, double tau) {
  assert(duration > 0.0);
  const double* c = quintic.data();
  const double rate = 1.0 / duration;
  Jet jet;
  jet.value =
      c[0] +
      tau * (c[1] + tau * (c[2] + tau * (c[3] + tau * (c[4] + tau * c[5]))));
  jet.first =
      rate * (c[1] + tau * (2.0 * c[2] +
                            tau * (3.0 * c[3] +
                                   tau * (4.0 * c[4] + tau * 5.0 * c[5]))));
  jet.second = rate * rate *
               (2.0 * c[2] +
                tau * (6.0 * c[3] + tau * (12.0 * c[4] + tau * 20.0 * c[5])));
  jet.third = rate * rate * rate *
              (6.0 * c[3] + tau * (24.0 * c[4] + tau * 60.0 * c[5]));
  return jet;
}

Quintic HermiteQuintic(const Jet& start, const Jet& end, double duration) {
  assert(duration > 0.0);
  Quintic c;
  c[0] = start.value;
  c[1] = start.first * duration;
  c[2] = 0.5 * start.second * duration * duration;
  // What the first three coefficients leave open at tau = 1.
  const double value = end.value - c[0] - c[1] - c[2];
  const double first = end.first * duration - c[1] - 2.0 * c[2];
  const double second = end.second * duration * duration - 2.0 * c[2];
  c[3] = 10.0 * value - 4.0 * first + 0.5 * second;
  c[4] = -15.0 * value + 7.0 * first - second;
  c[5] = 6.0 * value - 3.0 * first + 0.5 * second;
  return c;
}

}  // namespace vfh_astar
