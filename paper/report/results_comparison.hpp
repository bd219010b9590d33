// Compares recomputed results with the published ones: which tables differ.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace libration {

/// The tables and figures of two results folders, compared.
struct results_comparison {
    std::size_t exact = 0;           ///< tables whose bytes depend on the parameters alone: mpfr, balls
    std::vector<std::string> wrong;  ///< those of them that differ, each with its first difference
    std::size_t machine = 0;         ///< tables of double, long double, quad, and of times
    std::vector<std::string> moved;  ///< those of them that differ, as libm and clocks may
    std::size_t figures = 0;
    std::vector<std::string> redrawn;  ///< figures (.svg) that differ
    std::vector<std::string> fresh;    ///< parts that are not published yet
    std::vector<std::string> missing;  ///< parts that were not made

    /// Whether all was made, and all that has to be the same is.
    bool same() const { return wrong.empty() && missing.empty(); }
    /// One line each, for stderr.
    std::vector<std::string> lines(const std::string& published) const;
};

/// Compares these parts (studies, claims, reference) of the folder `made` with those of `published`. A row whose column
/// `scalar` names an arithmetic of the machine counts as that. Throws std::runtime_error for a file that cannot be
/// read.
results_comparison compared(const std::string& made, const std::string& published,
                            const std::vector<std::string>& parts);

}  // namespace libration
