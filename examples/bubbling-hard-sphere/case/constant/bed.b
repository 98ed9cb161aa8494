// Bed (b) of Hoomans et al. (1996): a jet in the middle of a bed at minimum fluidisation.
width       0.15;       // [m]
height      1;          // twice that of Hoomans et al.: gas holds what it carries to the outlet there [m]
// From front to back 3.75e-3 m: a packing of area fraction 0.83 has a void fraction of 0.41 in it.
back        -1.875e-3;
front       1.875e-3;
jetFrom     0.07;       // one cell of the plate [m]
jetTo       0.08;       // [m]
sideCells   7;          // on each side of the jet
jetCells    1;
cellsUp     50;
jet         18;         // superficial velocity [m/s]
background  1.8;        // the same beside the jet [m/s]
jetGas      constant (0 $jet 0);          // gas at the jet against time
plateGas    constant (0 $background 0);   // the same beside the jet
plateVoid   1;          // void fraction at jet and plate
middle      0.075;      // of the width [m]
trace       0.2;        // height of the pressure trace above the plate [m]

count       2400;       // spheres
diameter    4e-3;       // [m]
density     2700;       // [kg/m3]
restitution 0.9;
wallRestitution 0.9;
friction    0.3;

settle      0.15;       // before the gas starts [s]
endTime     2;          // [s]
