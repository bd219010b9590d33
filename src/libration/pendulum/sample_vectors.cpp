// Highway compiles the code between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each set of instructions
// that this kind of processor may have, by including this file again.
#include "libration/pendulum/sample_vectors.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libration/pendulum/sample_vectors.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace libration::pendulum::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Not more lanes than a panel's row can be divided into.
using doubles = hn::CappedTag<double, 8>;
using words = hn::RebindToUnsigned<doubles>;
using vector = hn::Vec<doubles>;

constexpr std::size_t lanes = hn::MaxLanes(doubles());
constexpr std::size_t row = 2 * double_panel_terms;
// The number of pairs of coefficients of theta and of its slope in a vector; without vectors, a half-cycle is
// two numbers.
constexpr std::size_t pairs = lanes == 1 ? 1 : lanes / 2;
static_assert(row % (2 * pairs) == 0 && vector_block % lanes == 0);

using column = std::array<double, vector_block>;

// Between the loops over a block.
struct block {
    HWY_ALIGN column passage;
    HWY_ALIGN column sign;
    HWY_ALIGN column mirror;
    // The distance to the centre of the panel raised to the number of pairs, and twice itself.
    HWY_ALIGN column power;
    HWY_ALIGN std::array<double, 2 * vector_block> step;
    // theta and slope of the half-cycle.
    HWY_ALIGN std::array<double, 2 * vector_block> swing;
    HWY_ALIGN std::array<std::uint64_t, vector_block> panel;
};

// x to the number of pairs.
HWY_INLINE vector raised(vector x) {
    for (std::size_t power = 1; power < pairs; power *= 2) {
        x = hn::Mul(x, x);
    }
    return x;
}

// half_cycle_clock::locate and place_of; false if the time is outside the range of the clock.
HWY_INLINE bool locate(const vector_tables& tables, const double* times, block& b) {
    constexpr int below = 52 - panel_octave_bits;
    constexpr std::uint64_t first_index = std::uint64_t{1023} << panel_octave_bits;
    const doubles d;
    const words w;
    const clock_constants<double>& clock = tables.clock;
    const vector per_unit = hn::Set(d, clock.per_unit);
    const vector start = hn::Set(d, clock.start.high);
    const vector start_low = hn::Set(d, clock.start.low);
    const vector per_passage = hn::Set(d, clock.per_passage);
    const vector largest = hn::Set(d, clock.largest);
    const vector rounder = hn::Set(d, clock.rounder);
    const vector first = hn::Set(d, clock.first);
    const vector second = hn::Set(d, clock.second);
    const vector third = hn::Set(d, clock.third);
    const vector start_sign = hn::Set(d, tables.turns.sign);
    const vector alternation = hn::Set(d, tables.turns.sign * tables.turns.alternation);
    const vector end = hn::Set(d, tables.end);
    const vector one = hn::Set(d, 1.0);
    const vector half = hn::Set(d, 0.5);
    auto reached = hn::Eq(one, one);
    for (std::size_t i = 0; i < vector_block; i += lanes) {
        const vector t = hn::Mul(hn::LoadU(d, times + i), per_unit);
        const vector since = hn::Add(t, start);
        const vector part = hn::Sub(since, t);
        const vector lost = hn::Add(hn::Sub(t, hn::Sub(since, part)), hn::Sub(start, part));
        const vector passages = hn::Mul(since, per_passage);
        reached = hn::And(reached, hn::Le(hn::Abs(passages), largest));
        const vector j = hn::Sub(hn::Add(passages, rounder), rounder);
        const vector reduced = hn::NegMulAdd(j, second, hn::NegMulAdd(j, first, since));
        const vector small = hn::Add(lost, hn::NegMulAdd(j, third, start_low));
        const vector high = hn::Add(reduced, small);
        const vector low = hn::Sub(small, hn::Sub(high, reduced));
        const vector side = hn::And(high, hn::SignBit(d));
        const vector x = hn::Xor(high, side);
        const auto inside = hn::Lt(x, end);

        const vector evens = hn::Sub(hn::Add(hn::Mul(j, half), rounder), rounder);
        const vector odd = hn::Abs(hn::Sub(j, hn::Add(evens, evens)));
        const vector sign = hn::NegMulAdd(alternation, odd, start_sign);
        hn::Store(j, d, b.passage.data() + i);
        hn::Store(sign, d, b.sign.data() + i);
        hn::Store(hn::Xor(sign, side), d, b.mirror.data() + i);

        const vector at = hn::IfThenElse(inside, x, end);
        const vector rest = hn::IfThenElseZero(inside, hn::Xor(low, side));
        const auto leading = hn::ShiftRight<below>(hn::BitCast(w, hn::Add(one, at)));
        const auto middle = hn::Or(hn::ShiftLeft<below>(leading), hn::Set(w, std::uint64_t{1} << (below - 1)));
        const vector step = hn::Add(hn::Sub(at, hn::Sub(hn::BitCast(d, middle), one)), rest);
        hn::Store(hn::Sub(leading, hn::Set(w, first_index)), w, b.panel.data() + i);
        hn::Store(raised(step), d, b.power.data() + i);
        hn::StoreInterleaved2(step, step, d, b.step.data() + 2 * i);
    }
    return hn::AllTrue(d, reached);
}

// The sums of every pairs-th coefficient of theta and of its slope from `first` on, as many as fit in a vector.
HWY_INLINE vector partial_sums(const vector_tables& tables, const block& b, std::size_t i, std::size_t first = 0) {
    constexpr std::size_t stride = 2 * pairs;
    const doubles d;
    const double* const coefficients = tables.panels + row * b.panel[i] + first;
    const vector power = hn::Set(d, b.power[i]);
    vector sum = hn::Load(d, coefficients + (row - stride));
    for (std::size_t left = row - stride; left > 0; left -= stride) {
        sum = hn::MulAdd(sum, power, hn::Load(d, coefficients + (left - stride)));
    }
    return sum;
}

// theta and slope of the times i, ..., i + pairs - 1: Horner's rule over their partial sums, which are transposed so
// that a vector holds those of one power.
HWY_INLINE void swing(const vector_tables& tables, block& b, std::size_t i) {
    const doubles d;
    double* const to = b.swing.data() + 2 * i;
#if HWY_TARGET == HWY_SCALAR
    hn::Store(partial_sums(tables, b, i), d, to);
    hn::Store(partial_sums(tables, b, i, 1), d, to + 1);
#elif HWY_MAX_BYTES == 16
    hn::Store(partial_sums(tables, b, i), d, to);
#else
    const vector x = hn::Load(d, b.step.data() + 2 * i);
    const vector s0 = partial_sums(tables, b, i);
    const vector s1 = partial_sums(tables, b, i + 1);
#if HWY_MAX_BYTES >= 64
    const vector s2 = partial_sums(tables, b, i + 2);
    const vector s3 = partial_sums(tables, b, i + 3);
    const vector low02 = hn::ConcatLowerLower(d, s2, s0);
    const vector low13 = hn::ConcatLowerLower(d, s3, s1);
    const vector high02 = hn::ConcatUpperUpper(d, s2, s0);
    const vector high13 = hn::ConcatUpperUpper(d, s3, s1);
    const vector powers0 = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(low13), low02);
    const vector powers1 = hn::OddEvenBlocks(low13, hn::SwapAdjacentBlocks(low02));
    const vector powers2 = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(high13), high02);
    const vector powers3 = hn::OddEvenBlocks(high13, hn::SwapAdjacentBlocks(high02));
    hn::Store(hn::MulAdd(hn::MulAdd(hn::MulAdd(powers3, x, powers2), x, powers1), x, powers0), d, to);
#else
    hn::Store(hn::MulAdd(hn::ConcatUpperUpper(d, s1, s0), x, hn::ConcatLowerLower(d, s1, s0)), d, to);
#endif
#endif
}

// half_cycle_turns::theta, and omega.
HWY_INLINE void turn(const vector_tables& tables, const block& b, double* theta, double* omega) {
    const doubles d;
    const turn_constants<double>& turns = tables.turns;
    const vector per_unit = hn::Set(d, tables.clock.per_unit);
    const vector whole_turns = hn::Set(d, turns.turns);
    const vector winding = hn::Set(d, turns.winding);
    const vector turn_high = hn::Set(d, turns.turn.high);
    const vector turn_low = hn::Set(d, turns.turn.low);
    const vector base_high = hn::Set(d, turns.base.high);
    const vector base_low = hn::Set(d, turns.base.low);
    for (std::size_t i = 0; i < vector_block; i += lanes) {
        vector value;
        vector slope;
        hn::LoadInterleaved2(d, b.swing.data() + 2 * i, value, slope);
        const vector part = hn::Mul(value, hn::Load(d, b.mirror.data() + i));
        const vector count = hn::MulAdd(winding, hn::Load(d, b.passage.data() + i), whole_turns);
        const vector small = hn::MulAdd(count, turn_low, hn::Add(base_low, part));
        hn::StoreU(hn::Add(base_high, hn::MulAdd(count, turn_high, small)), d, theta + i);
        hn::StoreU(hn::Mul(slope, hn::Mul(hn::Load(d, b.sign.data() + i), per_unit)), d, omega + i);
    }
}

std::size_t sample(const vector_tables& tables, const double* times, std::size_t count, double* theta, double* omega) {
    block b;
    std::size_t done = 0;
    for (; done + vector_block <= count && locate(tables, times + done, b); done += vector_block) {
        for (std::size_t i = 0; i < vector_block; i += pairs) {
            swing(tables, b, i);
        }
        turn(tables, b, theta + done, omega + done);
    }
    return done;
}

}  // namespace libration::pendulum::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace libration::pendulum {

HWY_EXPORT(sample);

std::size_t sample_vectors(const vector_tables& tables, const double* times, std::size_t count, double* theta,
                           double* omega) {
    return HWY_DYNAMIC_DISPATCH(sample)(tables, times, count, theta, omega);
}

}  // namespace libration::pendulum

#endif
