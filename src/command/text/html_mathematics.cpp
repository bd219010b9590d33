// Formulas of plain text as a reader of a page expects them.
#include <cctype>
#include <cstddef>
#include <map>

#include "text/html.hpp"

namespace libration {

namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_decimal_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_alnum(char c) { return is_letter(c) || is_decimal_digit(c); }

const std::map<std::string, std::string>& symbols() {
    static const std::map<std::string, std::string> all{
        {"theta", "θ"}, {"omega", "ω"},  {"alpha", "α"}, {"beta", "β"},     {"sigma", "σ"}, {"pi", "π"},
        {"phi", "φ"},   {"lambda", "λ"}, {"gamma", "γ"}, {"epsilon", "ε"},  {"Gamma", "Γ"}, {"ahat", "â"},
        {"psi", "ψ"},   {"delta", "δ"},  {"tau", "τ"},   {"infinity", "∞"}, {"Theta", "Θ"}};
    return all;
}

// Reads a text from left to right.
class formula_reader {
public:
    explicit formula_reader(const std::string& text) : text_(text) {}

    std::string read() {
        while (at_ < text_.size()) {
            if (is_letter(now()) && !after_word()) {
                word();
            } else if (is_decimal_digit(now()) && !after_word()) {
                number();
            } else if (!index("sup")) {
                other();
            }
        }
        return out_;
    }

private:
    char now(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
    bool after_word() const { return at_ > 0 && (is_alnum(text_[at_ - 1]) || text_[at_ - 1] == '_'); }

    template <class Kind>
    std::string take(const Kind& kind) {
        const std::size_t begin = at_;
        while (at_ < text_.size() && kind(text_[at_])) {
            ++at_;
        }
        return text_.substr(begin, at_ - begin);
    }

    void word() {
        const std::string letters = take(is_letter);
        const auto symbol = symbols().find(letters);
        const bool known = symbol != symbols().end();
        if (letters == "sqrt" && (now() == '(' || now() == '|')) {
            out_ += "√";
            return;
        }
        // thetabar does not contain theta, and T0 is not a letter with an index.
        out_ += known ? symbol->second : letters;
        if (known && is_decimal_digit(now())) {
            out_ += "<sub>" + take(is_decimal_digit) + "</sub>";
        }
        if (known || letters.size() == 1 || letters == "sum") {
            if (now() == '~' && now(1) == '\'') {
                out_ += "̃′";
                at_ += 2;
            }
            index("sub");
        }
        while (known && now() == '\'') {
            out_ += "′";
            ++at_;
        }
    }

    // _n, ^2, ^-n, ^(N+1): false, and nothing read, where it is none.
    bool index(const std::string& kind) {
        const char sign = kind == "sub" ? '_' : '^';
        if (now() != sign || (at_ > 0 && text_[at_ - 1] == ' ')) {
            return false;
        }
        std::size_t end = at_ + 1;
        std::string inside;
        if (now(1) == '(') {
            int depth = 0;
            do {
                depth += text_[end] == '(' ? 1 : text_[end] == ')' ? -1 : 0;
                ++end;
            } while (depth > 0 && end < text_.size());
            if (depth > 0) {
                return false;
            }
            inside = html_mathematics(text_.substr(at_ + 2, end - at_ - 3));
        } else {
            end += kind == "sup" && now(1) == '-' ? 1 : 0;
            const std::size_t begin = end;
            while (end < text_.size() && is_alnum(text_[end])) {
                ++end;
            }
            constexpr std::size_t longest = 4;
            if (end == begin || end - begin > longest || (end < text_.size() && text_[end] == '_')) {
                return false;
            }
            inside = (begin > at_ + 1 ? "−" : "") + html_mathematics(text_.substr(begin, end - begin));
        }
        out_ += "<" + kind + ">" + inside + "</" + kind + ">";
        at_ = end;
        return true;
    }

    // 1e-6, 2.5e-7, or without a power.
    void number() {
        const std::string mantissa = take([](char c) { return is_decimal_digit(c) || c == '.'; });
        const std::size_t sign = now() == 'e' && now(1) == '-' ? 1 : 0;
        std::size_t end = at_ + 1 + sign;
        while (end < text_.size() && is_decimal_digit(text_[end])) {
            ++end;
        }
        const bool power = now() == 'e' && end > at_ + 1 + sign && (end == text_.size() || !is_letter(text_[end]));
        if (!power) {
            out_ += mantissa;
            return;
        }
        out_ += (mantissa == "1" ? "" : mantissa + "·") + "10<sup>" + (sign == 1 ? "−" : "") +
                text_.substr(at_ + 1 + sign, end - at_ - 1 - sign) + "</sup>";
        at_ = end;
    }

    void other() {
        static const std::map<std::string, std::string> signs{{"<=", "≤"}, {">=", "≥"}, {"+-", "±"}, {"-+", "∓"}};
        if (const auto sign = signs.find(text_.substr(at_, 2)); sign != signs.end()) {
            out_ += sign->second;
            at_ += 2;
        } else if (text_.compare(at_, 3, " - ") == 0) {
            out_ += " − ";
            at_ += 3;
        } else {
            out_ += html_text(text_.substr(at_, 1));
            ++at_;
        }
    }

    const std::string& text_;
    std::size_t at_ = 0;
    std::string out_;
};

}  // namespace

std::string html_mathematics(const std::string& text) { return formula_reader(text).read(); }

}  // namespace libration
