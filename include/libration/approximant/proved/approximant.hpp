// Rigorous maxima of the errors of approximants.
#pragma once

#include "libration/approximant/approximant.hpp"
#include "libration/approximant/proved/maximum.hpp"
#include "libration/approximant/proved/panel.hpp"
