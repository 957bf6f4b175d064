using Harvester.Geometry;
using Harvester.Simulation.Crashes;

namespace Harvester.Simulation.Tests.Crashes;

/// <summary>Judges overlaps by corners alone, without the separating axes of the simulation.</summary>
internal static class RectangleOverlap
{
    /// <summary>How deep a corner of one body lies in the other at most, metres; 0 if none does.</summary>
    public static double Depth(PlanarBody first, PlanarBody second) => Math.Max(Deepest(first, second), Deepest(second, first));

    private static double Deepest(PlanarBody body, PlanarBody corners)
    {
        double deepest = 0;
        foreach (int along in new[] { -1, 1 })
        {
            foreach (int across in new[] { -1, 1 })
            {
                double x = (along * corners.HalfLength * Math.Cos(corners.Yaw)) - (across * corners.HalfWidth * Math.Sin(corners.Yaw));
                double y = (along * corners.HalfLength * Math.Sin(corners.Yaw)) + (across * corners.HalfWidth * Math.Cos(corners.Yaw));
                Vector2D offset = corners.Position + new Vector2D(x, y) - body.Position;
                double forward = (offset.X * Math.Cos(body.Yaw)) + (offset.Y * Math.Sin(body.Yaw));
                double left = (offset.Y * Math.Cos(body.Yaw)) - (offset.X * Math.Sin(body.Yaw));
                deepest = Math.Max(deepest, Math.Min(body.HalfLength - Math.Abs(forward), body.HalfWidth - Math.Abs(left)));
            }
        }

        return deepest;
    }
}
