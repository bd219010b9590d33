#include "libration/expansion/taylor_expansion.hpp"

namespace libration::ode {

template class step_arrays<double>;
template class step_arrays<long double>;
template class step_arrays<quad>;
template class step_arrays<mpfr>;
template class step_arrays<rational>;
template class step_arrays<complex_number<double>>;
template class step_arrays<complex_number<mpfr>>;

template class taylor_expansion<double>;
template class taylor_expansion<long double>;
template class taylor_expansion<quad>;
template class taylor_expansion<mpfr>;
template class taylor_expansion<rational>;
template class taylor_expansion<complex_number<double>>;
template class taylor_expansion<complex_number<mpfr>>;

}  // namespace libration::ode
