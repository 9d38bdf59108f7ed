// SPDX-License-Identifier: Apache-2.0
// Nothing but the headers that the tests share: CMake precompiles headers for a target whose source uses them, and
// main.cpp cannot.
