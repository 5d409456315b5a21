#pragma once

#include "fem/moving/node_matrix.h"

namespace bodkin {

struct GradientsSettings {
  // Of the residual, in the norm of the inverse diagonal, by that of the right side or of the first residual,
  // whichever is larger; 0 to 1.
  double tolerance = 1e-2;
  int most_iterations = 200;  // 1 or more
};

// Solves matrix x = right for the nodes that are free, those held staying where they are in x: conjugate gradients,
// each node's own block inverted as preconditioner (Shewchuk 1994; Golub & Van Loan, 11.5). Memory is taken at
// construction.
class ConjugateGradients {
 public:
  explicit ConjugateGradients(std::size_t nodes);

  // `matrix` with invert_diagonal() done, which says what is held. `x` is where to begin. Returns the iterations
  // made; `x` is not a number when the numbers were not finite. Never throws or allocates.
  int solve(const NodeMatrix& matrix, const NodeVectors& right, const GradientsSettings& settings,
            NodeVectors& x) noexcept;

 private:
  NodeVectors residual_, direction_, turned_, product_;
};

}  // namespace bodkin
