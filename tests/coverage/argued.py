"""Conditions in the proofs that no test makes both true and false, and why: {(file, line of the source): reason}."""

NOME = "include/libration/elliptic/landen_nome.hpp"
ANGLE = "include/libration/scalar/ball/arctangent.hpp"
TURNED = "include/libration/scalar/ball/turned_point.hpp"
MOTION = "src/libration/pendulum/motion.cpp"
LIFTED = "src/libration/equation/polynomial_form.cpp"
DISC = "src/libration/plane/complex_disc.cpp"
CONDITIONS = "src/libration/query/condition_numbers.cpp"
EVENTS = "src/libration/event/zero_search.cpp"
KNOWN = "src/libration/problem/known/"
SHOOTING = "src/libration/problem/known/shooting.cpp"
ATOM = "src/libration/problem/known/thomas_fermi.cpp"
SERIES_RULE = "src/libration/integration/taylor/taylor_rule.cpp"
ROOT = "src/libration/algebra/krawczyk.cpp"
BOUNDS = "src/libration/plane/radius_bound.cpp"
PLACE = "src/libration/plane/proved_singularity.cpp"
STEP = "src/libration/integration/singular_step.cpp"
TAIL = "src/libration/expansion/tail_bound.cpp"
DECIMALS = "src/libration/digits/proved_decimals.cpp"
PRODUCT = "src/libration/scalar/ball/product_guard.cpp"
SAKIADIS = "src/libration/problem/known/sakiadis.cpp"
FLOW = "src/libration/query/flow_derivatives.cpp"
COLLOCATION = "src/libration/integration/collocation/collocation_integrator.cpp"
MORE_BITS = "ends the attempt, and the next one has more bits; no test is so short of them there and not before"

ARGUED = {
    (NOME, "const bool bounded = zero || (mag_is_finite(size) != 0 && fmpz_fits_si(MAG_EXPREF(size)) != 0);"):
        "no memory holds a number whose exponent is no long",
    (NOME, "if (least < 3) {"): "the descent ends with e below 2^-4; kept, because the series of the nome rests on it",
    (NOME, "if (small_ < 3) {"): "P is below 1.1 e; kept, because theorem (2) rests on it",
    ("include/libration/pendulum/proved_libration.hpp", "while (levels_ < most_levels) {"):
        "e squares itself at every level: the energies that are served end before the array does",
    (ANGLE, "if (!known || size > 0 || size < -8 || arb_rel_accuracy_bits(ratio.handle()) < 16) {"):
        "FLINT keeps the angles of the table; a release that keeps others is what it is asked for",
    (ANGLE, "const long small = is_finite(rough) ? -binary_exponent(rough) : 0;"):
        "x is not 0 in a narrow point next to the axis; kept for any relations",
    (ANGLE, "if (small < 9) {"): "the relations of the table turn below 2^-9; nothing is proved about them",
    (ANGLE, "if (binary_exponent(angle) > 1) {"): "as above: the angle is the one of y/x, below pi/4; the proof asks for 2",
    (TURNED, "if (arb_overlaps(ldexp(angle, 1).handle(), _arb_atan_gauss_p_cache_vec() + j) == 0) {"):
        "FLINT keeps the angles of the table",
    (TURNED, "return std::fabs(units) < std::ldexp(1, 62) ? static_cast<std::int64_t>(units) : 0;"):
        "|y/x| < 1 at the scale 2^61, and what the coarse relations leave at the scale of the fine ones",
    ("src/libration/pendulum/decision.cpp", "if (problem.kind() != error_kind::undecided) {"):
        "no sign of a formula fails otherwise; another failure has to pass",
    (MOTION, "theta0_ && theta0_->is_angle() && denominator(theta0_->in_pi()) == 1 && numerator(theta0_->in_pi()) % 2 != 0;"):
        "a motion without theta0 is given by its energy, which has its quarter before",
    (MOTION, "} else if (omega0_sign_ == 0 || (on_top && regime_ == pendulum::regime::rotation)) {"):
        "with a speed on top E is above 2",
    (NOME, "const long exponent = zero || !bounded ? -bits_ : fmpz_get_si(MAG_EXPREF(size));"):
        "no memory holds a number whose exponent is no long",
    (NOME, "return bounded ? std::min(-exponent, bits_ + 8) : 0;"): "no memory holds a number whose exponent is no long",
    (NOME, "for (long level = 1; level <= longest; ++level) {"):
        "the descent ends by its own test; the count bounds what no proof needs",
    (LIFTED, "expression inverse(const expression& u) { return u.is_constant() ? 1 / u : added(expression(1) / u); }"):
        "expressions fold what is made of constants alone; kept for expressions that C++ builds in another way",
    (LIFTED, "if (u.is_constant()) {"): "as above",
    ("src/libration/problem/known/blasius.cpp", "for (int time = 8; time <= latest_time; time += 2) {"):
        "f'' falls like exp(-t^2/4): before t = 1000 it is below any precision that memory holds",
    ("src/libration/problem/known/blasius.cpp", "if (!state) {"): MORE_BITS,
    (LIFTED, "const auto x = values.refusal_of(e.left()) ? std::nullopt : values.value_of(e.left()).fraction();"):
        "equations whose right-hand side has no value at the start are rejected before; kept, because a value is taken",
    (DECIMALS, "if (!decimal || !has_a_digit(*decimal)) {"):
        "a decimal is less than a unit of its last digit away; kept, because what is printed here counts as proved",
    (PRODUCT, "if (products_are_checked()) {"): "every product is checked as long as the tests run; no other program does so unasked",
    (SAKIADIS, "for (int step = 0; step < most_steps; ++step) {"):
        "steers a prediction, proves nothing: Newton's method has converged for each number of coefficients that is tested",
    (COLLOCATION, "auto proved = candidate ? rule(*proof, *candidate, set) : std::nullopt;"):
        "a frame has been found wherever Newton's method converged; without one the step is halved",
    (FLOW, "if (problem.kind() != error_kind::argument) {"):
        "the names that are asked for alone make the opening fail; another failure has to pass",
    (DISC, "if (!set_tail_) {"): "a set without values is seen before; kept, because no radius is no disc",
    (DISC, "if (!tail_) {"): "the centre lies in the set, whose radius holds; kept, because no bound is no proof",
    (CONDITIONS, "if (!is_finite(moved)) {"):
        "a map that is not finite ends the march; kept, because the comparison behind it would take infinity",
    (CONDITIONS, "if (radius * 2048 <= middle || contains_zero(size)) {"):
        "an unknown that is 0 has been moved by 0 exactly; kept for enclosures of it",
    (EVENTS, "if (open_) {"): "a monotone function does not turn: it says a mistake of the library",
    (EVENTS, "if (parts_.empty()) {"): "the zero of joined pieces is on one of them: it says a mistake of the library",
    (EVENTS, "const bool narrow = no_use || p.is_narrow(bits_);"):
        "in a piece so short the rounding of the value in the middle exceeds its change; kept, because the halving ends by it",
    (EVENTS, "(behind && known_sign(of_state(slope_, last * direction_)) != bent)) {"):
        "a slope that is too wide to have a sign behind the turn has none before it, where it is asked for first",
    (EVENTS, "if (sign != sign_) {"):
        "the sign at the end of a piece is computed from the same enclosures as that on the next one, which begins there",
    (EVENTS, "if (!place) {"): "as above: Newton's method excludes no zero at an end where the sign is not known",
    (EVENTS, "const bool inside = exactly_less(p.from, place) && exactly_less(place, p.to);"):
        "places are inside of their piece, unless the first cut has left a part without the second one",
    (EVENTS, "const int sign = inside ? sign_at(place) : 0;"): "as above",
    (EVENTS, "return cut(last) || before;"):
        "g is known at three quarters where it is at one quarter, unless its enclosures are much wider there",
    (SERIES_RULE, "for (int halving = 0; halving < most_halvings_for_width && now > significant_uncertainty; ++halving) {"):
        "a limit of the work: any length of a step is valid, and no set of the tests needs one 32 times as short",
    (SERIES_RULE, "if (bits > set_bits_) {"): "a set that has an expansion has one with more bits",
    (SHOOTING, "if (difference == 0) {"): "steers the guess, proves nothing: two values that differ have missed differently",
    (SHOOTING, "if (mpfr_number_p(handle(value)) == 0) {"):
        "steers the guess: solutions from bad guesses end before, by an error",
    (ATOM, "return less(v, T(0)) && less(T(y * y * sqrt(y) * 4), T(s * v * v)) ? std::optional(side::below) : std::nullopt;"):
        "of a slope that is neither above nor below 0 nothing is said; no march has met it",
    (ATOM, "if (!(y > 0)) {"): "steers the bisection, proves nothing: what passes below 0 has been seen to do so before",
    (ROOT, "if (!inverse) {"): "the second time: the same derivative had an inverse in Newton's method",
    (BOUNDS, "if (magnitude(length) < finest_ && magnitude(width) < finest_) {"): "cells become small in both ways together",
    (BOUNDS, "if (!certainly_less(ball(c.re * c.re + c.im * c.im), ball(cell.r1 * cell.r1))) {"):
        "the discs that are asked belong to cells that hold this one, with centres nearer to 0; theorem L needs it",
    (BOUNDS, "if (best == nullptr) {"): "the first disc always is nearer to 0; kept, because it is dereferenced",
    (BOUNDS, "if (!last && !certainly_less(ball(next.re * next.re + next.im * next.im), farthest)) {"):
        "a corner on a straight way is nearer to 0 than its farther end; rounding alone could make it not so",
    (BOUNDS, "if (certainly_not_zero(change)) {"): "where an unknown changes its contour integral has been told from 0 before",
    (PLACE, "for (const unknown_function& each : system.unknowns()) {"):
        "names in a message on several systems of which one is not covered, which takes minutes to find out",
    (PLACE, 'names += (names.empty() ? "" : ", ") + each.name;'): "as above",
    (PLACE, '(systems.size() > 1 ? ", proved; of " + joined_names(each.system) + " it is at least "'): "as above",
    (PLACE, '(systems.size() > 1 ? ", proved" : ", both proved") + "; more is not: " + found.reason);'): "as above",
    (PLACE, "last ? most_loop_attempts : 2, route);"):
        "a singularity of a map that no loop shows, with up to eight times the digits: the maps alone take minutes",
    (PLACE, "if (last) {"): "as above",
    (PLACE, "if (problem.kind() != error_kind::undecided) {"): "no way is refused for another reason; another one has to pass",
    (PLACE, "return one_zero && (regular->order() == 1 || certainly_not_zero(regular->factor(time_at(within), over)));"):
        "the factor is 2 a2/3 at a pole, and the reach small; kept, because a zero of p alone is no pole",
    (STEP, "if (bound) {"): "a radius among those that are tried has held for every start; kept, because no bound is no proof",
    (STEP, "if (refusal.kind() == error_kind::argument) {"): "no start is refused for another reason; another one has to pass",
    (TAIL, "if (!std::ranges::all_of(next, [](const magnitude& each) { return each.is_finite(); })) {"):
        "magnitudes have no largest exponent: infinity comes from balls alone, which are refused before",
}
