#include "attack/plane_field.hpp"

#include <algorithm>
#include <vector>

#include "libration/number/exact.hpp"

namespace libration::attack {

namespace {

constexpr int most_pieces = 40;

rational cross(const plane_vector& a, const plane_vector& b) { return a.u * b.v - a.v * b.u; }

plane_vector moved(const plane_vector& from, const plane_vector& velocity, const rational& time) {
    return {from.u + velocity.u * time, from.v + velocity.v * time};
}

// A way to leave a point: the signs of u and v directly afterwards, and the velocity.
struct departure {
    int u, v;
    plane_vector velocity;

    friend bool operator==(const departure&, const departure&) = default;
};

class ways {
public:
    ways(const sign_field& field, bool as_written) : field_(field), as_written_(as_written) {}

    // All ways to leave a point; of a segment of velocities its two ends.
    std::vector<departure> from(const plane_vector& point) const {
        std::vector<departure> all;
        for (int u = -1; u <= 1; ++u) {
            for (int v = -1; v <= 1; ++v) {
                if ((point.u == 0 || point.u.sign() == u) && (point.v == 0 || point.v.sign() == v)) {
                    add(all, point, u, v);
                }
            }
        }
        return all;
    }

    // All quadrants turn the same way, so that a solution may leave the origin by turning around it.
    bool turns() const {
        const auto direction = [&](int u, int v) {
            const plane_vector f = field_(u, v);
            return f.u.sign() == -v && f.v.sign() == u ? 1 : f.u.sign() == v && f.v.sign() == -u ? -1 : 0;
        };
        const int first = direction(1, 1);
        return first != 0 && direction(-1, 1) == first && direction(1, -1) == first && direction(-1, -1) == first;
    }

private:
    void add(std::vector<departure>& all, const plane_vector& point, int u, int v) const {
        for (const plane_vector& velocity : velocities(u, v)) {
            const bool stays = (point.u != 0 || velocity.u.sign() == u) && (point.v != 0 || velocity.v.sign() == v);
            const departure way{u, v, velocity};
            if (stays && std::ranges::find(all, way) == all.end()) {
                all.push_back(way);
            }
        }
    }

    // The values of the right-hand side that keep a point in a cell of the plane, or all of a quadrant.
    std::vector<plane_vector> velocities(int u, int v) const {
        if (as_written_ || (u != 0 && v != 0)) {
            return {field_(u, v)};
        }
        if (u == 0 && v == 0) {
            return hull_holds_0() ? std::vector<plane_vector>{{0, 0}} : std::vector<plane_vector>{};
        }
        const plane_vector a = u == 0 ? field_(1, v) : field_(u, 1);
        const plane_vector b = u == 0 ? field_(-1, v) : field_(u, -1);
        const rational across_a = u == 0 ? a.u : a.v;
        const rational across_b = u == 0 ? b.u : b.v;
        if (across_a == 0 && across_b == 0) {
            const plane_vector written = field_(u, v);
            return (u == 0 ? written.u : written.v) == 0 ? std::vector<plane_vector>{written}
                                                         : std::vector<plane_vector>{a, b};
        }
        if (across_a.sign() * across_b.sign() > 0) {
            return {};
        }
        const rational part = across_b / (across_b - across_a);  // of a
        return {{part * a.u + (1 - part) * b.u, part * a.v + (1 - part) * b.v}};
    }

    // Not so if a line has all fields of the quadrants strictly on one side.
    bool hull_holds_0() const {
        std::array<plane_vector, 4> all{field_(1, 1), field_(-1, 1), field_(-1, -1), field_(1, -1)};
        if (std::ranges::find(all, plane_vector{}) != all.end()) {
            return true;
        }
        // Then one of them is the first counterclockwise: the others are less than half a turn ahead.
        return std::ranges::none_of(all, [&](const plane_vector& first) {
            return std::ranges::all_of(all, [&](const plane_vector& other) {
                const int side = cross(first, other).sign();
                return side > 0 || (side == 0 && first.u * other.u + first.v * other.v > 0);
            });
        });
    }

    const sign_field& field_;
    bool as_written_;
};

// When a coordinate that has a sign becomes 0.
std::optional<rational> time_to_zero(const rational& from, const rational& velocity) {
    return from.sign() * velocity.sign() < 0 ? std::optional<rational>(-from / velocity) : std::nullopt;
}

// Whether u' or v' is 0 for all signs.
bool vanishes(const sign_field& field, rational plane_vector::*part) {
    for (int u = -1; u <= 1; ++u) {
        for (int v = -1; v <= 1; ++v) {
            if (field(u, v).*part != 0) {
                return false;
            }
        }
    }
    return true;
}

plane_solution solution(const sign_field& field, bool as_written, plane_vector at, const rational& time) {
    using number = plane_solution::number;
    const ways all(field, as_written);
    plane_solution result;
    rational left = time;
    for (int piece = 0; piece < most_pieces; ++piece) {
        if (at == plane_vector{} && all.turns()) {
            return result;
        }
        auto next = all.from(at);
        if (next.size() == 1) {  // and there is no other way a little later
            result.on_a_surface = result.on_a_surface || next.front().u == 0 || next.front().v == 0;
            next = all.from(moved(at, next.front().velocity, rational(1, 1'000'000'000)));
        }
        if (next.size() != 1) {
            result.how_many = next.empty() ? number::none : number::several;
            return result;
        }
        const plane_vector velocity = next.front().velocity;
        rational until = left;
        for (const auto& each : {time_to_zero(at.u, velocity.u), time_to_zero(at.v, velocity.v)}) {
            until = each ? std::min(until, *each) : until;
        }
        at = moved(at, velocity, until);
        left -= until;
        if (left == 0) {
            result.on_a_surface = result.on_a_surface || at.u == 0 || at.v == 0;  // from here on
            result.how_many = number::one;
            result.end = at;
            return result;
        }
    }
    return result;
}

}  // namespace

plane_solution filippov_solution(const sign_field& field, const plane_vector& start, const rational& time) {
    return solution(field, false, start, time);
}

plane_solution caratheodory_solution(const sign_field& field, const plane_vector& start, const rational& time) {
    return solution(field, true, start, time);
}

known_end end_of(const sign_field& given, const plane_vector& start, const rational& time) {
    using number = plane_solution::number;
    const bool keeps_u = start.u == 0 && vanishes(given, &plane_vector::u);
    const bool keeps_v = start.v == 0 && vanishes(given, &plane_vector::v);
    const sign_field field = [&](int u, int v) { return given(keeps_u ? 0 : u, keeps_v ? 0 : v); };
    const plane_solution in_hull = filippov_solution(field, start, time);
    const plane_solution as_written = caratheodory_solution(field, start, time);
    const auto either = [&](number n) { return in_hull.how_many == n || as_written.how_many == n; };
    const bool both = in_hull.how_many == number::one && as_written.how_many == number::one;
    if (either(number::several) || (both && !(as_written.end == in_hull.end))) {
        return {true, std::nullopt, true};
    }
    return {!either(number::unknown) && in_hull.how_many == number::one, in_hull.end,
            in_hull.on_a_surface || as_written.on_a_surface};
}

}  // namespace libration::attack
