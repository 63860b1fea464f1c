// Tests whether the first light is visible from a point of the surface, by traversing the squares
// of the grid of tiles.
uniform isamplerBuffer reliefTileGrid; // indices of tiles, or -1
uniform samplerBuffer reliefPlaces;
uniform int reliefTilesPerRow;
uniform vec4 reliefGrid; // first column and row, numbers of squares along rows and columns
uniform vec4 reliefLamp; // position of the light, or direction to it

// The start is offset so that the point's own surface is not hit.
const float reliefShadowStart = 0.25;

bool reliefIsTileInTheWay(ivec2 square, float start, float end)
{
  int tile = texelFetch(reliefTileGrid, square.y * int(reliefGrid.z) + square.x).r;
  if (tile < 0)
  {
    return false;
  }
  reliefBox = texelFetch(reliefPlaces, tile);
  reliefTile = ivec4(tile, (tile % reliefTilesPerRow) * RELIEF_TEXELS,
    (tile / reliefTilesPerRow) * RELIEF_TEXELS, 0);
  reliefCutBox(reliefBox.xyz - reliefTolerance,
    vec3(reliefBox.xy + float(RELIEF_SIZE), reliefBox.w) + reliefTolerance);
  reliefRange = vec2(max(reliefRange.x, start), min(reliefRange.y, end));
  return reliefRange.x <= reliefRange.y && reliefMeetTile();
}

bool reliefIsInTheWay(float most)
{
  ivec2 last = ivec2(reliefGrid.zw) - 1;
  vec2 place = (reliefOrigin.xy - reliefGrid.xy) / float(RELIEF_SIZE);
  ivec2 square = clamp(ivec2(floor(place)), ivec2(0), last);
  ivec2 sign = ivec2(reliefDirection.x < 0.0 ? -1 : 1, reliefDirection.y < 0.0 ? -1 : 1);
  vec2 reciprocal = reliefInverse().xy;
  vec2 line = reliefGrid.xy + float(RELIEF_SIZE) * vec2(square + max(sign, ivec2(0)));
  vec2 next = (line - reliefOrigin.xy) * reciprocal;
  for (int i = 0; i <= last.x + last.y + 2; ++i)
  {
    float exit = min(min(next.x, next.y), most);
    if (reliefIsTileInTheWay(square, reliefShadowStart, exit + reliefTolerance))
    {
      return true;
    }
    bool alongRow = next.x < next.y;
    square += alongRow ? ivec2(sign.x, 0) : ivec2(0, sign.y);
    next += abs(reciprocal) * float(RELIEF_SIZE) * (alongRow ? vec2(1.0, 0.0) : vec2(0.0, 1.0));
    if (exit >= most || any(lessThan(square, ivec2(0))) || any(greaterThan(square, last)))
    {
      return false;
    }
  }
  return false;
}

// Return the fraction of the first light that is visible. The fragment's point does not change.
float reliefLight()
{
  vec3 point = reliefPoint;
  vec2 place = reliefPlace;
  vec4 box = reliefBox;
  ivec4 tile = reliefTile;
  bool isFront = reliefIsFront;
  vec3 along = reliefLamp.xyz - point * reliefLamp.w;
  reliefOrigin = point;
  reliefDirection = normalize(along);
  reliefToPass = 0;
  reliefPassed = -1e30;
  bool isHidden = reliefIsInTheWay(reliefLamp.w > 0.0 ? length(along) / reliefLamp.w : 1e30);
  reliefPoint = point;
  reliefPlace = place;
  reliefBox = box;
  reliefTile = tile;
  reliefIsFront = isFront;
  return isHidden ? 0.0 : 1.0;
}
