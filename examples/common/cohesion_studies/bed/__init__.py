# SPDX-License-Identifier: BSD-3-Clause
"""The fluidised bed (examples/fluidised-bed) as a case with parameters, and what is read of it: for the studies of it
and of its cohesion."""
