// The border of the C interface: exceptions become codes, arguments are looked at, a watch is heard.
#pragma once

#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "handles.hpp"
#include "libration/scalar/ball/proof_thread.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/precision_scope.hpp"

namespace libration::c {

/// Thrown where a watch wants to stop.
class cancelled : public std::exception {
public:
    const char* what() const noexcept override { return "the call was cancelled"; }
};

/// The code of what work() does in the proof thread of this thread, where it begins with the same precision in every
/// call. An exception, and a failure below FLINT, become a code and the error of this thread.
int guarded(const call_view<void>& work) noexcept;

/// The same in the thread of the caller, for work that proves nothing and allocates nothing below GMP.
int guarded_here(const call_view<void>& work) noexcept;

/// Throws error of the kind argument for NULL.
template <class T>
const T& given(const T* argument, const char* name) {
    if (argument == nullptr) {
        throw error(error_kind::argument, name, "", "is NULL");
    }
    return *argument;
}

/// The text of an argument; throws as given().
inline std::string text_of(const char* text, const char* name) { return &given(text, name); }

/// The code of make(), whose result goes to a handle of the caller.
template <class T, class Make>
int made(T** handle, const Make& make) noexcept {
    return guarded([&] {
        given(handle, "the place for the result");
        *handle = std::make_unique<T>(make()).release();
    });
}

/// Whether a text that may be left out is there.
inline bool is_given(const char* text) { return text != nullptr && *text != 0; }

/// ROUNDED or PROVED; throws error of the kind argument for another number.
bool asks_proof(int rigour);

/// Throws error of the kind argument for powers below 0, none, or more than a million.
void require_powers(long first, long last);

/// The items of a list, without blanks around; throws error for one that is empty, and for an empty list.
std::vector<std::string> items_of(const std::string& list, const char* name);

/// "name = value" between semicolons, in the order given; empty parts are left out. Throws error of this subject where
/// there is no =.
std::vector<std::pair<std::string, std::string>> settings_of(const std::string& text, const char* subject);

/// Without blanks around.
std::string trimmed(std::string_view text);

/// Calls a watch, in the thread of the caller, with how much is done; throws cancelled.
class watcher {
public:
    watcher(libration_watch watch, void* context) : watch_(watch), context_(context) {}
    void operator()(double part) const;
    void operator()(std::size_t done, std::size_t all) const {
        (*this)(static_cast<double>(done) / static_cast<double>(all));
    }

private:
    libration_watch watch_;
    void* context_;
};

}  // namespace libration::c
