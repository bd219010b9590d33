// The two families of relative functions: what remains of a function after some terms, divided by the next one.
#pragma once

namespace libration {

/// Of exp(x), and of cos(x) or sin(x).
enum class relative_kind { exponential, cosine };

}  // namespace libration
