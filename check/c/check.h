// libration_check FILE: proves the statement of a certificate, or rejects it, as the program
// check/libration_check.py does. The format and the theorems are in docs/certificates.md. Integers
// and fractions only: exact, or rounded to the safe side. Exit status: 0 if the statement is
// proved, 1 if a condition of a theorem does not hold, 2 if the file is not a certificate of this
// format.
//
//     gcc -O2 check/c/*.c -lgmp -lz -o libration_check
//
// reason.c     why nothing is proved           memory.c      regions in which numbers are
// number.c     fractions, and their rounding   list.c        polynomials on a step
// formula.c    trees of formulas               polynomial.c  polynomials in the unknowns
// enclosure.c  intervals of initial values     reader.c      lines of a certificate
// problem.c    head of a certificate           form.c        polynomial form of the equations
// step.c       numbers of a step               joint.c       where the step begins
// field.c      equations along the tube        growth.c      theorem K
// progress.c   claims and zeros                chain.c       from the first step to the last one
// statement.c  what is printed                 root.c        Newton's method
// main.c       the file
#ifndef LIBRATION_CHECK_H
#define LIBRATION_CHECK_H

#include <gmp.h>
#include <stddef.h>

/* Limits. Each is checked before the work that it bounds. Both checkers have the same. */
enum {
    MOST_TEXT = 1 << 28,       // characters of a certificate
    MOST_DIGITS = 4000,        // decimal digits of an integer
    MOST_FORMULA = 100000,     // characters of a formula
    MOST_NESTING = 150,        // signs, exponents and parentheses in one another
    MOST_NUMBER = 1 << 17,     // bits of numerators and denominators computed from formulas
    MOST_POWER = 100,          // whole powers in equations, conditions and definitions
    MOST_START_POWER = 10000,  // whole powers in enclosures of initial values
    MOST_ARGUMENT = 1000,      // of exp, sin and cos in enclosures of initial values
    MOST_OPERATIONS = 20,      // of a start; and powers and functions of all starts together
    MOST_PRODUCTS = 1000000,   // products of two terms, in the polynomials of a certificate
    MOST_FACTORS = 400,        // of a term
    MOST_UNKNOWNS = 200,       // with derivatives and added unknowns
    MOST_DEFINITIONS = 100,    //
    MOST_CLAIMS = 10000,       //
    MOST_ZEROS = 10000,        //
    MOST_ENDS = 2000000,       // characters and exponents of all claims, or of all zeros
    MOST_BITS = 10000,         // of bounds and of enclosures
    MOST_INTEGER = 99999,      // of lines with integers
    MOST_EXPONENT = 20000,     // of polynomials, radii and lengths
    MOST_SHIFT = 1 << 18,      // bits by which the scales of unknowns shift a term
    MOST_COMMON = 1 << 20,     // bits of the common denominator of the equations on a step
    MOST_PARTS = 2000          // of a step, for the sign of a condition
};
static const long MOST_STEP = 1L << 34;  // bits of the products of polynomials on a step

/* reason.c */
extern long step_number;                            // of the step that is checked, or 0
void need(int condition, const char* reason, ...);  // of a condition of a theorem
void form(int condition, const char* reason, ...);  // of the format
const char* clipped(const char* text);  // at most 60 characters of a text, for reasons

/* memory.c: a number belongs to the region of the problem, of one of two steps, or of a
   sign. */
enum {
    PROBLEM,
    STEP,
    SIGN = 3,
    REGIONS
};
extern int region;
void* take(size_t size);
void* resize(void* p, size_t old, size_t size);
void release(int which);
void begin_memory(void);

/* number.c: fractions. */
typedef mpq_ptr Q;
extern long bits;  // bounds are multiples of 2^-bits
Q q(long n);
Q q_of(mpz_srcptr n);
Q plus(Q a, Q b);
Q minus(Q a, Q b);
Q times(Q a, Q b);
Q over(Q a, Q b);
Q negative(Q a);
Q absolute(Q a);
int at_most(Q a, Q b);
Q least(Q a, Q b);
Q largest(Q a, Q b);
Q shift(Q a, long k);  // 2^k a
Q whole(Q a);          // rounded down
Q ceiling(Q a);
Q up(Q a);       // to a multiple of 2^-bits
Q root_up(Q a);  // of a sum of squares of bounds
Q power(Q a, unsigned long n);
long size_in_bits(Q a);  // of the larger one of numerator and denominator
Q limited(Q a);          // rejects what is too large
Q fraction(const char* text);
Q integer_of(const char* digits, size_t length);

/* list.c: a polynomial in x on [-1, 1] is a list a of integers, with an exponent k that is
   kept apart. With x = (z + 1/z)/2 and the Chebyshev polynomials T_j = (z^j + z^-j)/2 it is
       2^-k (a[0] + sum over j > 0 of 2 a[j] T_j(x)) = 2^-k (sum over all j of a[|j|] z^j).
   So products are products of polynomials in z, and, because |T_j| <= 1 on [-1, 1], the sum
   of all |a[|j|]|, j positive and negative, is at least |a(x)|. */
typedef struct {
    long n;
    mpz_ptr c;
} List;
extern const List nothing;
List list(long n);
Q norm(List a);  // at least |a(x)| on [-1, 1]
Q value(List a, Q x);
List derivative(List a);
List add(List a, List b, Q factor);  // a + factor b, with an integer
List scaled(List a, Q factor);
List dot(const List* u, long du, const List* v, long dv,
         long n);  // the sum of u[i du] v[i dv], i < n

/* formula.c
       sum     = product { (+|-) product }
       product = signed { (*|/) signed }
       signed  = - signed  |  atom [ ^ signed ]
       atom    = integer  |  name  |  name ( sum )  |  ( sum ) */
typedef struct Tree {
    char kind;  // '0' number, 'x' name, 'f' function, '^' power, '+' sum, '*' product
    const char* name;
    Q number;    // also the exponent of a power
    long parts;  // one for functions and powers
    struct Tree** part;
    char* sign;  // of each part of a sum, + or -, or of a product, * or /
} Tree;
typedef struct {
    Tree* tree;
    long operations, functions;  // of + - * / ^ and calls; of ^ and calls
} Formula;
Formula parsed(const char* text);
size_t name_length(const char* s);  // of the name that s begins with, with its primes
int is_function(const char* name);
int is_reserved(const char* name);

/* polynomial.c: polynomials in the variable (number 0) and the unknowns (1, 2, ..), as sums
   of different products v[0] <= v[1] <= .. in their order, with coefficients that are
   nonzero. */
typedef struct {
    long n;
    int* v;
    Q c;
    long place;  // among terms that are added
} Term;
typedef struct {
    long n;
    Term* t;
} Poly;
typedef struct {
    Q low, high;
} Interval;
typedef struct {
    const char* name;
    Poly own;
    Interval start;
} Name;
typedef struct {  // an added unknown, which represents a quotient, a power or a function of u
    const char* kind;
    Q exponent;
    Poly u, own;
} Added;
typedef struct {  // the products of two terms are counted
    long products, count;
    Added* added;
} Algebra;
typedef struct {
    Name* name;
    long count;
} Names;
const Name* find_name(Names names, const char* name);
Poly constant(Q c);
Poly unknown(int k);
Poly nothing_at_all(void);
Poly collected(Poly p);
Poly joined(const Poly* p, const Q* factor, long n);  // the sum of factor[i] p[i]
Poly poly_times(Algebra* by, Poly a, Poly b);
Poly poly_power(Algebra* by, Poly u, long n);
Poly function_of(const Algebra* by, const char* kind, Poly u, Q exponent);
Poly inverse_of(const Algebra* by, Poly u);
Poly polynomial(Algebra* by, const Tree* t, Names names);
Poly along(Algebra* by, Poly u, const Poly* way,
           long n);             // the chain rule, from the derivatives of 0 .. n - 1
Term without(Term t, long at);  // one of its factors

/* enclosure.c: values of formulas to about so many bits behind the point. */
Interval enclosure(const Tree* t, Names names, long precision);
Interval pi_interval(long precision);
Interval linear(Q a, Interval x, Q b, Interval y);  // a x + b y
Interval exactly(Q a);

/* reader.c */
typedef char* Row[4];
typedef struct {
    char** line;
    long count, at;
} Reader;
Reader reader_of(char* text);
char* line(Reader* r, const char* word);  // what follows the word of the next line
char** all(Reader* r, const char* word, long most,
           long* count);  // the same of all lines that begin with it
long split(char* s, const char* separator, char** part, long most);
char* copied(const char* s, size_t length);
long* integers(Reader* r, const char* word, long count, long largest);
List* section(Reader* r, const char* word, long exponents, long** k, long lists);

/* problem.c */
typedef struct {
    Row field;
    long place;  // of the unknown
    Q first, last, low, high;
} Claim;
typedef struct {
    char *left, *right, *name;
    long order;
} Equation;
typedef struct {
    char *variable, *t0_text, *condition, *vary;
    char **start, **definition, **note;
    Equation* equation;
    Row* zero;
    Claim* claim;
    long equations, own, given, defined,
        n;  // own: unknowns of equations; given: with derivatives; n: all
    long notes, zeros, claims, steps, bits, start_bits, functions;
    Q t0, *ends;     // t0, and both times of each zero
    Names names;     // of the variable, and the unknowns in their order
    Poly* right;     // y_i' = right[i], i = 1 .. n, right[0] = 1; and g, g' behind them
    int zero_start;  // g is 0 at the initial time
} Problem;
Problem* read_problem(Reader* r);
long zero_of(const Problem* p, const char* time);  // the number of the zero #k, or 0

/* form.c */
void make_polynomial_form(Problem* p);

/* step.c */
typedef struct
{  // the states centre + frame c, |c_b| <= radii_b in the blocks b of columns at[b] .. at[b+1] - 1
    long n, blocks, *at;
    Q *centre, *frame, *radii;
} Set;
typedef struct
{  // polynomials of the scaled unknowns and their frame, brought to one exponent each
    Problem* problem;
    Q begin, length;
    long n, blocks, *at, *scale, kp, kv, ku;
    List *p, *V, *U;
    Q *R0, *R1, *N1;  // |V^-1| <= N1 |U|
    struct
    {  // g and g' along p in integers, a bound of the slope, and of the change in the tube
        List a;
        Q slope, reach;
    } function[2];
} Step;
Step* read_step(Reader* r, Problem* p, Q begin);
Set set_at(const Step* s, Q x);
Q radius_at(const Step* s, long b, Q x);
Q* fractions(long n);
Q size_of(Q* a, long width, long i0, long i1, long j0,
          long j1);  // at least the norm of a block
Q row_times(Q* row, const long* at, long blocks,
            Q* radii);                          // the sum of norms of blocks of a row
Q* products(Q* a, Q* b, long n, long columns);  // of bounds; n rows, n columns of a
Q bound(List a, long k);                        // of |2^-k a(x)|
Q* bounds(const List* a, long count, Q unit);   // of |a(x)/unit|

/* joint.c */
void check_frame(Step* s);  // sets N1
void check_joint(const Step* s, const Set* old);

/* field.c */
typedef struct {
    long n;
    List* J;                                    // g_Y in integers, times 1/unit
    Q *change_of_J, *size_of_V, *defect, unit;  // bounds; of V^-1 (p' - g)
} Field;
Field field(Step* s);

/* growth.c */
void check_growth(const Step* s, const Field* f);

/* progress.c */
typedef struct
{  // the first claims, and the first intervals before, in and behind zeros, are proved
    long claims, interval;
    int sign;
} Progress;
void check_progress(Progress* done, const Step* s);
int is_complete(const Progress* done, const Problem* p);

/* chain.c */
Problem* check_one(char* text);

/* statement.c */
void print_head(const Problem* p, char** times, long count);
void print_notes(const Problem* p);  // of the file for its reader, which are not checked
void print_statement(const Problem* p);

/* root.c */
void check_root(Problem** problem, long problems, char* rest);

#endif
