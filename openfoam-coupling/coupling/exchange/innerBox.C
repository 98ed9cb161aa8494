// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshCells.H"

#include <limits>

using namespace cohesion;

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

} // End anonymous namespace


void_fraction::Box Foam::meshCells::innerBox(const label celli) const
{
    // A face lies in the hull of its corners. Where these are beyond one side of the box, it does not cut the box,
    // which is in the cell as a whole where its middle is.
    constexpr scalar off = 1e-9;
    boundBox inner(point::uniform(-infinity), point::uniform(infinity));
    for (const label facei : mesh_.cells()[celli])
    {
        const vector out = (mesh_.faceOwner()[facei] == celli ? 1 : -1)*mesh_.faceAreas()[facei];
        direction d = 0;
        for (direction other = 1; other < 3; ++other)
        {
            d = mag(out[other]) > mag(out[d]) ? other : d;
        }
        for (const label pointi : mesh_.faces()[facei])
        {
            const scalar at = mesh_.points()[pointi][d];
            out[d] > 0 ? inner.max()[d] = min(inner.max()[d], at) : inner.min()[d] = max(inner.min()[d], at);
        }
    }
    bool some = true;
    for (direction d = 0; d < 3; ++d)
    {
        // Comparisons first: the difference of infinite ends is no number.
        some = some && inner.min()[d] > -infinity && inner.max()[d] < infinity && inner.min()[d] < inner.max()[d];
        const scalar border = some ? off*(inner.max()[d] - inner.min()[d]) : 0;
        inner.min()[d] += border;
        inner.max()[d] -= border;
    }
    if (!some || !mesh_.pointInCell(0.5*(inner.min() + inner.max()), celli, decomposition_))
    {
        return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    }
    for (direction d = 0; d < 3; ++d)
    {
        if (mesh_.geometricD()[d] < 0)
        {
            inner.min()[d] = -infinity;
            inner.max()[d] = infinity;
        }
    }
    const point& low = inner.min();
    const point& high = inner.max();
    return {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}};
}
