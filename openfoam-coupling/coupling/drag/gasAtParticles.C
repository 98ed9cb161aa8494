// SPDX-License-Identifier: GPL-3.0-or-later
#include "gasAtParticles.H"

#include "interpolationCellPoint.H"

#include "coupling/input/selectRow.H"

#include <array>

namespace
{

struct Slip
{
    std::string_view name;
    bool interpolated;
};

constexpr std::array slips{Slip{"cell", false}, Slip{"interpolated", true}};

//- Whether the boundary's values are the case's, and not those that periodic, mirrored or flat meshes make
bool given(const Foam::fvPatch& patch)
{
    return !patch.coupled() && !Foam::fvPatch::constraintType(patch.type());
}

//- A copy, not registered, whose values at the boundary are its own
template<class Type>
Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh> freeCopy
(
    const Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>& field
)
{
    using namespace Foam;
    return GeometricField<Type, fvPatchField, volMesh>
    (
        IOobject(field.name() + "Beside", field.instance(), field.db(), IOobject::NO_READ, IOobject::NO_WRITE, false),
        field,
        fvPatchField<Type>::calculatedType()
    );
}

//- The void fraction, at the boundary that of the cell at it
Foam::volScalarField voidFractionBeside(const Foam::volScalarField& voidFraction)
{
    using namespace Foam;
    volScalarField beside(freeCopy(voidFraction));
    forAll(beside.boundaryField(), patchi)
    {
        fvPatchScalarField& values = beside.boundaryFieldRef()[patchi];
        if (given(values.patch()))
        {
            values == values.patchInternalField();
        }
    }
    return beside;
}

//- The gas velocity between the particles: at the boundary that of the cell along it, and across it that of the flux
//  through it in the cell's void fraction
Foam::volVectorField velocityBeside(const Foam::volScalarField& voidFraction, const Foam::volVectorField& U)
{
    using namespace Foam;
    volVectorField beside(freeCopy(U));
    forAll(beside.boundaryField(), patchi)
    {
        fvPatchVectorField& values = beside.boundaryFieldRef()[patchi];
        if (given(values.patch()))
        {
            const fvPatchScalarField& ofPatch = voidFraction.boundaryField()[patchi];
            const vectorField n(values.patch().nf());
            const vectorField inside(values.patchInternalField());
            const scalarField across((n & values)*ofPatch/ofPatch.patchInternalField());
            values == inside + n*(across - (n & inside));
        }
    }
    return beside;
}

} // End anonymous namespace


Foam::gasAtParticles::gasAtParticles(const dictionary& dict)
:
    interpolated_(selectRow(dict, "slip", slips, "cell").interpolated)
{}


void Foam::gasAtParticles::interpolate
(
    const volScalarField& voidFraction,
    const volVectorField& U,
    const particleExchange& exchange
)
{
    const volScalarField besideVoidFraction(voidFractionBeside(voidFraction));
    const volVectorField besideU(velocityBeside(voidFraction, U));
    const interpolationCellPoint<scalar> voidFractionAt(besideVoidFraction);
    const interpolationCellPoint<vector> velocityAt(besideU);
    const labelList& cells = exchange.cells();
    const List<point>& positions = exchange.positions();
    scalarList voidFractions(cells.size(), Zero);
    List<vector> velocities(cells.size(), Zero);
    forAll(cells, k)
    {
        if (cells[k] >= 0)
        {
            // A mean of numbers up to 1 with weights that add up to 1 only to round-off
            voidFractions[k] = min(voidFractionAt.interpolate(positions[k], cells[k]), scalar(1));
            velocities[k] = velocityAt.interpolate(positions[k], cells[k]);
        }
    }
    voidFraction_ = exchange.sumParts(std::move(voidFractions));
    velocity_ = exchange.sumParts(std::move(velocities));
}


void Foam::gasAtParticles::set
(
    const volScalarField& voidFraction,
    const volVectorField& U,
    particleAveraging& averaging
)
{
    voidFraction_ = averaging.gather(voidFraction.primitiveField());
    velocity_ = averaging.gather(U.primitiveField());
    offset_.setSize(velocity_.size());
    offset_ = Zero;
    if (interpolated_)
    {
        const vectorField gathered(velocity_);
        interpolate(voidFraction, U, averaging.exchange());
        offset_ = velocity_ - gathered;
    }
}
