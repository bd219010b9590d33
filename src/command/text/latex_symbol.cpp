#include "text/latex_symbol.hpp"

#include <algorithm>
#include <map>
#include <string_view>

namespace libration {

namespace {

const std::map<std::string, std::string>& latex_symbols() {
    static const std::map<std::string, std::string> all{{"energy", "$E$"},
                                                        {"gap", "$2-E$"},
                                                        {"order", "$N$"},
                                                        {"n", "$n$"},
                                                        {"time", "$t$"},
                                                        {"theta", "$\\theta$"},
                                                        {"theta0", "$\\theta_0$"},
                                                        {"theta_exact", "$\\theta$ exact"},
                                                        {"omega", "$\\omega$"},
                                                        {"omega0", "$\\omega_0$"},
                                                        {"period", "$T$"},
                                                        {"tstar", "$T^*$"},
                                                        {"radius", "$R$"},
                                                        {"radius_over_tstar", "$R/T^*$"},
                                                        {"height", "$\\tilde K'$"},
                                                        {"norm", "$\\max|\\mathrm{error}|$"},
                                                        {"exact_norm", "$\\max|\\mathrm{error}|$ exact"},
                                                        {"norm_in_epsilon", R"($\max|\mathrm{error}|/\varepsilon$)"},
                                                        {"error", "$|\\mathrm{error}|$"},
                                                        {"epsilon", "$\\varepsilon$"},
                                                        {"time_of_maximum", "$t_{\\max}$"},
                                                        {"step", "$\\Delta t$"},
                                                        {"periods", "$t/T$"},
                                                        {"inverse_n", "$1/n$"},
                                                        {"m1", "$m_1$"},
                                                        {"m", "$m$"},
                                                        {"u", "$u$"},
                                                        {"phi", "$\\varphi$"},
                                                        {"digits", "$D$"},
                                                        {"re", "$\\mathrm{Re}\\,t$"},
                                                        {"im", "$\\mathrm{Im}\\,t$"},
                                                        {"relative_error", "relative error"}};
    return all;
}

}  // namespace

std::string latex_text(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) {
            out += std::string("\\") + c;
        } else if (c == '~' || c == '^') {
            out += std::string("\\") + c + "{}";
        } else if (c == '\\') {
            out += "\\textbackslash{}";
        } else if (c == '-' && out.ends_with('-')) {
            out += "{}-";  // two hyphens are an option, and no dash
        } else if (c == '<' || c == '>' || c == '|') {
            out += std::string("$") + c + "$";  // the usual font of text has none of them
        } else {
            out += c;
        }
    }
    return out;
}

std::string latex_head(const std::string& name) {
    if (const auto symbol = latex_symbols().find(name); symbol != latex_symbols().end()) {
        return symbol->second;
    }
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    return latex_text(words);
}

}  // namespace libration
