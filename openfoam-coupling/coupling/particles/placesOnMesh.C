// SPDX-License-Identifier: GPL-3.0-or-later
#include "placesOnMesh.H"


Foam::placesOnMesh::placesOnMesh(const polyMesh& mesh, const cohesion::coupling::DemEngine::SimulationBox& box)
:
    within_(point::min, point::max)
{
    // No particle is on the outermost faces, which round-off may take for outside.
    constexpr scalar inside = 1e-6;
    const boundBox& bounds = mesh.bounds();
    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.geometricD()[d] < 0 && box.periodic[d])
        {
            endless_ = true;
            within_.min()[d] = bounds.min()[d] + inside*bounds.span()[d];
            within_.max()[d] = bounds.max()[d] - inside*bounds.span()[d];
        }
    }
}


Foam::UList<Foam::point> Foam::placesOnMesh::operator()(const UList<point>& positions)
{
    if (!endless_)
    {
        return positions;
    }
    moved_ = pointField(positions);
    for (point& at : moved_)
    {
        for (direction d = 0; d < 3; ++d)
        {
            // What is no number stays none.
            if (at[d] < within_.min()[d])
            {
                at[d] = within_.min()[d];
            }
            else if (at[d] > within_.max()[d])
            {
                at[d] = within_.max()[d];
            }
        }
    }
    return moved_;
}
