\\ The second route to the tables of this folder, in PARI/GP:  gp -q check.gp < /dev/null   (about 2 s)
\\ It reads the five CSV files, recomputes every row but those of E = 2 in motions.csv, and ends with "all agree".
\\
\\   complete             PARI's ellK
\\   jacobi, incomplete   Gauss-Legendre quadrature of F(phi) = int_0^s dz / sqrt(1 + kc^2 sinh(z)^2), sinh s = tan phi
\\   motions              cos theta = c - 2 wp(t + t0), c = (1-E)/3: Weierstrass functions, one formula for all E
\\   coefficients         Picard iteration theta <- a_0 + a_1 t - int int sin theta on power series

default(realprecision, 450);
agreed = 0; failed = 0;
near(found, expected, size) = abs(found - expected) <= 1e-57 * size;
accept(good, row) = if(good, agreed++, failed++; print("differs: ", row));

\\ rows of a table without its header; numbers as typed: 171/100, 3pi/4, 150deg, -3T/4
table(name) = [strsplit(line, ",") | line <- readstr(name)][2..-1];
times(text, unit, factor) =
{
  my(part = strsplit(text, unit));
  if(#part == 1, return(text));
  Str(part[1], if(part[1] == "" || part[1] == "-", 1, ""), factor, part[2]);
}
number(text, T) = eval(times(times(times(text, "pi", "*Pi"), "deg", "*Pi/180"), "T", Str("*(", T, ")")));

complete(row) =
{
  my([kc, K, Kc] = apply(eval, row));
  accept(near(ellK(sqrt(1 - kc^2)), K, K) && near(ellK(kc), Kc, Kc), row);
}

\\ n half turns (2K each), and F at the amplitude with tangent x within a branch
turns(n, kc) = if(n, 2 * n * ellK(sqrt(1 - kc^2)), 0);
legendre() = { localprec(80); intnumgaussinit(60); }
nodes = legendre();
branch(x, kc) =
{
  my(s = asinh(x), pieces = ceil(2 * abs(s)) + 1);
  localprec(80);
  sum(j = 1, pieces, intnumgauss(z = (j-1) * s / pieces, j * s / pieces, 1 / sqrt(1 + (kc * sinh(z))^2), nodes));
}
jacobi(row) =
{
  my([u, kc, am, sn, cn, dn] = apply(eval, row), n = round(u / turns(1, kc)));
  accept(near(turns(n, kc) + branch(sn / cn, kc), u, abs(u)) && near(n * Pi + atan(sn / cn), am, abs(am))
    && near((-1)^n * sqrt(sn^2 + cn^2), sign(cn), 1) && near(sqrt(cn^2 + (kc * sn)^2), dn, dn), row);
}
incomplete(row) =
{
  my([phi, kc, F] = apply(eval, row));
  accept(near(turns(round(phi / Pi), kc) + branch(tan(phi), kc), F, abs(F)), row);
}

\\ energy and starting state of a motion, from its typed columns
start(energy, gap, theta0, omega0, direction) =
{
  my(E, a, w);
  if(omega0 != "", a = number(theta0); w = eval(omega0); return([w^2 / 2 + 1 - cos(a), a, w]));
  E = if(energy != "", eval(energy), 2 - eval(gap));
  a = if(theta0 != "", number(theta0), E < 2, acos(1 - E), Pi);
  w = 2 * (E - 1 + cos(a));
  [E, a, if(abs(w) < 1e-200, 0, if(direction == "-", -1, 1) * sqrt(w))];
}
motion(row) =
{
  my([E, a, w] = start(row[1], row[2], row[3], row[4], row[5]), [theta, omega, T, tstar, R] = apply(eval, row[7..11]));
  my(c, e, curve, half, point, p, size);
  c = (1 - E) / 3;
  e = [c - 1, c + 1, c - 1 + E] / 2;
  curve = ellinit([e[1]*e[2] + e[1]*e[3] + e[2]*e[3], -e[1]*e[2]*e[3]]);
  half = if(E < 2, 2, 1) * real(curve.omega[1]);
  point = if(abs(sin(a)) < 1e-400, [round(cos(a)), 0], [cos(a), sin(a)]);
  p = ellpointtoz(curve, [(c - point[1]) / 2, point[2] * w / 4]);
  p = real(ellwp(curve, p + number(row[6], half), 1));
  size = max(1, abs(theta)) * min(1, E);
  accept(near(1 - c + 2 * p[1], 2 * sin(theta / 2)^2, size) && near(2 * p[2], sin(theta) * omega, size * max(1, abs(omega)))
    && near(half, T, T) && near(T / if(E < 2, 4, 2), tstar, T) && near(tstar^2 + (imag(curve.omega[2]) / 2)^2, R^2, R^2), row);
}

coefficients(energy, at, a) =
{
  my(theta = a[1] + a[2]*t + O(t^2), growth);
  for(j = 1, 20, theta = a[1] + a[2]*t - intformal(intformal(sin(truncate(theta) + O(t^(2*j + 1))))));
  growth = vecmax(vector(20, n, abs(a[n+21])^(1 / (n + 20))));
  for(n = 0, 40, accept(abs(polcoef(theta, n) - a[n+1]) <= 1e-55 * growth^n, [energy, at, n]));
}

apply(complete, [row | row <- table("complete.csv"), row[1] != "1"]);
apply(jacobi, table("jacobi.csv"));
apply(incomplete, table("incomplete.csv"));
apply(motion, [row | row <- table("motions.csv"), row[9] != "inf"]);
rows = table("coefficients.csv");
forstep(i = 1, #rows, 41, coefficients(rows[i][1], rows[i][2], [eval(row[4]) | row <- rows[i..i+40]]));
print("PARI/GP: ", agreed, " rows recomputed, ", if(failed, Str(failed, " differ"), "all agree"));
quit(failed > 0);
