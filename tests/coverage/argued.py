"""Conditions in the proofs that no test makes both true and false, and why: {(file, line of the source): reason}."""

NOME = "include/libration/elliptic/proved/landen_nome.hpp"
ANGLE = "include/libration/scalar/ball/arctangent.hpp"
TURNED = "include/libration/scalar/ball/turned_point.hpp"
MOTION = "src/libration/pendulum/motion/motion.cpp"

ARGUED = {
    (NOME, "const bool bounded = zero || (mag_is_finite(size) != 0 && fmpz_fits_si(MAG_EXPREF(size)) != 0);"):
        "no memory holds a number whose exponent is no long",
    (NOME, "if (least < 3) {"): "the descent ends with e below 2^-4; kept, because the series of the nome rests on it",
    (NOME, "if (small_ < 3) {"): "P is below 1.1 e; kept, because theorem (2) rests on it",
    ("include/libration/pendulum/proved/proved_libration.hpp", "while (levels_ < most_levels) {"):
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
    ("src/libration/pendulum/motion/decision.cpp", "if (problem.kind() != error_kind::undecided) {"):
        "no sign of a formula fails otherwise; another failure has to pass",
    (MOTION, "theta0_ && theta0_->is_angle() && denominator(theta0_->in_pi()) == 1 && numerator(theta0_->in_pi()) % 2 != 0;"):
        "a motion without theta0 is given by its energy, which has its quarter before",
    (MOTION, "} else if (omega0_sign_ == 0 || (on_top && regime_ == pendulum::regime::rotation)) {"):
        "with a speed on top E is above 2",
}
