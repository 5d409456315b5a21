#pragma once

#include "fem/moving/node_matrix.h"

namespace bodkin::fem {

struct GradientsSettings {
  // Of the residual that one begins with, in the norm of the preconditioner; 0 to 1. What is below 1e-6 of the right
  // side is never worth an iteration.
  double tolerance = 1e-2;
  int most_iterations = 200;  // 1 or more
};

// Solves K x = right for the nodes that are free, those held staying where they are in x: conjugate gradients with
// Gauss and Seidel's symmetric preconditioner M = (D + L) D^-1 (D + L)^T over the nodes, K = D + L + L^T. They are
// those of the system (D + L)^-1 K (D + L)^-T, preconditioned by D^-1, of which K and D themselves drop out: an
// iteration goes through the matrix once (Eisenstat, SIAM J. Sci. Stat. Comput. 2, 1, 1981). What x changes by is
// found in single precision, about 1e-6 of it; who wants more solves again. Memory is taken at construction.
class ConjugateGradients {
 public:
  explicit ConjugateGradients(std::size_t nodes);

  // `matrix` with invert_diagonal() done, which says what is held. `x` is where to begin. Returns the iterations
  // made; `x` is not a number when the numbers were not finite. Never throws or allocates.
  int solve(const NodeMatrix& matrix, const NodeVectors& right, const GradientsSettings& settings,
            NodeVectors& x) noexcept;

 private:
  double begin(const NodeMatrix& matrix, const NodeVectors& right) noexcept;

  NodeVectors product_;                             // K x, N, and what it leaves of the right side
  SingleVectors right_, change_;                    // N; mm by which x changes
  SingleVectors residual_, scaled_, direction_;     // of the preconditioned system; scaled_ is D residual_
  SingleVectors way_, above_, back_, back_scaled_;  // (D + L)^-T direction_; what else the sweeps give
};

}  // namespace bodkin::fem
