#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "core/error.h"
#include "core/progress.h"
#include "core/thread_pool.h"
#include "fem/solid/block_matrix.h"
#include "fem/solid/dense_tiles.h"
#include "fem/solid/symbolic_factor.h"
#include "fem/zero_pages.h"

namespace bodkin::fem {

// The matrix is not positive definite in double precision: at least one node is not supported.
class NotPositiveDefinite : public InputError {
 public:
  explicit NotPositiveDefinite(std::uint32_t node);
  std::uint32_t node = 0;  // its number in the matrix
};

struct FactorOptions {
  // Threads for the dense parts; 0: one per core. The bits do not depend on their number.
  int threads = 0;
  // Bytes that the factorisation may use; 0: available_memory(). The requirement is known, and refused, beforehand.
  std::size_t memory_limit = 0;
  // Keep the whole factor, for solve() and respond(), or only that of the last nodes, in a fraction of the memory.
  bool keep_field = true;
  // Receives the panel of each supernode when it is finished, in their order, as from kept_panel(); the pool is idle
  // then. A caller that stores the factor elsewhere does not need keep_field, and saves half the memory.
  std::function<void(std::size_t supernode, const double* panel, ThreadPool& pool)> finished = {};
  // Bytes used elsewhere at the same time, as by the receiver of the panels: included in the requirement.
  std::size_t used_elsewhere = 0;
  // The innermost loops; nullptr: the fastest of the processor. The bits do not depend on them.
  const DenseTiles* tiles = nullptr;
};

// K = L L^T of a sparse symmetric positive definite matrix of 3 x 3 blocks, multifrontal (Duff & Reid 1983; Liu, The
// multifrontal method for sparse matrix solution, 1992): every supernode is a dense matrix that is assembled from the
// matrix and from its children's updates, factorised, and leaves an update for its parent. With the corridor last,
// its block of L is the Cholesky factor of the corridor's condensed stiffness. Factor and compliance have the same
// bits for the same input, with any number of threads and on any processor; solve() and respond() do not.
class MultifrontalCholesky {
 public:
  // `symbolic` must come from graph_of(matrix). Throws InputError when the memory needed is above the limit, and
  // NotPositiveDefinite.
  MultifrontalCholesky(const BlockMatrix& matrix, SymbolicFactor symbolic, const FactorOptions& options = {},
                       const Progress& progress = {});

  const SymbolicFactor& symbolic() const noexcept { return symbolic_; }

  // (P^T K^-1 P) of the last nodes P, in the order given: the displacement of each of them by a force on each of
  // them. Symmetric to the last bit.
  Eigen::MatrixXd last_compliance() const;

  // K^-1 forces, for any number of columns. Only with keep_field.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& forces) const;
  // As solve(), for forces only on the last nodes (3 rows for each of them), at a little more than half the cost.
  Eigen::MatrixXd respond(const Eigen::MatrixXd& forces_on_last) const;
  // The panel of L of a supernode, column by column: height() x width() numbers; those above the diagonal of its own
  // columns are meaningless. Only with keep_field.
  const double* kept_panel(std::size_t supernode) const;

 private:
  double* panel(std::size_t supernode) const noexcept;
  bool is_last(std::size_t supernode) const noexcept;
  const DenseTiles& tiles() const noexcept {
    return options_.tiles != nullptr ? *options_.tiles : dense_tiles().front();
  }
  void factorise(const BlockMatrix& matrix, ThreadPool& pool, const Progress& progress);
  void substitute_forward(std::size_t supernode, Eigen::MatrixXd& x, Eigen::MatrixXd& work) const;
  Eigen::MatrixXd substitute_back(Eigen::MatrixXd& x) const;

  SymbolicFactor symbolic_;
  FactorOptions options_;
  ZeroPages panels_;  // of all supernodes, or one that all use one after another
  ZeroPages last_;    // the panel of the last nodes, unless it is among `panels_`
};

}  // namespace bodkin::fem
