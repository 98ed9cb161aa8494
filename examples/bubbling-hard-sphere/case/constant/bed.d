// Bed (d) of Hoomans et al. (1996): 40,000 spheres of glass. Theirs has a jet of 2.5 over 0.5 m/s, for 200 ms.
width       0.195;      // [m]
height      0.3;        // [m]
// From front to back 7.97e-4 m: a packing of area fraction 0.83 has a void fraction of 0.41 in it.
back        -3.985e-4;
front       3.985e-4;
jetFrom     0.09;       // three cells of the plate [m]
jetTo       0.105;      // [m]
sideCells   18;         // on each side of the jet
jetCells    3;
cellsUp     60;
jet         2.8;        // superficial velocity, five times that of minimum fluidisation [m/s]
background  0.56;       // the same beside the jet [m/s]
jetGas      constant (0 $jet 0);          // gas at the jet against time
plateGas    constant (0 $background 0);   // the same beside the jet
plateVoid   1;          // void fraction at jet and plate
middle      0.0975;     // of the width [m]
trace       0.1;        // height of the pressure trace above the plate [m]

count       40000;      // spheres
diameter    8.5e-4;     // [m]
density     2930;       // [kg/m3]
restitution 0.96;
wallRestitution 0.86;
friction    0.15;

settle      0.03;       // before the gas starts [s]
endTime     0.5;        // [s]
