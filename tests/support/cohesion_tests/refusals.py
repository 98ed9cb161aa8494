# SPDX-License-Identifier: BSD-3-Clause
"""What is asked of a program that refuses its input: it ends by itself, says what is wrong, where and what would be
right, and has computed nothing."""


def assert_says(test, text, *parts):
    """`text`, with line breaks as blanks, has all `parts`."""
    said = " ".join(text.split())
    for part in parts:
        if " ".join(part.split()) not in said:
            test.fail(f"not said: '{part}', but:\n{text[-3000:]}")


def errors(output):
    """The lines in which an engine says what is wrong."""
    return " ".join(line for line in output.splitlines() if "ERROR" in line)


def assert_refused(test, code, output, *parts, begun=False):
    """An engine ended with an error that has all `parts`, before the first of its runs had ended unless it has
    `begun`. Both engines end orderly with code 1, also through MPI_Abort: a signal would be a crash."""
    test.assertEqual(code, 1, "accepted, or a crash:\n" + output[-3000:])
    assert_says(test, errors(output), *parts)
    if not begun:
        test.assertNotIn("Loop time", output)
