// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/detail/cholesky.hpp>

#include <cholmod.h>

#include <cmath>
#include <dlfcn.h>
#include <limits>

namespace fretwork::mechanics::detail {
namespace {

/// A pivot that has lost this many digits against its diagonal is zero: what is left of it is rounding.
constexpr double kZeroPivot = 64.0 * std::numeric_limits<double>::epsilon();

/// Threaded BLAS changes the last digits and gains nothing on supernodes as small as these. Whichever library
/// is loaded, it is told to use one thread, once for the process.
void pin_blas_to_one_thread() {
    static const bool pinned = [] {
        for (const char* name :
             {"openblas_set_num_threads", "bli_thread_set_num_threads", "MKL_Set_Num_Threads"}) {
            if (void* symbol = dlsym(RTLD_DEFAULT, name)) reinterpret_cast<void (*)(int)>(symbol)(1);
        }
        return true;
    }();
    static_cast<void>(pinned);
}

}  // namespace

class Cholesky::Impl {
  public:
    explicit Impl(const SystemLayout& layout) : layout_(&layout) {
        pin_blas_to_one_thread();
        cholmod_start(&common_);
        common_.print = 0;
        common_.nmethods = 1;
        common_.method[0].ordering = CHOLMOD_NATURAL;
        common_.postorder = 0;
        common_.quick_return_if_not_posdef = 1;
        matrix_.nrow = matrix_.ncol = static_cast<std::size_t>(layout.equations());
        matrix_.nzmax = layout.row().size();
        matrix_.p =
            const_cast<int*>(layout.column_start().data());  // CHOLMOD reads what it takes unqualified
        matrix_.i = const_cast<int*>(layout.row().data());
        matrix_.stype = -1;
        matrix_.itype = CHOLMOD_INT;
        matrix_.xtype = CHOLMOD_REAL;
        matrix_.dtype = CHOLMOD_DOUBLE;
        matrix_.sorted = matrix_.packed = 1;
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        cholmod_free_factor(&definite_, &common_);
        cholmod_free_factor(&indefinite_, &common_);
        cholmod_free_dense(&solution_, &common_);
        cholmod_free_dense(&work_y_, &common_);
        cholmod_free_dense(&work_e_, &common_);
        cholmod_finish(&common_);
    }

    Outcome factorize(std::span<const double> values) {
        matrix_.x = const_cast<double*>(values.data());
        const int zero = vanishing_diagonal(values);
        if (zero >= 0) return {0, zero};
        if (definite_ == nullptr) definite_ = analyze(CHOLMOD_SUPERNODAL);
        current_ = definite_;
        run(definite_);
        if (definite_->minor == definite_->n) return {0, weak_supernodal_pivot(values)};
        if (indefinite_ == nullptr) indefinite_ = analyze(CHOLMOD_SIMPLICIAL);
        current_ = indefinite_;
        run(indefinite_);
        return count_pivots(values);
    }

    void solve(Eigen::Ref<Eigen::MatrixXd> b) {
        cholmod_dense right{};
        right.nrow = right.d = static_cast<std::size_t>(b.rows());
        right.ncol = static_cast<std::size_t>(b.cols());
        right.nzmax = static_cast<std::size_t>(b.size());
        right.x = b.data();
        right.xtype = CHOLMOD_REAL;
        right.dtype = CHOLMOD_DOUBLE;
        if (!cholmod_solve2(CHOLMOD_A, current_, &right, nullptr, &solution_, nullptr, &work_y_, &work_e_,
                            &common_))
            throw base::NumericalError("the factorized system could not be solved: out of memory");
        b = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(solution_->x), b.rows(), b.cols());
    }

  private:
    cholmod_factor* analyze(int supernodal) {
        common_.supernodal = supernodal;
        cholmod_factor* factor = cholmod_analyze(&matrix_, &common_);
        if (factor == nullptr)
            throw base::NumericalError("the stiffness could not be analyzed: out of memory");
        return factor;
    }

    void run(cholmod_factor* factor) {
        common_.supernodal = factor == definite_ ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
        common_.final_ll = 0;
        cholmod_factorize(&matrix_, factor, &common_);
        if (common_.status < CHOLMOD_OK)
            throw base::NumericalError("the stiffness could not be factorized: out of memory");
    }

    [[nodiscard]] double diagonal(std::span<const double> values, int equation) const {
        return values[static_cast<std::size_t>(layout_->column_start()[static_cast<std::size_t>(equation)])];
    }

    [[nodiscard]] int vanishing_diagonal(std::span<const double> values) const {
        for (int i = 0; i < layout_->equations(); ++i) {
            const double entry = diagonal(values, i);
            if (!std::isfinite(entry))
                throw base::NumericalError("the stiffness holds a number that is not finite");
            if (entry == 0.0) return i;
        }
        return -1;
    }

    /// The equation of the pivot that is smallest against its diagonal, if it is zero up to rounding.
    [[nodiscard]] int weak_supernodal_pivot(std::span<const double> values) const {
        const auto* super = static_cast<const int*>(definite_->super);
        const auto* row_start = static_cast<const int*>(definite_->pi);
        const auto* value_start = static_cast<const int*>(definite_->px);
        const auto* x = static_cast<const double*>(definite_->x);
        int weakest = -1;
        double least = kZeroPivot;
        for (std::size_t s = 0; s < definite_->nsuper; ++s) {
            const int rows = row_start[s + 1] - row_start[s];
            for (int k = 0; k < super[s + 1] - super[s]; ++k) {
                const double root = x[value_start[s] + k + k * rows];
                const double ratio = root * root / diagonal(values, super[s] + k);
                if (!(ratio >= least)) {
                    weakest = super[s] + k;
                    least = ratio;
                }
            }
        }
        return weakest;
    }

    [[nodiscard]] Outcome count_pivots(std::span<const double> values) const {
        const auto* start = static_cast<const int*>(indefinite_->p);
        const auto* x = static_cast<const double*>(indefinite_->x);
        Outcome outcome;
        if (indefinite_->minor < indefinite_->n) outcome.zero_pivot = static_cast<int>(indefinite_->minor);
        for (int i = 0; i < static_cast<int>(indefinite_->minor); ++i) {
            const double pivot = x[start[i]];
            if (!(std::abs(pivot) > kZeroPivot * std::abs(diagonal(values, i)))) outcome.zero_pivot = i;
            if (pivot < 0) ++outcome.negative_pivots;
        }
        return outcome;
    }

    const SystemLayout* layout_;
    cholmod_common common_{};
    cholmod_sparse matrix_{};
    cholmod_factor* definite_ = nullptr;
    cholmod_factor* indefinite_ = nullptr;
    cholmod_factor* current_ = nullptr;
    cholmod_dense* solution_ = nullptr;
    cholmod_dense* work_y_ = nullptr;
    cholmod_dense* work_e_ = nullptr;
};

Cholesky::Cholesky(const SystemLayout& layout) : impl_(std::make_unique<Impl>(layout)) {}
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;
Cholesky::~Cholesky() = default;

Cholesky::Outcome Cholesky::factorize(std::span<const double> values) {
    return impl_->factorize(values);
}

void Cholesky::solve(Eigen::VectorXd& right_side) {
    impl_->solve(right_side);
}

void Cholesky::solve(Eigen::MatrixXd& right_sides) {
    impl_->solve(right_sides);
}

void add_product(const SystemLayout& layout, std::span<const double> values, const Eigen::VectorXd& x,
                 Eigen::VectorXd& y) {
    const auto& start = layout.column_start();
    for (int column = 0; column < layout.equations(); ++column) {
        auto k = static_cast<std::size_t>(start[static_cast<std::size_t>(column)]);
        const auto end = static_cast<std::size_t>(start[static_cast<std::size_t>(column) + 1]);
        double sum = values[k] * x[column];
        for (++k; k < end; ++k) {
            const int row = layout.row()[k];
            y[row] += values[k] * x[column];
            sum += values[k] * x[row];
        }
        y[column] += sum;
    }
}

}  // namespace fretwork::mechanics::detail
