#include "table/complex_argument.hpp"

#include "libration/number/written_number.hpp"

namespace libration {

bool is_complex_text(const std::string& text) {
    return text.ends_with('i') && (!text.ends_with("pi") || text.ends_with("*i"));
}

complex_argument read_complex(const std::string& item) {
    if (!is_complex_text(item)) {
        return {read_exact(item), std::nullopt};
    }
    std::string text = item.substr(0, item.size() - (item.ends_with("*i") ? 2 : 1));
    std::size_t at = text.find_last_of("+-");
    while (at != std::string::npos && at > 0 && (text[at - 1] == 'e' || text[at - 1] == 'E')) {
        at = text.find_last_of("+-", at - 1);
    }
    at = at == std::string::npos ? 0 : at;
    std::string imaginary = text.substr(at);
    imaginary += imaginary.empty() || imaginary == "+" || imaginary == "-" ? "1" : "";
    return {at == 0 ? exactly(0) : read_exact(text.substr(0, at)),
            read_exact(imaginary.starts_with('+') ? imaginary.substr(1) : imaginary)};
}

std::string complex_argument_text(const std::string& real, const std::string& imaginary) {
    const bool negative = imaginary.starts_with('-');
    const std::string size = imaginary.substr(negative || imaginary.starts_with('+') ? 1 : 0);
    // A sum has a sign other than that of an exponent.
    bool sum = false;
    for (std::size_t i = 0; i < size.size(); ++i) {
        const bool sign = size[i] == '+' || size[i] == '-';
        sum = sum || (sign && (i == 0 || (size[i - 1] != 'e' && size[i - 1] != 'E')));
    }
    return sum ? real + "+(" + imaginary + ")*i" : real + (negative ? "-" : "+") + size + "i";
}

bool takes_complex(const elliptic::named_function& function) {
    return function.argument == "u" && function.name != "am";
}

}  // namespace libration
