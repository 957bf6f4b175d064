using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>The middle of a way through a junction: a cubic curve from the end of one lane to the start of another.</summary>
internal static class WayCurve
{
    public static HermiteCurve Of(MapLane from, MapLane to)
    {
        Vector3D start = from.Centre[from.Centre.Count - 1];
        Vector3D end = to.Centre[0];
        Vector2D leaving = from.EndDirection;
        Vector2D arriving = to.StartDirection;

        // With end tangents of this length, the cubic best follows a circle through both ends: 2 chord / (1 + cos(bend / 2)).
        double bend = Math.Abs(Math.Atan2(leaving.Cross(arriving), leaving.Dot(arriving)));
        double chord = new Vector2D(end.X - start.X, end.Y - start.Y).Length;
        double length = 2 * chord / (1 + Math.Cos(bend / 2));
        return new HermiteCurve(start, end, leaving * length, arriving * length);
    }
}
