// SPDX-License-Identifier: GPL-3.0-or-later
// Foam::dictionary::digest(), by which OpenFOAM sees that an entry of `functions` has changed.
//
// Up to v2106 it writes into a stream buffer that takes strings and no single characters. The
// standard library of g++ since 12 writes those one by one: OpenFOAM that was compiled with it, as in
// Debian 13, stops at the first function object with an error in IOstream "sha1". The dynamic linker
// finds the definition here before that of libOpenFOAM.

#include "OStringStream.H"
#include "SHA1.H"
#include "dictionary.H"


Foam::SHA1Digest Foam::dictionary::digest() const
{
    OStringStream entries;
    for (const entry& e : *this)
    {
        entries << e;
    }
    return SHA1(entries.str()).digest();
}
