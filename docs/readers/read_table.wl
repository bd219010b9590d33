(* Reads a table of Libration into numbers of its own precision: wolframscript -file read_table.wl TABLE.csv *)
{names, rows} = {First[#], Rest[#]} & @ Import[Last[$ScriptCommandLine], {"CSV", "Data"}, "Numeric" -> False];

(* from the decimal text itself, never through a machine number: 1.5e-60 is 1.5`60*^-60 with 60 digits *)
decimal = RegularExpression["(-?[0-9]+(?:\\.[0-9]+)?)(?:e(-?[0-9]+))?"];
number[cell_String] := If[StringMatchQ[cell, decimal],
  First @ StringCases[cell, decimal :> ToExpression["$1`60"] 10^ToExpression["0" <> "$2"]], cell]

columns = AssociationThread[names -> Transpose[Map[number, rows, {2}]]];
KeyValueMap[Print[#1, " ", First[#2]] &, columns];
