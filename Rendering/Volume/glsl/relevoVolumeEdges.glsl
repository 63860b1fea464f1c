// On which side of an edge, as the ray sees it, the ray is. All cells around an edge get the same
// answer: it is computed in the order of the points' numbers, and a ray through an edge or a corner
// counts as moved aside a little, always in the same direction.

uniform samplerBuffer meshPoints;

struct Corner
{
  uint id;
  vec3 at; // as the ray sees it
};

Corner getCorner(uint id)
{
  return Corner(id, seenAlongRay(texelFetch(meshPoints, int(id)).xyz));
}

float cross2(vec2 a, vec2 b)
{
  return a.x * b.y - a.y * b.x;
}

// Twice the area that the ray and the edge from a to b span: more than 0 if the ray is on the left.
float spannedArea(uint idA, vec2 a, uint idB, vec2 b)
{
  return idA < idB ? cross2(a, b) : -cross2(b, a);
}

bool isOnLeft(float area, uint idA, vec2 a, uint idB, vec2 b)
{
  if (area != 0.0)
  {
    return area > 0.0;
  }
  return a.y > b.y || (a.y == b.y && (a.x < b.x || (a.x == b.x && idA < idB)));
}
