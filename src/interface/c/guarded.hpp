// The boundary of the C interface: exceptions become codes, arguments are checked, the progress callback is called.
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

/// Thrown if the progress callback cancels the call.
class cancelled : public std::exception {
public:
    const char* what() const noexcept override { return "the call was cancelled"; }
};

/// Runs work() in the proof thread of this thread, starting with the same precision in every call, and returns its
/// code. An exception, and a failure inside FLINT, become a code and the error of this thread.
int guarded(const call_view<void>& work) noexcept;

/// The same in the thread of the caller, for work that proves nothing and allocates no memory through GMP.
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

/// Runs make(), stores its result in a handle of the caller, and returns the code.
template <class T, class Make>
int made(T** handle, const Make& make) noexcept {
    return guarded([&] {
        given(handle, "the pointer to the result");
        *handle = std::make_unique<T>(make()).release();
    });
}

/// Whether an optional text is given.
inline bool is_given(const char* text) { return text != nullptr && *text != 0; }

/// Whether the rigour is PROVED, not ROUNDED; throws error of the kind argument for another number.
bool asks_proof(int rigour);

/// Throws error of the kind argument for negative powers, an empty range, or more than a million.
void require_powers(long first, long last);

/// The items of a list, without surrounding blanks; throws error for an empty item, and for an empty list.
std::vector<std::string> items_of(const std::string& list, const char* name);

/// "name = value" between semicolons, in the order given; empty parts are left out. Throws error of this subject if =
/// is missing.
std::vector<std::pair<std::string, std::string>> settings_of(const std::string& text, const char* subject);

/// Without surrounding blanks.
std::string trimmed(std::string_view text);

/// Calls the progress callback, in the thread of the caller, with the part that is done; throws cancelled.
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
