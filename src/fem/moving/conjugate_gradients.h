#pragma once

#include "fem/moving/node_matrix.h"

namespace bodkin::fem {

struct GradientsSettings {
  // Relative to the initial residual, in the norm of the preconditioner; 0 to 1. The solver never iterates below 1e-6
  // of the right side.
  double tolerance = 1e-2;
  int most_iterations = 200;  // 1 or more
};

// Solves K x = right for the free nodes, the held nodes keeping their values in x: conjugate gradients with the
// symmetric Gauss-Seidel preconditioner M = (D + L) D^-1 (D + L)^T over the nodes, K = D + L + L^T. They are computed
// as those of the system (D + L)^-1 K (D + L)^-T, preconditioned by D^-1, in which K and D themselves cancel: an
// iteration passes through the matrix once (Eisenstat, SIAM J. Sci. Stat. Comput. 2, 1, 1981). The change of x is
// found in single precision, to about 1e-6 of it; call again for more. Memory is allocated by the constructor.
class ConjugateGradients {
 public:
  explicit ConjugateGradients(std::size_t nodes);

  // `matrix` after invert_diagonal(), which defines the held nodes. `x`: the initial guess. Returns the number of
  // iterations; `x` is NaN if the input was not finite. Never throws or allocates.
  int solve(const NodeMatrix& matrix, const NodeVectors& right, const GradientsSettings& settings,
            NodeVectors& x) noexcept;

 private:
  double begin(const NodeMatrix& matrix, const NodeVectors& right) noexcept;

  NodeVectors product_;                             // K x, N, and the remaining right side
  SingleVectors right_, change_;                    // N; mm, the change of x
  SingleVectors residual_, scaled_, direction_;     // of the preconditioned system; scaled_ is D residual_
  SingleVectors way_, above_, back_, back_scaled_;  // (D + L)^-T direction_; other results of the sweeps
};

}  // namespace bodkin::fem
