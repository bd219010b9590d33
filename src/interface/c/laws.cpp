// The law of all Taylor coefficients of a solution.
#include <functional>
#include <memory>
#include <mutex>

#include "answers.hpp"
#include "guarded.hpp"
#include "libration/number/given_number.hpp"

namespace libration::c {

namespace {

// The code of a question to the law, of one thread at a time. After a failure the law may be in any state: it is left
// to the process.
template <class T, class Question>
int asked(const libration_law* law, T** to, const Question& question) noexcept {
    if (law == nullptr) {
        return guarded([&] { given(law, "law"); });
    }
    const std::scoped_lock lock(*law->guard);
    const int code = made(to, [&] {
        if (!law->of) {
            throw error(error_kind::argument, "law", "", "was lost in a call that failed: make it again");
        }
        return question(*law->of);
    });
    if (code == LIBRATION_NO_MEMORY || code == LIBRATION_FAULT) {
        static_cast<void>(const_cast<libration_law*>(law)->of.release());
    }
    return code;
}

libration_number number_of(const known_value& value, const char* name, long n) {
    if (!value.decimal) {
        throw error(
            error_kind::undecided, name, std::to_string(n),
            "has no digit that is proved" + (value.bound.empty() ? "" : ": its size is at most " + value.bound));
    }
    return proved_number(*value.decimal);
}

}  // namespace

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

int libration_law_new(const libration_problem* problem, const char* show, const char* within, libration_watch watch,
                      void* context, libration_law** law) {
    return made(law, [&] {
        constexpr long digits_of_search = 30;
        law_question asked;
        asked.show = is_given(show) ? show : "";
        if (is_given(within)) {
            asked.within = given_number("within", within);
            if (!asked.within->is_number() || sign_of_exact(*asked.within) <= 0) {
                throw error(error_kind::argument, "within", within, "is not a positive number");
            }
        }
        request how = proved_digits(digits_of_search);
        // The law calls again when it needs more bits, when the context may not exist any more.
        const auto called = std::make_shared<std::function<void(double)>>(watcher(watch, context));
        how.stage = [called](const std::string& /*done*/) {
            if (*called) {
                (*called)(0.0);
            }
        };
        libration_law result{std::make_unique<proved_law>(given(problem, "problem").system(), asked, how)};
        *called = {};
        result.rho = result.of->rho();
        result.first = result.of->first();
        result.stride = result.of->stride();
        result.residue = result.of->residue();
        return result;
    });
}

double libration_law_rho(const libration_law* law) { return law != nullptr ? law->rho : 0; }
long libration_law_first(const libration_law* law) { return law != nullptr ? law->first : 0; }
long libration_law_stride(const libration_law* law) { return law != nullptr ? law->stride : 0; }
long libration_law_residue(const libration_law* law) { return law != nullptr ? law->residue : 0; }

int libration_law_singularities(const libration_law* law, long digits, libration_table** singularities) {
    return asked(law, singularities, [&](const proved_law& of) {
        constexpr std::size_t columns = 7;
        const answer found = of.singularities(given_digits(digits));
        libration_table table{{found.names.begin(), found.names.begin() + columns}, {}};
        for (const auto& row : found.rows) {
            if (row[3].text == "none") {
                continue;
            }
            for (std::size_t i = 0; i < columns; ++i) {
                if (row[i].kind == value_kind::text) {
                    table.add(row[i].text);
                } else {
                    table.add(
                        libration_number{row[i].text.empty() ? "0" : row[i].text, row[i].bound, LIBRATION_PROVED});
                }
            }
        }
        return table;
    });
}

int libration_law_coefficient(const libration_law* law, long n, long digits, libration_number** coefficient) {
    return asked(law, coefficient, [&](const proved_law& of) {
        require_powers(n, n);
        return number_of(of.coefficient(n, given_digits(digits)).value, "coefficient", n);
    });
}

int libration_law_ratio(const libration_law* law, long n, long digits, libration_number** ratio) {
    return asked(law, ratio, [&](const proved_law& of) {
        require_powers(n, n);
        return number_of(of.ratio(n, given_digits(digits)).ratio, "ratio", n);
    });
}

int libration_law_words(const libration_law* law, libration_table** words) {
    return asked(law, words, [&](const proved_law& of) {
        constexpr long usual_digits = 15;
        libration_table table{{"name", "text"}, {}};
        for (const answer_note& each : of.singularities(usual_digits).notes) {
            table.add(each.name);
            table.add(each.text);
        }
        return table;
    });
}

// In the thread of proofs, as its numbers were made there.
void libration_law_free(libration_law* law) {
    static_cast<void>(guarded([&] { delete law; }));
}
