// SPDX-License-Identifier: BSD-3-Clause
// Nothing: CMake compiles precompiled headers for targets with a source only.
