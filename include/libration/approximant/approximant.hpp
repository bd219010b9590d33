// Approximants computed from a series: partial sums, endpoint and Pade approximants, and the norms of their errors.
#pragma once

#include "libration/approximant/difference_norm.hpp"
#include "libration/approximant/endpoint_approximant.hpp"
#include "libration/approximant/pade.hpp"
#include "libration/approximant/truncated_series.hpp"
