#include "fem/solid/multifrontal_cholesky.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "fem/solid/available_memory.h"
#include "fem/solid/dense_front.h"
#include "fem/solid/dense_kernels.h"
#include "fem/solid/front_assembly.h"

namespace bodkin::fem {

namespace {

// A pivot that rounding alone can leave from a diagonal entry. Bone in fat, ten million times as stiff, leaves 1e-8.
constexpr double no_pivot = 1e-12;
constexpr std::size_t columns_at_once = 256;  // per emptied update; the system then provides its pages

// The whole update `full` as its lower triangle, packed, further down in the same memory.
void pack(const double* full, std::size_t height, double* packed) {
  for (std::size_t column = 0; column < height; ++column) {
    std::memmove(packed, full + column * height + column, (height - column) * sizeof(double));
    packed += height - column;
  }
}

}  // namespace

NotPositiveDefinite::NotPositiveDefinite(std::uint32_t at)
    : InputError(fmt::format("nothing holds node {} of the equations: the matrix is not positive definite", at)),
      node(at) {}

MultifrontalCholesky::MultifrontalCholesky(const BlockMatrix& matrix, SymbolicFactor symbolic,
                                           const FactorOptions& options, const Progress& progress)
    : symbolic_(std::move(symbolic)), options_(options) {
  const std::size_t limit = options_.memory_limit > 0 ? options_.memory_limit : available_memory();
  const std::size_t needed = symbolic_.bytes(options_.keep_field) + options_.used_elsewhere;
  if (needed > limit) {
    throw InputError(
        fmt::format("the body's {} free nodes with {} in the corridor need {} bytes ({:.1f} GB) to be "
                    "prepared, but only {} ({:.1f} GB) may be taken; mesh more coarsely, choose a smaller "
                    "corridor, or allow more memory",
                    matrix.nodes, symbolic_.last, needed, static_cast<double>(needed) * 1e-9, limit,
                    static_cast<double>(limit) * 1e-9));
  }
  use_one_thread_each();
  ThreadPool pool(options_.threads);
  factorise(matrix, pool, progress);
}

bool MultifrontalCholesky::is_last(std::size_t supernode) const noexcept {
  return symbolic_.last > 0 && supernode + 1 == symbolic_.supernodes.size();
}

double* MultifrontalCholesky::panel(std::size_t supernode) const noexcept {
  if (options_.keep_field) return panels_.data() + symbolic_.supernodes[supernode].panel_at;
  return is_last(supernode) ? last_.data() : panels_.data();
}

const double* MultifrontalCholesky::kept_panel(std::size_t supernode) const {
  if (!options_.keep_field) throw std::logic_error("the factor was not kept");
  return panel(supernode);
}

void MultifrontalCholesky::factorise(const BlockMatrix& matrix, ThreadPool& pool, const Progress& progress) {
  panels_ = ZeroPages(options_.keep_field ? symbolic_.factor_size : symbolic_.largest_panel);
  if (!options_.keep_field) last_ = ZeroPages(symbolic_.last_size());
  const ZeroPages stack(symbolic_.stack_size);
  double* top = stack.data();
  std::vector<std::uint32_t> waiting;  // supernodes whose updates are on the stack
  FrontAssembly assembly(matrix, symbolic_);
  double done = 0.0, reported = 0.0;
  for (std::uint32_t s = 0; s < symbolic_.supernodes.size(); ++s) {
    const Supernode& supernode = symbolic_.supernodes[s];
    const Front front{panel(s), top, &supernode};
    const std::size_t height = front.height(), width = front.width(), below = front.update_height();
    if (!options_.keep_field && !is_last(s)) std::fill_n(front.panel, supernode.panel_size(), 0.0);
    pool.run((below + columns_at_once - 1) / columns_at_once, [&](std::size_t piece) {
      const std::size_t first = piece * columns_at_once;
      for (std::size_t j = first; j < std::min(below, first + columns_at_once); ++j)
        std::fill_n(front.update + j * below + j, below - j, 0.0);
    });
    assembly.add_matrix(front);
    for (std::uint32_t child = 0; child < supernode.children; ++child) {
      const Supernode& from = symbolic_.supernodes[waiting.back()];
      waiting.pop_back();
      top -= from.update_size();
      assembly.add_update(front, from, top);
    }
    std::vector<double> diagonal;  // of the matrix, before anything was subtracted
    for (std::uint32_t k = 0; k < supernode.columns; ++k) {
      const Mat3& block = matrix.block[matrix.start[symbolic_.order[supernode.first + k]]];
      for (Eigen::Index i = 0; i < 3; ++i) diagonal.push_back(block(i, i));
    }
    const std::size_t sound = factorise_front(pool, width, height, front.panel, front.update, tiles());
    for (std::size_t i = 0; i < width; ++i) {
      const double pivot = front.panel[i * height + i];
      if (i < sound && pivot * pivot > no_pivot * diagonal[i]) continue;
      throw NotPositiveDefinite(symbolic_.order[supernode.first + i / 3]);
    }
    if (options_.finished) options_.finished(s, front.panel, pool);
    if (below > 0) {
      pack(front.update, below, top);
      waiting.push_back(s);
      top += supernode.update_size();
    }
    done += supernode.operations();
    if (progress && done >= reported + 0.01 * symbolic_.operations) {
      reported = done;
      progress("factorising the body", std::min(1.0, done / symbolic_.operations));
    }
  }
  if (!options_.keep_field) panels_ = ZeroPages();
}

Eigen::MatrixXd MultifrontalCholesky::last_compliance() const {
  const auto size = 3 * Eigen::Index{symbolic_.last};
  if (size == 0) return {};
  use_one_thread_each();
  ThreadPool pool(options_.threads);
  Eigen::MatrixXd compliance(size, size);
  prefer_large_pages(compliance.data(), sizeof(double) * static_cast<std::size_t>(compliance.size()));
  invert_from_lower(pool, static_cast<std::size_t>(size), panel(symbolic_.supernodes.size() - 1), compliance.data(),
                    tiles());
  return compliance;
}

// x of the supernode's columns := L^-1 x, and their updates of the rows below.
void MultifrontalCholesky::substitute_forward(std::size_t index, Eigen::MatrixXd& x, Eigen::MatrixXd& work) const {
  const Supernode& supernode = symbolic_.supernodes[index];
  const auto columns = static_cast<std::size_t>(x.cols()), lead = static_cast<std::size_t>(x.rows());
  double* const own = x.data() + 3 * std::size_t{supernode.first};
  solve_lower(supernode.width(), columns, panel(index), supernode.height(), own, lead);
  if (supernode.rows == 0) return;
  const std::size_t below = 3 * std::size_t{supernode.rows};
  multiply(below, supernode.width(), columns, panel(index) + supernode.width(), supernode.height(), own, lead,
           work.data(), lead);
  for (Eigen::Index j = 0; j < x.cols(); ++j)
    for (std::uint32_t k = 0; k < supernode.rows; ++k)
      x.col(j).segment<3>(3 * Eigen::Index{symbolic_.rows[supernode.rows_at + k]}) -=
          work.col(j).segment<3>(3 * Eigen::Index{k});
}

Eigen::MatrixXd MultifrontalCholesky::substitute_back(Eigen::MatrixXd& x) const {
  const auto columns = static_cast<std::size_t>(x.cols()), lead = static_cast<std::size_t>(x.rows());
  Eigen::MatrixXd work(x.rows(), x.cols());
  for (std::size_t s = symbolic_.supernodes.size(); s-- > 0;) {
    const Supernode& supernode = symbolic_.supernodes[s];
    double* const own = x.data() + 3 * std::size_t{supernode.first};
    if (supernode.rows > 0) {
      for (Eigen::Index j = 0; j < x.cols(); ++j)
        for (std::uint32_t k = 0; k < supernode.rows; ++k)
          work.col(j).segment<3>(3 * Eigen::Index{k}) =
              x.col(j).segment<3>(3 * Eigen::Index{symbolic_.rows[supernode.rows_at + k]});
      subtract_transposed_product(3 * std::size_t{supernode.rows}, supernode.width(), columns,
                                  panel(s) + supernode.width(), supernode.height(), work.data(), lead, own, lead);
    }
    solve_lower_transposed(supernode.width(), columns, panel(s), supernode.height(), own, lead);
  }
  for (Eigen::Index node = 0; node < static_cast<Eigen::Index>(symbolic_.order.size()); ++node)
    work.middleRows<3>(3 * Eigen::Index{symbolic_.order[static_cast<std::size_t>(node)]}) = x.middleRows<3>(3 * node);
  return work;
}

Eigen::MatrixXd MultifrontalCholesky::solve(const Eigen::MatrixXd& forces) const {
  if (!options_.keep_field) throw std::logic_error("the factor was not kept");
  use_one_thread_each();
  Eigen::MatrixXd x(forces.rows(), forces.cols()), work(forces.rows(), forces.cols());
  for (Eigen::Index node = 0; node < static_cast<Eigen::Index>(symbolic_.order.size()); ++node)
    x.middleRows<3>(3 * node) =
        forces.middleRows<3>(3 * Eigen::Index{symbolic_.order[static_cast<std::size_t>(node)]});
  for (std::size_t s = 0; s < symbolic_.supernodes.size(); ++s) substitute_forward(s, x, work);
  return substitute_back(x);
}

Eigen::MatrixXd MultifrontalCholesky::respond(const Eigen::MatrixXd& forces_on_last) const {
  if (!options_.keep_field) throw std::logic_error("the factor was not kept");
  use_one_thread_each();
  const auto size = static_cast<Eigen::Index>(3 * symbolic_.order.size());
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(size, forces_on_last.cols()), work;
  x.bottomRows(forces_on_last.rows()) = forces_on_last;
  if (symbolic_.last > 0) substitute_forward(symbolic_.supernodes.size() - 1, x, work);
  return substitute_back(x);
}

}  // namespace bodkin::fem
