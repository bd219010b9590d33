% Reads results/reference_problems/NAME.txt: octave read_reference.m NAME.txt
% Octave's numbers are doubles: `value` holds the nearest ones, `text` all digits.
file = fopen(argv(){1}, "r");
names = text = {};
while ischar(line = fgetl(file))
  if line(1) == "#"
    names = strsplit(strtrim(line(2:end)), " ");  % the last comment names the columns
  else
    text(end + 1, :) = strsplit(line, " ");
  end
end
fclose(file);
value = str2double(text);
printf("%s ", names{:});
printf("\n");
for k = 1:rows(value)
  printf("%.17g ", value(k, :));
  printf("\n");
end
