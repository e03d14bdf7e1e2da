#include "splitsum/truth/view_split_sum.h"

#include "splitsum/base/parallel.h"
#include "splitsum/table/chebyshev.h"
#include "splitsum/table/split_sum_exact.h"

namespace splitsum {
namespace {

constexpr double lowest = 1e-3;

int node_count() { return log_chebyshev_nodes(lowest, 1e-9); }

}  // namespace

ViewSplitSum::ViewSplitSum(double alpha) : alpha_(alpha) {
    if (alpha == 0) return;
    const LogChebyshev nodes(lowest, node_count(), {});
    a_.resize(nodes.nodes().size());
    b_.resize(a_.size());
    parallel_rows(int(a_.size()), [&](int i) {
        const SplitSum sum =
            split_sum_exact(SmithTerm::height_correlated, nodes.nodes()[size_t(i)], alpha);
        a_[size_t(i)] = sum.a;
        b_[size_t(i)] = sum.b;
    });
}

SplitSum ViewSplitSum::at(double n_dot_v) const {
    if (alpha_ == 0) return mirror_split_sum(n_dot_v);
    if (n_dot_v < lowest) return split_sum_exact(SmithTerm::height_correlated, n_dot_v, alpha_);
    const LogChebyshev polynomial(lowest, node_count(), {&n_dot_v, 1});
    return {polynomial.at_point(a_, 0), polynomial.at_point(b_, 0)};
}

}  // namespace splitsum
