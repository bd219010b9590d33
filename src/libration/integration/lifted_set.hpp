// Sets of the given unknowns as sets of all unknowns of a polynomial form, and back.
#pragma once

#include <cstddef>
#include <optional>

#include "libration/equation/polynomial_form.hpp"
#include "libration/integration/collocation/tube.hpp"

namespace libration::ode {

/// The unknowns of the polynomial form for every state of a set of the given ones, at every time of a ball. An added
/// unknown is a function w(t, y) with the derivative G = w_y, and by the mean value theorem, for y = c + C e + a in the
/// set,
///     w(t, y) in w(t, c) + (G C) e + G a,
/// with G over the whole set, which is convex: the added unknowns have the same e as the given ones, so that nothing of
/// their dependence is lost. std::nullopt if w or G is not finite on the set.
std::optional<tube_set> lifted_set(const polynomial_form& of, const ball& time, const state_set& given);

/// A set of the first `count` unknowns that contains those of the given set, with as many columns in blocks of one: its
/// own ones, or, if it has more unknowns, an orthonormal basis of the longest combinations of the columns times their
/// radii, by Lohner's rule. std::nullopt if none is found.
std::optional<state_set> set_of_first(std::size_t count, const state_set& of);

}  // namespace libration::ode
