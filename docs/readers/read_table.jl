# Reads a table of Libration into BigFloat: julia read_table.jl TABLE.csv
using DelimitedFiles
setprecision(BigFloat, 256)  # bits, before the first number is read

cells, names = readdlm(ARGS[1], ',', String, header=true)
number(cell) = something(tryparse(BigFloat, cell), cell)  # from the decimal text itself, never through a Float64
columns = Dict(name => number.(cells[:, i]) for (i, name) in enumerate(vec(names)))

for name in vec(names)
    println(name, " ", columns[name][1])
end
