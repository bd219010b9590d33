// The progress callback of searches and proofs in the complex plane.
#pragma once

#include <functional>

namespace libration::ode {

/// A step of such work: an expansion point of a search in double precision, or a disc of a proof.
enum class plane_step { point, disc };

/// Called after each step, or for each singularity that is refined; it may throw an error of the kind undecided to end
/// the work.
using plane_watch = std::function<void(plane_step step)>;

}  // namespace libration::ode
