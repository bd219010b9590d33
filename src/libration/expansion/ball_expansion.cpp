#include "libration/expansion/ball_expansion.hpp"

namespace libration::ode {

template class taylor_expansion<ball>;
template class taylor_expansion<complex_number<ball>>;

}  // namespace libration::ode
