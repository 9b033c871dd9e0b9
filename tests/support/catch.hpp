// SPDX-License-Identifier: MIT
#pragma once

// The one place that knows which Catch2 we have.
#include <catch2/catch.hpp>
