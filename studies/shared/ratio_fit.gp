# The line of a Domb-Sykes plot that follows from a verdict about the nearest singularity: ratios a_n/a_{n-p} of a series
# in t^p with (1 - (t/t0)^p)^nu tend to t0^-p (1 - p (nu + 1)/n). Cells of the verdict are text, empty if it has none.

# The intercept t0^-p; NaN if the singularity is unknown or not the only one on the circle in t^p.
fit_of(p, r, re, im, count) = strlen(r) == 0 || strlen(re) == 0 ? NaN : fit_at(p, number(r), number(re), im eq '' ? 0.0 : number(im), count + 0)
# The argument of t0^p must be a multiple of pi: within a degree, since p copies of one singularity are at equal angles.
fit_at(p, r, re, im, count) = (fit_turns = p * atan2(im, re) / pi, abs(fit_turns - floor(fit_turns + 0.5)) > 1 / 180.0 ? NaN : (int(abs(floor(fit_turns + 0.5))) % 2 ? -1 : 1) * r ** -p)
fit_slope(p, level, exponent) = level == level && strlen(exponent) ? -p * (number(exponent) + 1) : NaN
fit_uncertainty(p, level, r, uncertainty) = level == level && strlen(uncertainty) ? abs(level) * p * number(uncertainty) / number(r) : 0
# What the panel states about it.
digits_in_all(r, u) = strlen(u) && number(u) > 0 && number(r) > 0 ? floor(log10(number(r) / number(u))) + 2 : 10
digits_beside(r, u) = int(larger(2, smaller(15, digits_in_all(r, u))))
# Rounded to fewer digits than the uncertainty leaves, R is not within it.
is_rounded(r, u) = digits_in_all(r, u) > 15
with_uncertainty(r, u) = (is_rounded(r, u) ? 'R ≈ ' : 'R = ').in_powers(printed(sprintf('%%.%dg', digits_beside(r, u)), r)).(strlen(u) ? (is_rounded(r, u) ? ', uncertainty ' : ' ± ').in_powers(printed('%.2g', u)) : '')
fit_in_words(r, u, exponent) = strlen(r) == 0 ? 'no radius is found' : with_uncertainty(r, u).(strlen(exponent) ? ', exponent '.in_powers(printed('%.6g', exponent)) : '')
intercept_in_words(level, r, u) = strlen(r) == 0 ? ' ' : level == level ? 'intercept '.in_powers(printed(sprintf('%%.%dg', smaller(10, digits_beside(r, u))), sprintf('%.15g', level))) : 'a pair is nearest: the ratios have no intercept'
