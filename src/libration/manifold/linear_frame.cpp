#include "linear_frame.hpp"

#include <complex>

#include "../algebra/dense_matrix.hpp"
#include "invariant_block.hpp"
#include "linear_steps.hpp"

namespace libration::ode {

namespace {

std::vector<complex_jet> exact_jets(const std::vector<std::complex<double>>& of) {
    std::vector<complex_jet> result;
    for (const auto& each : of) {
        result.emplace_back(complex_ball(exactly(each.real()), exactly(each.imag())));
    }
    return result;
}

}  // namespace

std::optional<linear_frame> enclosed_frame(const jet_matrix& linear, const frame_plan& plan) {
    const std::size_t size = linear.size();
    linear_frame result{jet_matrix(size, std::vector<complex_jet>(size)),
                        jet_matrix(plan.size(), std::vector<complex_jet>(plan.size()))};
    const complex_jet scale = real_jet(magnitude::of(1, plan.log2_scale).exact());
    for (const frame_block& block : plan.blocks) {
        jet_matrix near;
        jet_matrix mixture;
        for (std::size_t c = 0; c < block.columns.size(); ++c) {
            near.push_back(exact_jets(block.basis[c]));
            mixture.push_back(exact_jets(block.mixture[c]));
        }
        const auto found = enclosed_block(linear, block.pivots, near);
        const auto back = inverse(mixture);
        if (!found || !back) {
            return std::nullopt;
        }
        const jet_matrix columns = product(found->columns, mixture);
        const jet_matrix inner = product(*back, product(found->inner, mixture));
        for (std::size_t c = 0; c < block.columns.size(); ++c) {
            const std::size_t j = block.columns[c];
            const bool paired = plan.begins_pair(j);
            for (std::size_t i = 0; i < size; ++i) {
                result.columns[i][j] = columns[i][c] * scale;
                if (paired) {
                    result.columns[i][j + 1] = conjugate(result.columns[i][j]);
                }
            }
            for (std::size_t r = 0; r < block.columns.size(); ++r) {
                const std::size_t i = block.columns[r];
                result.inner[i][j] = inner[r][c];
                if (paired) {
                    result.inner[i + 1][j + 1] = conjugate(inner[r][c]);
                }
            }
        }
    }
    for (std::size_t j = plan.size(); j < size; ++j) {
        for (std::size_t i = 0; i < size; ++i) {
            result.columns[i][j] = real_jet(exactly(plan.others[j - plan.size()][i]));
        }
    }
    return result;
}

}  // namespace libration::ode
