// Texts of certificates with the progress of the current run.
#pragma once

#include <string>

#include "../query/certificate/certificate.hpp"
#include "libration/problem/answer.hpp"
#include "libration/problem/certificate.hpp"

namespace libration {

/// ode::certificate_of, with the fraction of the farthest time as progress.
std::string text_of_certificate(const ode::explicit_system& system, const ode::certified_statement& statement,
                                const rational& farthest, long digits, const request& how);

/// The content of the file, with notes in lines after its first one: of each its printable characters of ASCII, others as ?.
std::string compressed_certificate(const std::string& text, const certificate_notes& notes);

}  // namespace libration
