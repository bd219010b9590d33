// FLINT's products of whole sequences, for long series over balls and mpfr.
#pragma once

#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/mpfr.hpp"
#include "libration/series/blocked_sums.hpp"

namespace libration::ode {

/// The product for expansions of at least some hundred terms in the working precision: on balls it returns enclosures,
/// whose radii are those of the larger terms of a block; in mpfr it rounds to about the last place of the larger terms
/// of a block. Null for other scalars, which have no fast product. Always returns the same object.
template <class R>
const series::block_product<R>* fast_product() {
    return nullptr;
}

template <>
const series::block_product<ball>* fast_product<ball>();
template <>
const series::block_product<mpfr>* fast_product<mpfr>();

}  // namespace libration::ode
