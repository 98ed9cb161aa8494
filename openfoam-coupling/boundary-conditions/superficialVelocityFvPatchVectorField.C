// SPDX-License-Identifier: GPL-3.0-or-later
#include "superficialVelocityFvPatchVectorField.H"

#include "addToRunTimeSelectionTable.H"
#include "fvPatchFieldMapper.H"
#include "volFields.H"

#include "coupling/input/knownEntries.H"

namespace
{

const Foam::Keywords words
{
    {"superficialVelocity"}, {"share"}, {"voidFraction"}, {"value"}, {"type"}, {"patchType"},
    {"superficialVelocityCoeffs"}
};


//- Warns of entries that nothing reads. A function of time may have its entries beside its name.
void warnOfUnknown(const Foam::dictionary& dict)
{
    const bool apart = dict.isDict("superficialVelocity");
    const bool named = !apart && dict.lookup("superficialVelocity")[0].isWord();
    if (!named)
    {
        warnOfUnknownEntries(dict, words);
    }
    else
    {
        warnOfMisspeltEntries(dict, words);
    }
}

} // End anonymous namespace


Foam::superficialVelocityFvPatchVectorField::superficialVelocityFvPatchVectorField
(
    const fvPatch& patch,
    const DimensionedField<vector, volMesh>& field
)
:
    fixedValueFvPatchVectorField(patch, field),
    share_(1),
    voidFractionName_("voidFraction")
{}


Foam::superficialVelocityFvPatchVectorField::superficialVelocityFvPatchVectorField
(
    const fvPatch& patch,
    const DimensionedField<vector, volMesh>& field,
    const dictionary& dict
)
:
    fixedValueFvPatchVectorField(patch, field, dict, false),
    superficialVelocity_(Function1<vector>::New("superficialVelocity", dict)),
    share_(dict.getOrDefault<scalar>("share", 1)),
    voidFractionName_(dict.getOrDefault<word>("voidFraction", "voidFraction"))
{
    if (!(share_ > 0 && share_ <= 1))
    {
        FatalIOErrorInFunction(dict)
            << "share = " << share_ << ": must lie above 0 and be at most 1"
            << exit(FatalIOError);
    }
    warnOfUnknown(dict);
    // The void fraction is not known yet; the first step sets the value. One that has been written is taken for a
    // gradient before that.
    if (dict.found("value"))
    {
        fvPatchVectorField::operator=(vectorField("value", dict, patch.size()));
    }
    else
    {
        fvPatchVectorField::operator=(patchInternalField());
    }
}


Foam::superficialVelocityFvPatchVectorField::superficialVelocityFvPatchVectorField
(
    const superficialVelocityFvPatchVectorField& other,
    const fvPatch& patch,
    const DimensionedField<vector, volMesh>& field,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchVectorField(other, patch, field, mapper),
    superficialVelocity_(other.superficialVelocity_.clone()),
    share_(other.share_),
    voidFractionName_(other.voidFractionName_)
{}


Foam::superficialVelocityFvPatchVectorField::superficialVelocityFvPatchVectorField
(
    const superficialVelocityFvPatchVectorField& other,
    const DimensionedField<vector, volMesh>& field
)
:
    fixedValueFvPatchVectorField(other, field),
    superficialVelocity_(other.superficialVelocity_.clone()),
    share_(other.share_),
    voidFractionName_(other.voidFractionName_)
{}


void Foam::superficialVelocityFvPatchVectorField::requireVoidFraction() const
{
    if (!db().foundObject<volScalarField>(voidFractionName_))
    {
        FatalErrorInFunction
            << "patch " << patch().name() << " of " << internalField().objectPath().c_str() << ": voidFraction is "
            << voidFractionName_ << ", and there is no field of that name" << nl
            << "    Remove the entry: the field of cohesiveBedFoam is called voidFraction" << exit(FatalError);
    }
}


void Foam::superficialVelocityFvPatchVectorField::updateCoeffs()
{
    if (updated())
    {
        return;
    }
    const auto& voidFraction =
        patch().lookupPatchField<volScalarField, scalar>(voidFractionName_);
    operator==((1/(share_*voidFraction))*velocity());
    fixedValueFvPatchVectorField::updateCoeffs();
}


void Foam::superficialVelocityFvPatchVectorField::write(Ostream& os) const
{
    fvPatchVectorField::write(os);
    superficialVelocity_->writeData(os);
    os.writeEntryIfDifferent<scalar>("share", 1, share_);
    os.writeEntryIfDifferent<word>("voidFraction", "voidFraction", voidFractionName_);
    writeEntry("value", os);
}


namespace Foam
{
    makePatchTypeField(fvPatchVectorField, superficialVelocityFvPatchVectorField);
}
