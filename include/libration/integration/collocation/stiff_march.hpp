// The solution of any system in rounded arithmetic: by Taylor series, and by collocation where the equations are stiff.
#pragma once

#include <memory>
#include <vector>

#include "libration/integration/integrator.hpp"
#include "libration/integration/taylor/taylor_march.hpp"

namespace libration::ode {

/// An integration in real time in the arithmetic of T, as taylor_march is one, in which steps of collocation replace
/// those of Taylor series. These are limited to R/e^2, and with fast modes R is about 1/|lambda|; collocation at
/// Chebyshev-Radau nodes is L-stable, and its steps grow with the scale of the solution: Robertson's equations to
/// t = 1e11 in 70 of them. Residuals in double are computed in long double.
///
/// Unless the integrator is chosen, it begins where the solution is smooth over 32 steps of Taylor series, by an L-stable
/// method of low order, which is checked after 8, 16, 32, .. of them if very many more would follow; it ends where its
/// steps take longer than those of Taylor series, or where Newton's method fails. Errors: in each step some epsilon of
/// the largest value of each unknown in it, amplified by the flow; nothing is proved.
///
/// Between steps the polynomial is the solution, and steps do not depend on the requested times, except that the
/// farthest of them decides whether collocation pays off.
template <ordered_scalar T>
class stiff_march {
public:
    /// Throws error like taylor_march; of the subject "integrator" if collocation is chosen and there are too many
    /// unknowns for it. The system and the product must outlive this object.
    explicit stiff_march(const explicit_system& system, integrator_choice choice = integrator_choice::automatic,
                         const series::block_product<T>* fast = nullptr);
    ~stiff_march();

    /// Announces the farthest time in a direction.
    void head_for(const T& farthest);
    /// The unknowns and their lower derivatives at time t, forwards or backwards. Throws error if the steps become too
    /// small before t.
    const solution_state<T>& advance_to(const T& t);
    /// The steps of collocation so far, one entry for each direction of time with any.
    std::vector<collocation_use> collocation() const;

private:
    struct parts;
    std::unique_ptr<parts> parts_;
};

extern template class stiff_march<double>;
extern template class stiff_march<long double>;
extern template class stiff_march<quad>;
extern template class stiff_march<mpfr>;

}  // namespace libration::ode
