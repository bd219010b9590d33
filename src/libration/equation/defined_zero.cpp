#include "libration/equation/defined_zero.hpp"

#include <algorithm>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "libration/equation/node_values.hpp"
#include "libration/function/list.hpp"

namespace libration::ode {

namespace {

using part_set = std::unordered_set<expression, same_expression::hash, same_expression::equal>;

bool is_folded(const expression& e) { return e.kind() == node_kind::constant; }

bool is_analytic_for_all_x(const expression& function) {
    return function::with_function(function.function(), [&](auto of) {
        using each = decltype(of);
        if constexpr (function::ordered<each>) {
            const auto order = function.right().fraction();
            return order && function::is_whole(*order) && each::form == function::analytic_form::entire;
        } else {
            return std::string_view(each::domain) == "all x" && each::singular.count == 0;
        }
    });
}

bool is_restricted(const expression& e) {
    switch (e.kind()) {
        case node_kind::quotient: return true;
        case node_kind::power: {
            const auto exponent = e.right().fraction();
            return !exponent || denominator(*exponent) != 1 || *exponent < 0;
        }
        case node_kind::function: return !is_analytic_for_all_x(e);
        case node_kind::constant:
        case node_kind::variable:
        case node_kind::unknown:
        case node_kind::parameter:
        case node_kind::sum:
        case node_kind::product: break;
    }
    return false;
}

// Replaces leaves and collects the restricted parts, in an order that depends only on the expressions.
class part_reader {
public:
    explicit part_reader(replacement by) : by_(std::move(by)) {}

    expression read(const expression& e) {
        return done_.of(e, [&](const expression& node) {
            const bool leaf = node.kind() == node_kind::variable || node.kind() == node_kind::unknown ||
                              node.kind() == node_kind::parameter;
            if (auto other = leaf && by_ ? by_(node) : std::nullopt) {
                read_replacement(*other);
                return *std::move(other);
            }
            expression made = with_operands(node, done_, by_);
            if (is_restricted(node)) {
                const bool quotient = node.kind() == node_kind::quotient;
                add(quotient ? expression(1) / done_.at(node.right()) : made,
                    quotient ? expression(1) / node.right() : node);
            }
            return made;
        });
    }

    const std::vector<expression>& parts() const { return parts_; }
    // The parts before their leaves were replaced.
    const std::vector<expression>& originals() const { return originals_; }
    bool has(const expression& part) const { return known_.contains(part); }

private:
    void read_replacement(const expression& other) {
        if (!is_folded(other) && replacements_.insert(other.identity()).second) {
            part_reader inner({});
            inner.read(other);
            for (const expression& each : inner.parts()) {
                add(each, each);
            }
        }
    }

    void add(const expression& part, const expression& original) {
        if (!is_folded(part) && known_.insert(part).second) {
            parts_.push_back(part);
            originals_.push_back(original);
        }
    }

    const replacement by_;
    node_values<expression> done_;
    std::vector<expression> parts_, originals_;
    part_set known_;
    std::unordered_set<const void*> replacements_;
};

bool has_restricted(const expression& e) {
    part_reader reader({});
    reader.read(e);
    return !reader.parts().empty();
}

std::vector<expression> missing_in(const part_reader& before, const std::vector<expression>& after) {
    std::vector<expression> lost;
    if (before.parts().empty()) {
        return lost;
    }
    part_reader kept({});
    for (const expression& each : after) {
        kept.read(each);
    }
    for (const expression& each : before.parts()) {
        if (!kept.has(each)) {
            lost.push_back(each);
        }
    }
    return lost;
}

expression with_zeros(expression value, const std::vector<expression>& lost) {
    for (const expression& each : lost) {
        value = value + zero_where_defined(each);
    }
    return value;
}

// A constant instead of operands that are not; it is defined where these are.
expression with_domain_of(const expression& folded, const expression& a, const expression& b) {
    if (!is_folded(folded) || (is_folded(a) && is_folded(b))) {
        return folded;
    }
    expression made = folded;
    for (const expression* each : {&a, &b}) {
        made = is_folded(*each) ? made : made + zero_where_defined(*each);
    }
    return made;
}

}  // namespace

folded_expression folded_by(const expression& e, const replacement& by) {
    part_reader before(by);
    expression value = before.read(e);
    auto lost = missing_in(before, {value});
    return {std::move(value), std::move(lost)};
}

std::vector<expression> parts_lost(const std::vector<expression>& from, const replacement& by,
                                   const std::vector<expression>& others) {
    part_reader before(by);
    for (const expression& each : from) {
        before.read(each);
    }
    return missing_in(before, others);
}

expression zero_where_defined(const expression& e) {
    return is_folded(e) || !has_restricted(e) ? expression() : unfolded_zero(e);
}

expression without_zeros(const expression& e) {
    bool found = false;
    expression without = with_nodes_replaced(e, [&](const expression& node) -> std::optional<expression> {
        found = found || node.is_unfolded_zero();
        return node.is_unfolded_zero() ? std::optional(expression()) : std::nullopt;
    });
    return found ? without : e;
}

expression written_sum(const expression& a, const expression& b) { return with_domain_of(a + b, a, 0); }

expression written_product(const expression& a, const expression& b) { return with_domain_of(a * b, a, b); }

expression written_quotient(const expression& a, const expression& b) {
    return with_domain_of(a / b, a, is_folded(b) ? b : expression(1) / b);
}

expression written_power(const expression& base, const expression& exponent) {
    return with_domain_of(pow(base, exponent), base, exponent);
}

expression replaced_as_written(const expression& e, const replacement& by) {
    const folded_expression folded = folded_by(e, by);
    return with_zeros(folded.value, folded.lost);
}

std::optional<std::vector<expression>> zero_with_domain(const expression& e, const replacement& by) {
    part_reader before(by);
    const expression value = before.read(e);
    return without_zeros(value).is(0) ? std::optional(before.parts()) : std::nullopt;
}

replacement at_starts(const explicit_system& of, const std::set<std::string>& names) {
    return [&of, names, places = places_of(of.unknowns())](const expression& leaf) -> std::optional<expression> {
        if (leaf.kind() != node_kind::unknown || !names.contains(leaf.name())) {
            return std::nullopt;
        }
        return expression(of.starts()[places.at(leaf.name())][static_cast<std::size_t>(leaf.derivative())]);
    };
}

std::set<std::string> resting_unknowns(const explicit_system& of, std::set<std::string> among) {
    for (std::size_t before = among.size() + 1; before != among.size();) {
        before = among.size();
        const replacement by = at_starts(of, among);
        std::set<std::string> moving;
        for (std::size_t i = 0; i < of.unknowns().size(); ++i) {
            if (among.contains(of.unknowns()[i].name) && !zero_with_domain(of.right()[i], by)) {
                moving.insert(of.unknowns()[i].name);
            }
        }
        std::erase_if(among, [&](const std::string& name) { return moving.contains(name); });
    }
    return among;
}

std::vector<expression> hidden_parts(const explicit_system& of) {
    std::set<std::string> among;
    for (std::size_t i = 0; i < of.starts().size() && !of.singular(); ++i) {
        const auto& values = of.starts()[i];
        if (std::all_of(values.begin() + 1, values.end(),
                        [](const number& x) { return x.fraction() == rational(0); })) {
            among.insert(of.unknowns()[i].name);
        }
    }
    part_reader all({});
    for (const expression& each : of.right()) {
        all.read(each);
    }
    std::vector<expression> hidden;
    if (all.parts().empty()) {
        return hidden;
    }
    const std::set<std::string> resting = resting_unknowns(of, std::move(among));
    const replacement by = at_starts(of, resting);
    part_reader before(by);
    part_reader moving({});
    for (std::size_t i = 0; i < of.right().size(); ++i) {
        before.read(of.right()[i]);
        if (!resting.contains(of.unknowns()[i].name)) {
            moving.read(without_zeros(replaced(of.right()[i], by)));
        }
    }
    for (std::size_t k = 0; k < before.parts().size(); ++k) {
        if (!moving.has(before.parts()[k])) {
            hidden.push_back(before.originals()[k]);
        }
    }
    return hidden;
}

}  // namespace libration::ode
