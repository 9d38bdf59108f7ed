// SPDX-License-Identifier: Apache-2.0
// The one place that knows which Catch2 is installed: v2 on Debian 12, v3 elsewhere.
#pragma once
#ifdef MILLWRIGHT_CATCH2_V3
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif
