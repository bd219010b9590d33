// Reference values of the elliptic functions K.
// Made by: libration table K --m1 1e-30,1e-20,1e-10,1e-6,1e-3,0.01,0.1,0.19,0.36,0.5,0.64,0.75,0.9,0.99,0.999999 --digits 50 --format cpp --name libration_complete_integral
// 50 significant digits, proved to one unit in the last place.
// Typed numbers that no decimal holds, such as T/8 or pi/3, stand with 60 digits.
// Made with: libration 1.0.0, commit 702817ab41, compiler GNU 12.2.0, Boost 1.81.0, MPFR 4.2.0, MPFR thread-safe yes, GMP 6.2.1, quad __float128 (libquadmath), ball arithmetic FLINT 2.9.0, Arb 2.23.0, vectors AVX3
// Columns:
//     m1
//     K
//     condition_K: (|u df/du| + |x df/dx|)/|f|, x = m1, heuristic, three digits
#pragma once

#include <array>

/// A row; every number is the text of its decimal, so that any type can be read from it.
struct libration_complete_integral_row {
    const char* m1;
    const char* K;
    const char* condition_K;  ///< (|u df/du| + |x df/dx|)/|f|, x = m1, heuristic, three digits
};

inline constexpr std::array<libration_complete_integral_row, 15> libration_complete_integral{{
    {"1e-30", "35.925070756030575879104336063190547517856530242122", "0.0139"},
    {"1e-20", "24.412145291060347459072909152987646080809877991526", "0.0205"},
    {"1e-10", "12.899219826387599534593173395192863188691344770378", "0.0388"},
    {"1e-6", "8.2940514636154399853155192787994382122758659369036", "0.0603"},
    {"0.001", "4.8411325605502970303391040646071232214552702734971", "0.103"},
    {"0.01", "3.6956373629898746778099541952625509848006720058192", "0.134"},
    {"0.1", "2.5780921133481731882025707718165062351135573742577", "0.183"},
    {"0.19", "2.2805491384227702046137519445555304387432379662788", "0.200"},
    {"0.36", "1.9953027776647293876862113393724373493819680723689", "0.218"},
    {"0.5", "1.8540746773013719184338503471952600462175988235218", "0.228"},
    {"0.64", "1.7507538029157525289752260460121482557674591609168", "0.236"},
    {"0.75", "1.6857503548125960428712036577990769895008008941411", "0.241"},
    {"0.9", "1.6124413487202193982299163630853741545268463794959", "0.247"},
    {"0.99", "1.5747455615173559526690306886598600916467487899161", "0.250"},
    {"0.999999", "1.5707967194941992113423302280413170829727825411615", "0.250"},
}};
