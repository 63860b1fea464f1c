// A lookup table, for vertex and fragment shaders.

// colours, then those for values below and above the range and for NaN
uniform samplerBuffer relevoColorTable;
uniform float relevoTableMinimum;       // minus the bias; a logarithm for a log scale
uniform float relevoTableSpan;          // maximum - minimum
uniform int relevoTableColors;          // number of colours of the table
uniform int relevoTableLog;             // 1 for a log scale

vec4 relevoTableColor(float value)
{
  if (relevoTableLog == 1)
  {
    // As in VTK, values without a logarithm are mapped to the lower end.
    value = value > 0.0 ? log2(value) * 0.30102999566 : (value <= 0.0 ? relevoTableMinimum : value);
  }
  float t = (value - relevoTableMinimum) / relevoTableSpan;
  int index = clamp(int(floor(t * float(relevoTableColors))), 0, relevoTableColors - 1);
  index = t < 0.0 ? relevoTableColors : (t > 1.0 ? relevoTableColors + 1 : index);
  index = value != value ? relevoTableColors + 2 : index;
  return texelFetch(relevoColorTable, index);
}
