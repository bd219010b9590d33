#include "guarded.hpp"

#include <algorithm>
#include <new>

#include "libration/digits/memory_need.hpp"
#include "libration/scalar/ball/quotient.hpp"
#include "libration/scalar/list_items.hpp"
#include "libration/scalar/supplied_quotient.hpp"

namespace libration::c {

namespace {

// For all calls: whole sequences of mpfr numbers are divided by FLINT, as in the command.
const whole_quotient_scope by_whole_sequences(quotient_by_flint);

struct last_error {
    std::string message, subject, value, reason;
};

last_error& error_here() {
    thread_local last_error kept;
    return kept;
}

// The part of a message that can be kept without memory: texts this short need none.
void keep_message(last_error& kept, const char* message) noexcept {
    for (std::string* text : {&kept.message, &kept.subject, &kept.value, &kept.reason}) {
        text->clear();
    }
    constexpr std::size_t always = 15;
    kept.message.append(message, std::min(std::string_view(message).size(), std::max(always, kept.message.capacity())));
}

int keep(last_error& kept, int code, const char* message) noexcept {
    try {
        kept = {message, "", "", message};
    } catch (const std::bad_alloc&) {
        keep_message(kept, message);
    }
    return code;
}

int keep(last_error& kept, int code, const error& problem) noexcept {
    try {
        kept = {problem.what(), problem.subject(), problem.value(), problem.reason()};
    } catch (const std::bad_alloc&) {
        keep_message(kept, problem.what());
    }
    return code;
}

int code_of(error_kind kind) {
    switch (kind) {
        case error_kind::argument: return LIBRATION_ARGUMENT;
        case error_kind::range: return LIBRATION_RANGE;
        case error_kind::undecided: break;
    }
    return LIBRATION_UNDECIDED;
}

// The code of the exception that is being handled.
int code_of_exception(last_error& kept) noexcept {
    try {
        throw;
    } catch (const cancelled& problem) {
        return keep(kept, LIBRATION_CANCELLED, problem.what());
    } catch (const error& problem) {
        return keep(kept, code_of(problem.kind()), problem);
    } catch (const memory_shortage& problem) {
        return keep(kept, LIBRATION_NO_MEMORY, problem.what());
    } catch (const std::bad_alloc&) {
        return keep(kept, LIBRATION_NO_MEMORY, "no memory");
    } catch (const std::exception& problem) {
        return keep(kept, LIBRATION_FAULT, problem.what());
    } catch (...) {
        return keep(kept, LIBRATION_FAULT, "unknown failure");
    }
}

// Works with the precision with which every call starts.
int code_of(const call_view<void>& work, last_error& kept) noexcept {
    try {
        constexpr long usual_digits = 50;
        const precision_scope digits(usual_digits);
        work();
        return LIBRATION_OK;
    } catch (...) {
        return code_of_exception(kept);
    }
}

}  // namespace

int guarded(const call_view<void>& work) noexcept {
    last_error& kept = error_here();
    int code = LIBRATION_OK;
    const auto with_code = [&] {
        code = code_of(work, kept);
        return code != LIBRATION_NO_MEMORY && code != LIBRATION_FAULT;
    };
    switch (in_proof_thread(with_code)) {
        case call_ending::finished: break;
        case call_ending::no_memory: return keep(kept, LIBRATION_NO_MEMORY, "no memory");
        case call_ending::flint_failure: return keep(kept, LIBRATION_FAULT, "FLINT aborted; its message is on stderr");
        case call_ending::no_thread: return keep(kept, LIBRATION_NO_MEMORY, "no memory for a thread");
    }
    return code;
}

int guarded_here(const call_view<void>& work) noexcept { return code_of(work, error_here()); }

void watcher::operator()(double part) const {
    if (watch_ == nullptr) {
        return;
    }
    int answer = 0;
    std::exception_ptr thrown;
    in_calling_thread([&] {
        try {
            answer = watch_(part, context_);
        } catch (...) {
            thrown = std::current_exception();
        }
    });
    if (thrown) {
        std::rethrow_exception(thrown);
    }
    if (answer != 0) {
        throw cancelled();
    }
}

void require_powers(long first, long last) {
    constexpr long most_rows = 1'000'001;
    if (first < 0 || last < first || last - first >= most_rows) {
        throw error(error_kind::argument, "powers", std::to_string(first) + " .. " + std::to_string(last),
                    "are not a range of powers from 0 on, at most a million of them");
    }
}

bool asks_proof(int rigour) {
    if (rigour != LIBRATION_ROUNDED && rigour != LIBRATION_PROVED) {
        throw error(error_kind::argument, "rigour", std::to_string(rigour),
                    "is neither LIBRATION_ROUNDED nor LIBRATION_PROVED");
    }
    return rigour == LIBRATION_PROVED;
}

std::string trimmed(std::string_view text) { return std::string(without_blanks(text)); }

std::vector<std::string> items_of(const std::string& list, const char* name) {
    std::vector<std::string> items;
    for (const std::string_view each : list_items(list)) {
        items.emplace_back(each);
        if (items.back().empty()) {
            throw error(error_kind::argument, name, list, "has an empty item");
        }
    }
    return items;
}

std::vector<std::pair<std::string, std::string>> settings_of(const std::string& text, const char* subject) {
    std::vector<std::pair<std::string, std::string>> settings;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(';', begin), text.size());
        const std::string part = trimmed(std::string_view(text).substr(begin, end - begin));
        begin = end + 1;
        if (part.empty()) {
            continue;
        }
        const std::size_t sign = part.find('=');
        if (sign == std::string::npos) {
            throw error(error_kind::argument, subject, part, "has no =");
        }
        settings.emplace_back(trimmed(part.substr(0, sign)), trimmed(part.substr(sign + 1)));
    }
    return settings;
}

}  // namespace libration::c

using libration::c::error_here;

const char* libration_version(void) { return LIBRATION_VERSION; }
const char* libration_error_message(void) { return error_here().message.c_str(); }
const char* libration_error_subject(void) { return error_here().subject.c_str(); }
const char* libration_error_value(void) { return error_here().value.c_str(); }
const char* libration_error_reason(void) { return error_here().reason.c_str(); }
