// Tests on which side of a projected edge the ray is. All cells around an edge get the same result:
// it is computed in the order of the points' ids, and a ray through an edge or a corner is treated
// as moved slightly aside, always in the same direction.

uniform samplerBuffer meshPoints;

struct Corner
{
  uint id;
  vec3 at; // in the ray's coordinates
};

const Corner NoCorner = Corner(0u, vec3(0.0));

Corner getCorner(uint id)
{
  return Corner(id, seenAlongRay(texelFetch(meshPoints, int(id)).xyz));
}

float cross2(vec2 a, vec2 b)
{
  return a.x * b.y - a.y * b.x;
}

// Return twice the area spanned by the ray and the edge from a to b; it is positive if the ray is
// on the left.
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
