#include "complex_times.hpp"

#include <cctype>
#include <cstddef>

#include "libration/equation/text/parse.hpp"
#include "libration/number/grid.hpp"
#include "libration/scalar/error.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr const char* remedy_of_points = "write points such as 0,1+2i,-i*pi/3 or a range 0:2+i:11";

std::vector<std::string> items_between(const std::string& text, char separator) {
    std::vector<std::string> parts{""};
    for (const char c : text) {
        if (c == separator) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

ode::complex_constant point_in(const std::string& option, const std::string& text) {
    return reading(option, text, remedy_of_points, [&] { return ode::parse_complex_constant(text); });
}

// As it would be typed: 1/2+3/4i would not be read as a fraction of i, hence fractions of the imaginary part come
// first.
std::string typed_text(const rational& re, const rational& im) {
    std::string real = re.str();
    if (im == 0) {
        return real;
    }
    const rational size = abs(im);
    const std::string imaginary = size == 1 ? "i" : denominator(size) == 1 ? size.str() + "i" : size.str() + "*i";
    return (re == 0 ? (im < 0 ? "-" : "") : real + (im < 0 ? "-" : "+")) + imaginary;
}

typed_point between(const typed_point& first, const typed_point& last, const rational& part, const std::string& range) {
    if (part == 0 || part == 1) {
        return part == 0 ? first : last;
    }
    const ode::number along{part};
    const auto on = [&](const ode::number& a, const ode::number& b) { return a + along * (b - a); };
    const ode::complex_constant value{on(first.value.re, last.value.re), on(first.value.im, last.value.im)};
    const auto re = value.re.fraction();
    const auto im = value.im.fraction();
    return {value, re && im ? typed_text(*re, *im) : part.str() + " of " + range};
}

}  // namespace

bool has_imaginary_unit(const std::string& words) {
    const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    for (std::size_t i = 0; i < words.size();) {
        std::size_t end = i;
        while (end < words.size() && is_letter(words[end])) {
            ++end;
        }
        if (end == i + 1 && words[i] == 'i') {
            return true;
        }
        i = end + (end == i ? 1 : 0);
    }
    return false;
}

std::vector<typed_point> complex_points(const std::string& option, const std::string& words) {
    std::vector<typed_point> points;
    for (const std::string& item : items_between(words, ',')) {
        const auto parts = items_between(item, ':');
        if (parts.size() == 1) {
            points.push_back({point_in(option, item), item});
            continue;
        }
        if (parts.size() != 3) {
            throw input_error(option, item, "is not a range a:b:count", remedy_of_points);
        }
        const typed_point first{point_in(option, parts[0]), parts[0]};
        const typed_point last{point_in(option, parts[1]), parts[1]};
        const int count = reading(option, item, remedy_of_points,
                                  [&] { return read_count(parts[2], static_cast<int>(most_grid_values)); });
        if (count < 1) {
            throw input_error(option, item, "has the count 0", remedy_of_points);
        }
        for (int i = 0; i < count; ++i) {
            points.push_back(between(first, last, count == 1 ? rational(0) : rational(i, count - 1), item));
        }
    }
    return points;
}

std::vector<ode::complex_constant> corners_of(const std::optional<std::string>& via) {
    std::vector<ode::complex_constant> corners;
    if (via) {
        for (const typed_point& each : complex_points("--via", *via)) {
            corners.push_back(each.value);
        }
    }
    return corners;
}

}  // namespace libration
