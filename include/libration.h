/* The C interface of Libration: exact motions of the pendulum and any differential equations, in proved digits.
 *
 * Texts. Every number goes in as text and is exact as it is written: 1.71, 171/100, 1e-30, 3pi/4, 150deg, 2-1e-10,
 * sqrt(2), a time also as T/4, an exact binary number as 6004799503160661*2^-53 (libration_exact_text). Texts are
 * UTF-8 and end in 0; lists have commas; where a text may be NULL it may be empty as well. Texts that come back belong to
 * the object that was asked and live as long.
 *
 * Numbers come out as handles: a decimal, a bound of what it misses, and what stands behind that. D digits are D
 * significant ones, each right to one unit in the last. Nothing is computed in double but by the sampler.
 *
 * Errors. A function that can fail returns a code, LIBRATION_OK = 0, and writes to its last arguments only then
 * (libration_problem_known_states excepted). What was wrong is kept for each thread until its next call that fails:
 * libration_error_message(). No exception leaves a function. Memory that C++, GMP or FLINT do not get, and FLINT's own aborts (flint_throw, flint_abort), become codes;
 * nothing is computed again in the thread in which that happened, and nothing is unwound through FLINT, so what the call
 * held is not freed. A question whose memory is known before is refused at its beginning. Not promised: what the system
 * does beyond malloc (the OOM killer, a full stack), and pthread_cancel during a call.
 *
 * Threads. Precision is an argument; no state is shared. Any number of threads may call, also with the same motion,
 * problem, sampler, table or number, which no call changes; freeing is the caller's affair. Each of them has another
 * thread in which its calls are computed while it waits, from its first call until it ends, with signals blocked and
 * floating point in its usual mode; MPFR's settings and flags of the calling thread are neither read nor changed. Only
 * the sampler computes in the calling thread. A child process may call after fork().
 */
#ifndef LIBRATION_H
#define LIBRATION_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Codes. */
enum {
    LIBRATION_OK = 0,
    LIBRATION_ARGUMENT = 1,  /* malformed, NULL, or outside the domain: give another value */
    LIBRATION_RANGE = 2,     /* beyond the range of the type that was asked for, or a buffer too small */
    LIBRATION_UNDECIDED = 3, /* no precision within the limits decides: nothing is wrong with the value */
    LIBRATION_CANCELLED = 4, /* the watch said so */
    LIBRATION_NO_MEMORY = 5, /* or less than the question needs, as the message says: ask for less */
    LIBRATION_FAULT = 6 /* a mistake of the library, or of one under it */
};

/* What stands behind a number, and what is asked for: PROVED by ball arithmetic; ROUNDED by runs in MPFR that agree, or
 * a bound of the error known before. */
enum { LIBRATION_HEURISTIC = 0, LIBRATION_ROUNDED = 1, LIBRATION_PROVED = 2 };

typedef struct libration_number libration_number;
typedef struct libration_table libration_table;
typedef struct libration_motion libration_motion;
typedef struct libration_problem libration_problem;
typedef struct libration_sampler libration_sampler;

/* Told now and then how much is done, 0 .. 1, in the thread of the call; anything but 0 cancels it. May be NULL. */
typedef int (*libration_watch)(double part, void *context);

/* The version of the library, such as 1.0.0. The interface itself only ever grows; the number of its library is 1. */
const char *libration_version(void);

/* The last error of this thread, empty texts before the first: "energy '-1' is negative", and its parts: the quantity,
 * its value, what is wrong with it. They live until the next error of the thread. */
const char *libration_error_message(void);
const char *libration_error_subject(void);
const char *libration_error_value(void);
const char *libration_error_reason(void);

/* ---- Numbers: free those that a function gave you, not those of a table. ---- */

/* The number that a text stands for, to proved digits. */
int libration_number_read(const char *text, long digits, libration_number **number);
/* A number as it was written down before, a file say: its digits, the bound of what they miss and its rigour, which are
 * believed. */
int libration_number_of(const char *decimal, const char *uncertainty, int rigour, libration_number **number);
/* mantissa * 2^exponent as a text that every function here reads exactly; the mantissa a decimal integer. RANGE where
 * `size` characters, the last one 0, do not hold it: the mantissa and 32 more are enough. */
int libration_exact_text(const char *mantissa, long exponent, char *text, size_t size);

/* The digits: -1.2897755603, 1.5e-30, inf; 0 is exactly 0; of fractions p/q. */
const char *libration_number_decimal(const libration_number *number);
/* A bound of |decimal - exact number|, three digits; of heuristic ones an estimate, empty where there is none. */
const char *libration_number_uncertainty(const libration_number *number);
/* LIBRATION_PROVED, LIBRATION_ROUNDED or LIBRATION_HEURISTIC. */
int libration_number_rigour(const libration_number *number);
/* The double nearest to the exact number; UNDECIDED where the digits do not tell which one that is. */
int libration_number_double(const libration_number *number, double *nearest);
/* Doubles below and above, as near as the digits allow. */
int libration_number_bounds(const libration_number *number, double *lower, double *upper);
/* |exact number - mantissa 2^exponent| <= radius 2^radius_exponent; the mantissa as a decimal integer. RANGE for
 * infinity, and where `size` is below libration_number_mantissa_size(). */
int libration_number_exact(const libration_number *number, char *mantissa, size_t size, long *exponent,
                           unsigned long *radius, long *radius_exponent);
size_t libration_number_mantissa_size(const libration_number *number);
void libration_number_free(libration_number *number);

/* ---- Tables: rows and named columns. A cell is a number, words, or empty. ---- */

size_t libration_table_rows(const libration_table *table);
size_t libration_table_columns(const libration_table *table);
/* Rows and columns count from 0; beyond them a text is empty and a number NULL. */
const char *libration_table_name(const libration_table *table, size_t column);
const char *libration_table_text(const libration_table *table, size_t row, size_t column);
/* NULL for words. It lives as long as the table. */
const libration_number *libration_table_number(const libration_table *table, size_t row, size_t column);
void libration_table_free(libration_table *table);

/* ---- Motions of theta'' + sin theta = 0. Times in sqrt(length/gravity), energies in units of m g length; with a
 *      length and a gravity in seconds and rad/s. ---- */

/* "theta0 = 150deg; omega0 = 0", "energy = 1.71; direction = -", "gap = 1e-30": an energy, or the gap 2 - E, from the
 * canonical start (the top, at E = 2 the bottom) or from a theta0; or theta0 and omega0. Also length and gravity. */
int libration_motion_new(const char *given, libration_motion **motion);
/* libration, rotation, separatrix, stable-equilibrium or unstable-equilibrium. */
const char *libration_motion_regime(const libration_motion *motion);
/* theta, not reduced to one turn, and omega at a time. */
int libration_motion_theta(const libration_motion *motion, const char *time, long digits, int rigour,
                           libration_number **theta);
int libration_motion_omega(const libration_motion *motion, const char *time, long digits, int rigour,
                           libration_number **omega);
/* Both at a list of times, "0,1.5,T/4": time as typed, theta, omega. */
int libration_motion_states(const libration_motion *motion, const char *times, long digits, int rigour,
                            libration_watch watch, void *context, libration_table **states);
/* T, of a rotation the time of one turn, and T* from the top to the bottom; inf at E = 2. */
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
 * parameters or starts to be changed, "r = 28; x(0) = 1/2", or NULL. */
int libration_problem_new(const char *text, const char *settings, libration_problem **problem);
/* The unknowns and their lower derivatives, x, x', in the order of the columns of states. */
size_t libration_problem_size(const libration_problem *problem);
const char *libration_problem_name(const libration_problem *problem, size_t i);
/* Their values at a list of times: time as typed, and a column each. PROVED is refused for singular starts whose right
 * sides are no polynomials; a time that is not reached is UNDECIDED, and the message says up to where the solution is
 * proved to exist. The watch is heard in proofs. */
int libration_problem_states(const libration_problem *problem, const char *times, long digits, int rigour,
                             libration_watch watch, void *context, libration_table **states);
/* The same, and on UNDECIDED too a table, which must be freed: with PROVED a row for each time, in it what is proved, a
 * value that is not distinguished from 0 as 0 with the bound of its size as uncertainty (only "0" is exactly 0), and an
 * empty cell, whose number is NULL, where the equations of the unknown are not proved to reach the time. The message is
 * the first reason why something is missing. NULL on every other error. */
int libration_problem_known_states(const libration_problem *problem, const char *times, long digits, int rigour,
                                   libration_watch watch, void *context, libration_table **states);
/* Coefficients first .. last of every unknown about a point, NULL for the start, else a time, also complex, 1+2i, by
 * way of corners in the complex plane, "1+i,2+i", or NULL: n and a column each; about a complex point x_re and x_im,
 * ROUNDED alone; in powers of t^(1/q) a column power behind. */
int libration_problem_coefficients(const libration_problem *problem, const char *point, const char *corners, long first,
                                   long last, long digits, int rigour, libration_table **coefficients);
/* The same about the start as exact fractions p/q; ARGUMENT where they are none. */
int libration_problem_fractions(const libration_problem *problem, long first, long last,
                                libration_table **coefficients);
/* The radius of convergence about the start from coefficients 0 .. last, heuristic: rows of tests, the first one the
 * verdict of the nearest unknown; method, unknown, radius (with its uncertainty), position_re, position_im, exponent,
 * kind, count, note. */
int libration_problem_radius(const libration_problem *problem, long last, long digits, libration_table **tests);
/* Proved bounds lower <= R <= upper, upper - lower < lower 10^-digits; both inf for a linear equation with entire
 * coefficients. */
int libration_problem_radius_bounds(const libration_problem *problem, long digits, libration_number **lower,
                                    libration_number **upper);
/* The singularities within a distance of the start in the complex plane of time, NULL for twice that of the nearest, of
 * the branch that is reached straight: position_re, position_im, modulus, kind, exponent_re, exponent_im, unknown.
 * PROVED places have a singularity within their uncertainty; kinds and exponents are always heuristic. HEURISTIC or
 * PROVED; `complete`, which may be NULL, is 1 where the whole disc was searched, 0 where some of it stayed open. */
int libration_problem_singularities(const libration_problem *problem, const char *within, long digits, int rigour,
                                    libration_table **singularities, int *complete);
void libration_problem_free(libration_problem *problem);

/* The catalogue of problems: names and texts, by number from 0; empty beyond. */
size_t libration_catalogue_size(void);
const char *libration_catalogue_name(size_t i);
const char *libration_catalogue_text(size_t i);

/* ---- A list of coefficients of one's own, "1, 0.5, 1/3, ...": as libration_problem_radius. ---- */
int libration_list_radius(const char *coefficients, long digits, libration_table **tests);

/* ---- Values that somebody computed, compared with proved ones. ---- */

/* `names` are the columns of `values`, "theta", "theta,omega" or some of the names of a problem; `values` a list row by
 * row, one row a time, decimals or hexadecimal floats as written, nan and inf too. `rules` are "tolerance = 1e-12",
 * "relative = 1e-9", "ulp = 4" (units in the last place of a double of max(1, |truth|)), "modulo = 2pi" for theta,
 * separated by ;, or NULL: one unit of the last digit as written. A table: time, verdict (ok, miss), condition, and for
 * each name NAME_reference (proved), NAME_error, NAME_correct_digits. */
int libration_motion_verify(const libration_motion *motion, const char *names, const char *times, const char *values,
                            const char *rules, libration_watch watch, void *context, libration_table **compared);
int libration_problem_verify(const libration_problem *problem, const char *names, const char *times, const char *values,
                             const char *rules, libration_watch watch, void *context, libration_table **compared);
/* The same of doubles, which count as exact: `rows` times, and rows times names values. */
int libration_motion_verify_doubles(const libration_motion *motion, const char *names, size_t rows, const double *times,
                                    const double *values, const char *rules, libration_watch watch, void *context,
                                    libration_table **compared);
int libration_problem_verify_doubles(const libration_problem *problem, const char *names, size_t rows,
                                     const double *times, const double *values, const char *rules,
                                     libration_watch watch, void *context, libration_table **compared);

/* ---- theta and omega at many times in double, a few nanoseconds each, within 4 units in the last place of
 *      max(1, |theta|) and of the largest |omega|. ---- */

int libration_sampler_new(const libration_motion *motion, libration_sampler **sampler);
/* Arrays of `count`; they may be the same memory. What they hold after an error is unspecified. */
int libration_sampler_at(const libration_sampler *sampler, size_t count, const double *times, double *theta,
                         double *omega);
void libration_sampler_free(libration_sampler *sampler);

#ifdef __cplusplus
}
#endif

#endif
