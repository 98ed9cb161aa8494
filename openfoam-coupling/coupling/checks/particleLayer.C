// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleLayer.H"

#include "fvMesh.H"
#include "mathematicalConstants.H"

#include "sphere.h"

#include "coupling/particles/coupledParticles.H"


Foam::particleLayer::particleLayer(const fvMesh& mesh, const coupledParticles& particles)
{
    const vector up = -particles.g()/mag(particles.g());
    const scalarField heights(particles.positions() & up);
    const UList<scalar> radii(particles.radii());
    // Sums of the solid's volume, with powers of the height; of an even layer of the sphere's diameter the mean square
    // is a twelfth of its own above that of its middle.
    vector sums(Zero);
    forAll(radii, i)
    {
        sums +=
            cohesion::sphere_volume(radii[i])
           *vector(1, heights[i], sqr(heights[i]) + sqr(2*radii[i])/12);
    }
    reduce(sums, sumOp<vector>());
    count = returnReduce(radii.size(), sumOp<label>());
    solid = sums[0];
    diameter = Foam::cbrt(6*solid/(constant::mathematical::pi*max(count, 1)));
    height = solid > 0 ? Foam::sqrt(12*max(sums[2]/solid - sqr(sums[1]/solid), scalar(0))) : 0;

    const scalarField corners(mesh.points() & up);
    vessel = gMax(corners) - gMin(corners);
    base = gSum(mesh.V())*particles.depthRatio()/vessel;
    if (!(height > 0))
    {
        return;
    }
    // Volume of the mesh within the layer: of each cell the share of its height that is in the layer, as if its
    // cross-section were constant.
    const scalar bottom = sums[1]/solid - 0.5*height, top = bottom + height;
    scalar volumeInLayer = 0;
    forAll(mesh.V(), cell)
    {
        const scalarMinMax ends(minMax(scalarField(corners, mesh.cells()[cell].labels(mesh.faces()))));
        volumeInLayer +=
            mesh.V()[cell]*max(min(top, ends.max()) - max(bottom, ends.min()), scalar(0))/ends.mag();
    }
    reduce(volumeInLayer, sumOp<scalar>());
    const scalar heightInMesh = min(top, gMax(corners)) - max(bottom, gMin(corners));
    base = volumeInLayer*particles.depthRatio()/heightInMesh;
}
