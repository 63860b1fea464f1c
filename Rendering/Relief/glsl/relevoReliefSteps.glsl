bool reliefMeetTile()
{
  return reliefMeetTileLinearly();
}
