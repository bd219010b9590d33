#include "character.hpp"

#include <algorithm>
#include <array>

#include "libration/scalar/utf8.hpp"

namespace libration::ode {

namespace {

struct spelling {
    std::string_view source;
    std::string_view ascii;
    character_kind kind;
};

constexpr auto as_letter = character_kind::letter;
constexpr auto as_superscript = character_kind::superscript;
constexpr auto as_subscript = character_kind::subscript;
constexpr auto as_symbol = character_kind::symbol;

constexpr std::array spellings{
    spelling{"α", "alpha", as_letter},
    spelling{"β", "beta", as_letter},
    spelling{"γ", "gamma", as_letter},
    spelling{"δ", "delta", as_letter},
    spelling{"ε", "epsilon", as_letter},
    spelling{"ϵ", "epsilon", as_letter},
    spelling{"ζ", "zeta", as_letter},
    spelling{"η", "eta", as_letter},
    spelling{"θ", "theta", as_letter},
    spelling{"ϑ", "theta", as_letter},
    spelling{"κ", "kappa", as_letter},
    spelling{"λ", "lambda", as_letter},
    spelling{"μ", "mu", as_letter},
    spelling{"µ", "mu", as_letter},  // the micro sign
    spelling{"ν", "nu", as_letter},
    spelling{"ξ", "xi", as_letter},
    spelling{"ρ", "rho", as_letter},
    spelling{"σ", "sigma", as_letter},
    spelling{"τ", "tau", as_letter},
    spelling{"φ", "phi", as_letter},
    spelling{"ϕ", "phi", as_letter},
    spelling{"χ", "chi", as_letter},
    spelling{"ψ", "psi", as_letter},
    spelling{"ω", "omega", as_letter},
    spelling{"Γ", "Gamma", as_letter},
    spelling{"Δ", "Delta", as_letter},
    spelling{"Θ", "Theta", as_letter},
    spelling{"Λ", "Lambda", as_letter},
    spelling{"Φ", "Phi", as_letter},
    spelling{"Ψ", "Psi", as_letter},
    spelling{"Ω", "Omega", as_letter},
    spelling{"π", "pi", character_kind::word},
    spelling{"∞", "inf", character_kind::word},
    spelling{"°", "deg", character_kind::word},
    spelling{"√", "sqrt", character_kind::word},
    spelling{"⁰", "0", as_superscript},
    spelling{"¹", "1", as_superscript},
    spelling{"²", "2", as_superscript},
    spelling{"³", "3", as_superscript},
    spelling{"⁴", "4", as_superscript},
    spelling{"⁵", "5", as_superscript},
    spelling{"⁶", "6", as_superscript},
    spelling{"⁷", "7", as_superscript},
    spelling{"⁸", "8", as_superscript},
    spelling{"⁹", "9", as_superscript},
    spelling{"⁻", "-", as_superscript},
    spelling{"⁺", "+", as_superscript},
    spelling{"₀", "0", as_subscript},
    spelling{"₁", "1", as_subscript},
    spelling{"₂", "2", as_subscript},
    spelling{"₃", "3", as_subscript},
    spelling{"₄", "4", as_subscript},
    spelling{"₅", "5", as_subscript},
    spelling{"₆", "6", as_subscript},
    spelling{"₇", "7", as_subscript},
    spelling{"₈", "8", as_subscript},
    spelling{"₉", "9", as_subscript},
    spelling{"′", "'", character_kind::prime},
    spelling{"’", "'", character_kind::prime},  // as text processors write '
    spelling{"ʹ", "'", character_kind::prime},
    spelling{"´", "'", character_kind::prime},
    spelling{"″", "''", character_kind::prime},
    spelling{"”", "''", character_kind::prime},
    spelling{"‴", "'''", character_kind::prime},
    spelling{"⁗", "''''", character_kind::prime},
    spelling{"·", "*", as_symbol},
    spelling{"⋅", "*", as_symbol},
    spelling{"×", "*", as_symbol},
    spelling{"∗", "*", as_symbol},
    spelling{"∙", "*", as_symbol},
    spelling{"÷", "/", as_symbol},
    spelling{"∕", "/", as_symbol},
    spelling{"⁄", "/", as_symbol},
    spelling{"−", "-", as_symbol},
    spelling{"–", "-", as_symbol},  // a dash
    spelling{"≤", "<", as_symbol},
    spelling{"≥", ">", as_symbol},
    spelling{"\u00a0", "", character_kind::blank},
    spelling{"\u2002", "", character_kind::blank},
    spelling{"\u2003", "", character_kind::blank},
    spelling{"\u2009", "", character_kind::blank},
    spelling{"\u202f", "", character_kind::blank},
    spelling{"\u2062", "", character_kind::blank},
    spelling{"\u3000", "", character_kind::blank},
    spelling{"\ufeff", "", character_kind::blank},
};

// Of the character at the front of a text; 1 for a byte that is not part of one.
std::size_t bytes_of_first(std::string_view text) { return std::max<std::size_t>(bytes_of_character(text), 1); }

}  // namespace

character first_character(std::string_view text) {
    const std::string_view source = text.substr(0, bytes_of_first(text));
    if (static_cast<unsigned char>(source.front()) < 0x80) {
        return {source, source, character_kind::ascii};
    }
    const auto* const found = std::ranges::find(spellings, source, &spelling::source);
    return found != spellings.end() ? character{source, found->ascii, found->kind}
                                    : character{source, "", character_kind::other};
}

std::size_t characters_in(std::string_view text) {
    std::size_t count = 0;
    for (; !text.empty(); ++count) {
        text.remove_prefix(bytes_of_first(text));
    }
    return count;
}

bool is_greek_name(std::string_view name) {
    return std::ranges::any_of(
        spellings, [&](const spelling& each) { return each.kind == character_kind::letter && each.ascii == name; });
}

}  // namespace libration::ode
