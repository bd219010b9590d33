/* The C interface of Libration: exact motions of the pendulum and any differential equations, in proved digits.
 *
 * Strings. Every number is passed as a string and is exact as written: 1.71, 171/100, 1e-30, 3pi/4, 150deg, 2-1e-10,
 * sqrt(2), a time also as T/4, an exact binary number as 6004799503160661*2^-53 (libration_exact_text). Strings are
 * UTF-8 and null-terminated; lists are separated by commas; a string that may be NULL may also be empty. Returned
 * strings belong to the object that was passed and are valid as long as it exists. Arrays are declared with [].
 *
 * Numbers are returned as handles: a decimal, a bound of its error, and its rigour. D digits are D significant digits,
 * correct to one unit in the last digit. Nothing is computed in double precision except by the sampler.
 *
 * Errors. A function that can fail returns a code, LIBRATION_OK = 0 on success, and writes to its last arguments only
 * on success (except libration_problem_known_states). The error is kept for each thread until its next call that fails:
 * libration_error_message(). No exception leaves a function. Failed allocations in C++, GMP or FLINT, and FLINT's own
 * aborts (flint_throw, flint_abort), become codes; the thread in which that happened is not used again, and nothing is
 * unwound through FLINT, so what the call had allocated is not freed. A call whose memory requirement is known in
 * advance fails before it starts. Not handled: what the system does beyond malloc (the OOM killer, a full stack), and
 * pthread_cancel during a call.
 *
 * Threads. Precision is an argument; no state is shared. Functions may be called from any number of threads, also with
 * the same motion, problem, sampler, table or number, which no call changes; of calls with the same solution, and with the same law, one waits
 * for the other. The caller is responsible for freeing. For
 * each calling thread another thread computes while the caller waits, from its first call until it ends, with signals
 * blocked and floating point in its default mode; MPFR's settings and flags of the calling thread are neither read nor
 * changed. Only the sampler computes in the calling thread. A child process may call functions after fork().
 */
#ifndef LIBRATION_H
#define LIBRATION_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Codes. 1 and 2: undefined, the question as stated has no result. 3: unable, the result was not decided or not
 * computed within the limits. */
enum {
    LIBRATION_OK = 0,
    LIBRATION_ARGUMENT = 1,  /* malformed, NULL, or outside the domain: give another value */
    LIBRATION_RANGE = 2,     /* beyond the range of the requested type, or the buffer is too small */
    LIBRATION_UNDECIDED = 3, /* no precision, proof or method within the limits decides; the value itself is valid */
    LIBRATION_CANCELLED = 4, /* cancelled by the progress callback */
    LIBRATION_NO_MEMORY = 5, /* or less than required, as reported in the message: request less */
    LIBRATION_FAULT = 6 /* a bug in this library or in one that it uses */
};

/* The rigour of a number, and the requested rigour: PROVED by ball arithmetic; ROUNDED by runs in MPFR that agree, or
 * by an a priori error bound. */
enum { LIBRATION_HEURISTIC = 0, LIBRATION_ROUNDED = 1, LIBRATION_PROVED = 2 };

typedef struct libration_number libration_number;
typedef struct libration_table libration_table;
typedef struct libration_motion libration_motion;
typedef struct libration_problem libration_problem;
typedef struct libration_solution libration_solution;
typedef struct libration_law libration_law;
typedef struct libration_sampler libration_sampler;
typedef struct libration_steps libration_steps;

/* Progress callback: called now and then with the part that is done, 0 .. 1, in the calling thread; a nonzero result
 * cancels the call. May be NULL. */
typedef int (*libration_watch)(double part, void *context);

/* The version of the library, such as 1.0.0. The interface is only ever extended; its soname version is 1. */
const char *libration_version(void);

/* The last error of this thread, empty strings before the first: "energy '-1' is negative", and its parts: the
 * quantity, its value, the reason. They are valid until the next error of the thread. */
const char *libration_error_message(void);
const char *libration_error_subject(void);
const char *libration_error_value(void);
const char *libration_error_reason(void);

/* ---- Numbers: free those that a function returned, not those of a table. ---- */

/* The number given by a string, to proved digits. */
int libration_number_read(const char *text, long digits, libration_number **number);
/* A number as it was written earlier, for example to a file: its digits, the bound of their error and its rigour, which
 * are not verified. */
int libration_number_of(const char *decimal, const char *uncertainty, int rigour, libration_number **number);
/* mantissa * 2^exponent as a string that every function here reads exactly; the mantissa a decimal integer. RANGE if it
 * does not fit into `size` characters with the terminating 0: the length of the mantissa plus 32 is sufficient. */
int libration_exact_text(const char *mantissa, long exponent, char *text, size_t size);

/* The digits: -1.2897755603, 1.5e-30, inf; 0 is exactly 0; of fractions p/q. */
const char *libration_number_decimal(const libration_number *number);
/* A bound of |decimal - exact number|, three digits; for heuristic numbers an estimate, empty if there is none. */
const char *libration_number_uncertainty(const libration_number *number);
/* LIBRATION_PROVED, LIBRATION_ROUNDED or LIBRATION_HEURISTIC. */
int libration_number_rigour(const libration_number *number);
/* The double nearest to the exact number; UNDECIDED if the digits do not determine it. */
int libration_number_double(const libration_number *number, double *nearest);
/* Doubles below and above, as near as the digits allow. */
int libration_number_bounds(const libration_number *number, double *lower, double *upper);
/* |exact number - mantissa 2^exponent| <= radius 2^radius_exponent; the mantissa as a decimal integer. RANGE for
 * infinity, and if `size` is less than libration_number_mantissa_size(). */
int libration_number_exact(const libration_number *number, char *mantissa, size_t size, long *exponent,
                           unsigned long *radius, long *radius_exponent);
size_t libration_number_mantissa_size(const libration_number *number);
void libration_number_free(libration_number *number);

/* ---- Tables: rows and named columns. A cell is a number, words, or empty. ---- */

size_t libration_table_rows(const libration_table *table);
size_t libration_table_columns(const libration_table *table);
/* Rows and columns are numbered from 0; out of range a string is empty and a number NULL. */
const char *libration_table_name(const libration_table *table, size_t column);
const char *libration_table_text(const libration_table *table, size_t row, size_t column);
/* NULL for words. Valid as long as the table exists. */
const libration_number *libration_table_number(const libration_table *table, size_t row, size_t column);
void libration_table_free(libration_table *table);

/* ---- Motions of theta'' + sin theta = 0. Times in sqrt(length/gravity), energies in units of m g length; with a
 *      length and a gravity in seconds and rad/s. ---- */

/* "theta0 = 150deg; omega0 = 0", "energy = 1.71; direction = -", "gap = 1e-30": an energy, or the gap 2 - E, from the
 * canonical initial state (the top, at E = 2 the bottom) or from a theta0; or theta0 and omega0. Also length and
 * gravity. */
int libration_motion_new(const char *given, libration_motion **motion);
/* libration, rotation, separatrix, stable-equilibrium or unstable-equilibrium. */
const char *libration_motion_regime(const libration_motion *motion);
/* theta, not reduced modulo 2 pi, and omega at a time. */
int libration_motion_theta(const libration_motion *motion, const char *time, long digits, int rigour,
                           libration_number **theta);
int libration_motion_omega(const libration_motion *motion, const char *time, long digits, int rigour,
                           libration_number **omega);
/* Both at a list of times, "0,1.5,T/4": time as typed, theta, omega. */
int libration_motion_states(const libration_motion *motion, const char *times, long digits, int rigour,
                            libration_watch watch, void *context, libration_table **states);
/* T, for a rotation the time of one turn, and T* from the top to the bottom; inf at E = 2. */
int libration_motion_period(const libration_motion *motion, long digits, int rigour, libration_number **period);
int libration_motion_effective_period(const libration_motion *motion, long digits, int rigour,
                                      libration_number **period);
/* E and 2 - E. */
int libration_motion_energy(const libration_motion *motion, long digits, int rigour, libration_number **energy);
int libration_motion_gap(const libration_motion *motion, long digits, int rigour, libration_number **gap);
/* The radius of convergence of the series of theta about a point, top, bottom, start or a time; NULL is the top, at
 * E = 2 the bottom. inf at rest. */
int libration_motion_radius(const libration_motion *motion, const char *point, long digits, int rigour,
                            libration_number **radius);
/* Coefficients first .. last about a point: n, coefficient. */
int libration_motion_coefficients(const libration_motion *motion, const char *point, long first, long last, long digits,
                                  int rigour, libration_table **coefficients);
void libration_motion_free(libration_motion *motion);

/* ---- Any differential equation. ---- */

/* The text of a problem, "x'' = -sin(x); x(0) = 2; x'(0) = 0", or without = a name of the catalogue, "lorenz"; and
 * parameters or initial values to be changed, "r = 28; x(0) = 1/2", or NULL. With intervals for
 * some of them, "x(0) = [0.9, 1.1]", it has bounds (libration_problem_enclosures). With events, piecewise right-hand sides or
 * delays it has values at times (libration_problem_states, libration_problem_flow from its initial state) and events; the
 * other functions return ARGUMENT. */
int libration_problem_new(const char *text, const char *settings, libration_problem **problem);
/* The unknowns and their lower derivatives, x, x', in the order of the columns of states. */
size_t libration_problem_size(const libration_problem *problem);
const char *libration_problem_name(const libration_problem *problem, size_t i);
/* Their values at a list of times: time as typed, and one column each. PROVED is an error for singular initial points
 * if the right-hand sides are not polynomials; a time that is not reached is UNDECIDED, and the message contains the
 * time up to which the solution is proved to exist. The callback is called in proofs. */
int libration_problem_states(const libration_problem *problem, const char *times, long digits, int rigour,
                             libration_watch watch, void *context, libration_table **states);
/* The same, but UNDECIDED also gives a table, which must be freed: with PROVED a row for each time with the proved
 * values, a value that is not distinguished from 0 as 0 with the bound of its size as uncertainty (only "0" is exactly
 * 0), and an empty cell, whose number is NULL, if the equations of the unknown are not proved to reach the time. The
 * message is the first reason for a missing value. NULL on every other error. */
int libration_problem_known_states(const libration_problem *problem, const char *times, long digits, int rigour,
                                   libration_watch watch, void *context, libration_table **states);
/* The same, proved, with the derivatives of every value with respect to `numbers`, initial values and parameters of the
 * problem, "x(0), x'(0), r": time, one column for each name, then dx(t)/dx(0), dx(t)/dx'(0), dx(t)/dr for the first name,
 * and so on. The derivative with respect to a parameter includes the motion of initial values that contain it. */
int libration_problem_derivatives(const libration_problem *problem, const char *times, const char *numbers, long digits,
                                  libration_watch watch, void *context, libration_table **derivatives);
/* Coefficients first .. last of every unknown about a point, NULL for the initial point, else a time, also complex,
 * 1+2i, through corners in the complex plane, "1+i,2+i", or NULL: n and one column each; about a complex point x_re and
 * x_im, only ROUNDED; for powers of t^(1/q) followed by a column power. */
int libration_problem_coefficients(const libration_problem *problem, const char *point, const char *corners, long first,
                                   long last, long digits, int rigour, libration_table **coefficients);
/* The same about the initial point as exact fractions p/q; ARGUMENT if they are not fractions. */
int libration_problem_fractions(const libration_problem *problem, long first, long last,
                                libration_table **coefficients);
/* The radius of convergence about the initial point from coefficients 0 .. last, heuristic: one row per test, first the
 * verdict of the nearest unknown; method, unknown, radius (with its uncertainty), position_re, position_im, exponent,
 * kind, count, note. */
int libration_problem_radius(const libration_problem *problem, long last, long digits, libration_table **tests);
/* Proved bounds lower <= R <= upper, upper - lower < lower 10^-digits; both inf if every solution is entire by the
 * form of the equations. */
int libration_problem_radius_bounds(const libration_problem *problem, long digits, libration_number **lower,
                                    libration_number **upper);
/* The singularities within a distance of the initial point in the complex t-plane, NULL for twice that of the nearest,
 * on the branch reached along rays: position_re, position_im, modulus, kind, exponent_re, exponent_im, unknown. PROVED
 * positions have a singularity within their uncertainty; kinds and exponents are always heuristic. HEURISTIC or PROVED;
 * `complete`, which may be NULL, is 1 if the whole disc was searched, 0 if a part of it is unresolved. */
int libration_problem_singularities(const libration_problem *problem, const char *within, long digits, int rigour,
                                    libration_table **singularities, int *complete);
/* The unknowns and their lower derivatives at infinite time, proved: one row, at a stable equilibrium that the solution
 * approaches, or by a lemma on the problem. UNDECIDED if neither is found; it also gives a table if a value is not
 * distinguished from 0, which is then 0 as in libration_problem_known_states. */
int libration_problem_limits(const libration_problem *problem, long digits, libration_table **limits);
/* Bounds of all solutions of a problem whose initial values or parameters are intervals, "x(0) = [0.9, 1.1]; b = 1 +-
 * 0.1", or of the single solution: at times, and over spans of time, "1, 0:10", in at most so many parts of the set
 * (64 is usual). from, to, unknown, lower, upper: a row for each time and unknown; between two decimals, rounded outwards,
 * lie its values in all solutions at all of these times, proved. UNDECIDED also gives a table, of the times that all
 * solutions are proved to reach. The callback is called in integrations, with 0. */
int libration_problem_enclosures(const libration_problem *problem, const char *times, long most_parts, long digits,
                                 libration_watch watch, void *context, libration_table **bounds);
/* The same for the first `count` events of all solutions, libration_problem_events, where the condition may contain the
 * parameters that are intervals: event, quantity, lower, upper, a row for "time" and for each unknown. UNDECIDED also gives
 * a table, of the first ones, if not all solutions are proved to have as many. */
int libration_problem_enclosed_events(const libration_problem *problem, const char *condition, long count,
                                      long most_parts, long digits, libration_watch watch, void *context,
                                      libration_table **bounds);
/* The first `count` times after the initial point at which a condition on the unknowns holds, "x' = 1/2": time and one
 * column for each name, proved, without omissions. UNDECIDED also gives a table, of the first ones, if there are not as
 * many within 5000 steps each or before the solution ends, and if a number of one is not distinguished from 0: it is then
 * 0 as in libration_problem_known_states. */
int libration_problem_events(const libration_problem *problem, const char *condition, long count, long digits,
                             libration_table **events);
/* The states at times that are fractions, proved, and in the file `path` a certificate, from which the program
 * check/libration_check.py proves them again in integers; and the same for the first `count` events. UNDECIDED without a
 * file if a value or an event is missing, or not proved by the steps of a certificate; ARGUMENT if the format does not
 * contain the problem. The callback is called in proofs, also of the certificate, where the part begins at 0 again. */
int libration_problem_certificate(const libration_problem *problem, const char *times, long digits, const char *path,
                                  libration_watch watch, void *context, libration_table **states);
int libration_problem_event_certificate(const libration_problem *problem, const char *condition, long count,
                                        long digits, const char *path, libration_watch watch, void *context,
                                        libration_table **events);
/* The parameters or initial values `unknowns`, "k, f''(0)", for which as many conditions hold, "f'(5) = 1; f(5) = 2",
 * near the values that the problem has, proved: name, value. Conditions at infinity, "f'(inf) = 1",
 * are decided by the stable manifold, as in libration_find_at_infinity. The callback is called in integrations, with 0, since
 * the number of these is not known before; not in a proof by a lemma. */
int libration_problem_find(const libration_problem *problem, const char *unknowns, const char *conditions, long digits,
                           libration_watch watch, void *context, libration_table **values);
/* The same for conditions "f'(5) = 1" at one time that is a fraction, and in the file `path` a certificate, from which
 * check/libration_check.py proves that the conditions hold for exactly one choice of numbers within one unit of the last
 * digit of each. UNDECIDED without a file if that is not proved by the steps of a certificate; ARGUMENT if the format does
 * not contain the problem or a condition. */
int libration_problem_find_certificate(const libration_problem *problem, const char *unknowns, const char *conditions,
                                       long digits, const char *path, libration_watch watch, void *context,
                                       libration_table **values);
/* The branch of solutions of the conditions in another parameter `along`, "k = 0:3.5:36", FIRST:LAST:COUNT or a list in
 * one direction, from its first value and the first guess of the problem on, past turning points: in the order of the
 * branch a row for each passage of one of the values and for each turning point, proved to exist: point ("solution" or
 * "turning point"), the parameter, the unknowns, and note, in the last row where and why the branch ends. UNDECIDED also
 * gives a table, of the proved points, if others are not, or if the branch could not be continued; a number that is not
 * distinguished from 0 is then 0 as in libration_problem_known_states. The callback is called in integrations, with 0. */
int libration_problem_branch(const libration_problem *problem, const char *unknowns, const char *conditions,
                             const char *along, long digits, libration_watch watch, void *context,
                             libration_table **points);
/* The periodic orbit near the initial values of an autonomous problem, proved: name, value of the unknowns and their
 * lower derivatives on a section, and of the period. The callback is called in integrations, with 0. */
int libration_problem_orbit(const libration_problem *problem, long digits, libration_watch watch, void *context,
                            libration_table **orbit);
/* The same, and in the file `path` a certificate, from which check/libration_check.py proves that the solution returns to
 * its initial point for exactly one choice of the period and of the values on the section, within one unit of the last
 * digit of each. UNDECIDED and ARGUMENT as for libration_problem_find_certificate. */
int libration_problem_orbit_certificate(const libration_problem *problem, long digits, const char *path,
                                        libration_watch watch, void *context, libration_table **orbit);
void libration_problem_free(libration_problem *problem);

/* ---- Solutions with limits at infinity. ---- */

/* The numbers that conditions at infinity in the text determine, "f''' + f*f'' = 0; f(0)=0; f'(0)=0; f'(inf)=1", or "u(-inf) = 1; u(inf) = 0"
 * for an orbit between two equilibria, each digit proved: name, value, kind. `unknowns`, "c = 0.3, f''(0)", have first guesses or none; NULL
 * are the parameters and initial values without a value. The kind of their rows is "unknown"; rows after them are of the kinds "limit", a free one,
 * H(inf), "rate" of decay, rate 1, rate 1 at -inf, "amplitude", amplitude of y, and "angle" of intersection, as far as they are proved. UNDECIDED
 * if no solution is found or proved. The callback is called in integrations, with 0. */
int libration_find_at_infinity(const char *text, const char *unknowns, long digits, libration_watch watch,
                               void *context, libration_table **values);
/* The same solution at times, "0, 1/2, inf", proved: time, then the unknowns and their lower derivatives. UNDECIDED with the table if a
 * value is missing in it. */
int libration_states_at_infinity(const char *text, const char *unknowns, const char *times, long digits,
                                 libration_watch watch, void *context, libration_table **states);
/* The first `count` eigenvalues of psi'' = (V(x) - E)*psi with a condition at each end in the text, "psi'' = (x^4 - E)*psi; psi(-inf) = 0;
 * psi(inf) = 0", proved to be the first ones: name, E_0, E_1, .., value. UNDECIDED if there are fewer. */
int libration_eigenvalues(const char *text, const char *energy, long count, long digits, libration_watch watch,
                          void *context, libration_table **values);

/* ---- One solution of a problem, for several questions. ---- */

/* The solution keeps the steps of its proved integrations, as far as they fit into 64 MiB in each direction of time. A
 * question is answered from them as far as they lead, if it has no more digits than those before; then they are continued.
 * For equations with events, piecewise right-hand sides or delays, and for closed forms, no steps are kept: the answers are
 * the same. The problem may be freed. */
int libration_solution_new(const libration_problem *problem, libration_solution **solution);
/* As libration_problem_known_states, libration_problem_events and libration_problem_coefficients; of coefficients those
 * PROVED about a time are read from the steps. The settings of events, or NULL: "crossing = up", only where the difference
 * of the two sides increases with time, or down; "before = 10", only events before or at this time, which may be before the
 * initial one; "from_start = yes", the initial time as well if the condition holds there; "horizon = 100", the largest
 * number of steps without an event. A callback must not use the same solution. */
int libration_solution_states(libration_solution *solution, const char *times, long digits, int rigour,
                              libration_watch watch, void *context, libration_table **states);
int libration_solution_events(libration_solution *solution, const char *condition, const char *settings, long count,
                              long digits, libration_watch watch, void *context, libration_table **events);
int libration_solution_coefficients(libration_solution *solution, const char *point, const char *corners, long first,
                                    long last, long digits, int rigour, libration_table **coefficients);
/* As libration_problem_certificate and libration_problem_event_certificate: the values are read from the steps; the
 * certificate has other steps. */
int libration_solution_certificate(libration_solution *solution, const char *times, long digits, const char *path,
                                   libration_watch watch, void *context, libration_table **states);
int libration_solution_event_certificate(libration_solution *solution, const char *condition, long count, long digits,
                                         const char *path, libration_watch watch, void *context,
                                         libration_table **events);
/* The number of steps that have been made for all questions up to now; a question that is answered from kept steps adds
 * none. */
size_t libration_solution_steps(const libration_solution *solution);
void libration_solution_free(libration_solution *solution);

/* ---- The law of all Taylor coefficients of a solution. ---- */

/* Proves the law of the coefficients a_n of (t - t0)^n of an unknown or a derivative, "y" or "th'", NULL for the first unknown: all
 * singularities in |t - t0| <= RHO and what each contributes to every a_n with n >= first, and a bound of the rest. `within` is RHO, NULL for one between the
 * nearest singularities. UNDECIDED with the reason if no law is proved. The callback is called in the proof, with 0. The problem may be freed. */
int libration_law_new(const libration_problem *problem, const char *show, const char *within, libration_watch watch,
                      void *context, libration_law **law);
/* RHO, n0 = first, and the stride p: a_n = 0 by symmetry unless n = residue mod p. 0 for NULL. */
double libration_law_rho(const libration_law *law);
long libration_law_first(const libration_law *law);
long libration_law_stride(const libration_law *law);
long libration_law_residue(const libration_law *law);
/* A row for each singularity, proved: position_re, position_im, modulus, kind, exponent, coefficient_re, coefficient_im; the
 * coefficient is that of (t - t*)^exponent or log(t - t*), at branch points and singular points of linear equations of x^exponent log(x)^m, x = 1 - (t - t0)/(t* - t0). A
 * number that is not distinguished from 0 is 0 as in libration_problem_known_states. */
int libration_law_singularities(const libration_law *law, long digits, libration_table **singularities);
/* a_n, and a_n/a_(n-p), proved, without the ones before: by the law where it gives the digits, else by the recurrence up to n = 20000.
 * UNDECIDED if neither does; ARGUMENT for the ratio of coefficients that are 0 by symmetry, and for n < p. */
int libration_law_coefficient(const libration_law *law, long n, long digits, libration_number **coefficient);
int libration_law_ratio(const libration_law *law, long n, long digits, libration_number **ratio);
/* The law as a formula, its error and what is proved: name (law, error, proved) and text. */
int libration_law_words(const libration_law *law, libration_table **words);
void libration_law_free(libration_law *law);

/* Solutions in double precision by Taylor series, an error of some units in the last place of max(1, largest |value|) per
 * step, amplified by the equations; nothing is proved. `starts` has the state at time `begin`, in the order of the names,
 * of `solutions` solutions, row by row; NULL, with 1 solution, is the initial point of the problem itself. `values` gets
 * solutions x times x names numbers; nan at times that are not reached since the steps become too small, near a
 * singularity. ARGUMENT for nan and infinities, for starts at a singular initial point, and for starts of a problem with
 * events or delays. Four or more solutions run in lock step in the lanes of SIMD vectors, with the same values; this thread
 * alone is used, and several can share a problem. The callback is called after each solution, or some of them. */
int libration_problem_flow(const libration_problem *problem, double begin, size_t solutions, const double starts[],
                           size_t count, const double times[], libration_watch watch, void *context, double values[]);
/* The same with a row of `numbers` for each solution, the values of the parameters and initial values `names`, "r, x(0)".
 * `starts` NULL is the state at the initial point of the problem, which depends on them, and `begin` is not used then.
 * ARGUMENT also for other names, for numbers that the equations require to be constant, such as an exponent, and for a
 * singular initial point. */
int libration_problem_varied_flow(const libration_problem *problem, const char *names, const double numbers[],
                                  double begin, size_t solutions, const double *starts, size_t count,
                                  const double times[], libration_watch watch, void *context, double values[]);
/* The initial time of a problem and the state there, the doubles next to them. */
int libration_problem_start(const libration_problem *problem, double *time, double values[]);
/* The steps of one such solution from `begin` to `end`, which may be earlier: dense output. */
int libration_steps_new(const libration_problem *problem, double begin, const double start[], double end,
                        libration_steps **steps);
size_t libration_steps_count(const libration_steps *steps);
/* The degree N of the polynomials. */
size_t libration_steps_order(const libration_steps *steps);
/* The points between the steps, count + 1; the last one is `end` unless the steps become too small before. */
const double *libration_steps_times(const libration_steps *steps);
/* The coefficients of every step, count x names x (N + 1): those of powers 0 .. N of t minus the point at which the step
 * begins. */
const double *libration_steps_coefficients(const libration_steps *steps);
void libration_steps_free(libration_steps *steps);

/* The catalogue of problems: names and texts, numbered from 0; empty if out of range. */
size_t libration_catalogue_size(void);
const char *libration_catalogue_name(size_t i);
const char *libration_catalogue_text(size_t i);

/* ---- Any list of coefficients, "1, 0.5, 1/3, ...": as libration_problem_radius. ---- */
int libration_list_radius(const char *coefficients, long digits, libration_table **tests);

/* ---- Values computed elsewhere, compared with proved ones. ---- */

/* `names` are the columns of `values`, "theta", "theta,omega" or some of the names of a problem; `values` a list row by
 * row, one row per time, decimals or hexadecimal floats as written, also nan and inf. `rules` are "tolerance = 1e-12",
 * "relative = 1e-9", "ulp = 4" (units in the last place of a double of max(1, |true value|)), "rounding = half" (half a
 * unit of the last digit as written), "modulo = 2pi" for theta, separated by ;, or NULL: one unit of the last digit as
 * written, for values that are all doubles in decimal, as "%.18e" prints them, half a unit in their last place; times
 * that are all doubles in decimal are these doubles. A table: time, verdict (ok, miss), condition, and for each name
 * NAME_reference (proved), NAME_error, NAME_correct_digits. */
int libration_motion_verify(const libration_motion *motion, const char *names, const char *times, const char *values,
                            const char *rules, libration_watch watch, void *context, libration_table **compared);
int libration_problem_verify(const libration_problem *problem, const char *names, const char *times, const char *values,
                             const char *rules, libration_watch watch, void *context, libration_table **compared);
/* The same for doubles, which are taken as exact: `rows` times, and rows x names values. */
int libration_motion_verify_doubles(const libration_motion *motion, const char *names, size_t rows, const double times[],
                                    const double values[], const char *rules, libration_watch watch, void *context,
                                    libration_table **compared);
int libration_problem_verify_doubles(const libration_problem *problem, const char *names, size_t rows,
                                     const double times[], const double values[], const char *rules,
                                     libration_watch watch, void *context, libration_table **compared);

/* ---- theta and omega at many times in double precision, a few nanoseconds each, within 4 units in the last place of
 *      max(1, |theta|) and of the largest |omega|. ---- */

int libration_sampler_new(const libration_motion *motion, libration_sampler **sampler);
/* Arrays of `count`; they may be the same memory. Their contents after an error are unspecified. */
int libration_sampler_at(const libration_sampler *sampler, size_t count, const double times[], double theta[],
                         double omega[]);
void libration_sampler_free(libration_sampler *sampler);

#ifdef __cplusplus
}
#endif

#endif
