using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Exports.Maps;

/// <summary>The line of a road in OpenDRIVE: a cubic on the ground, and its height.</summary>
internal static class OpenDriveShape
{
    private const int ElevationPieces = 8;

    /// <summary>An error of the height that is not worth several pieces, metres.</summary>
    private const double ElevationTolerance = 0.001;

    public static void Write(OpenDriveXml xml, HermiteCurve curve, double length)
    {
        // In a frame along the first tangent: p(u) = V0 u + (3Δ - 2V0 - V1) u² + (V0 + V1 - 2Δ) u³, with Δ from start to end.
        double heading = Math.Atan2(curve.StartVelocity.Y, curve.StartVelocity.X);
        Vector2D along = new(Math.Cos(heading), Math.Sin(heading));
        Vector2D first = In(along, curve.StartVelocity);
        Vector2D last = In(along, curve.EndVelocity);
        Vector2D apart = In(along, new Vector2D(curve.End.X - curve.Start.X, curve.End.Y - curve.Start.Y));
        Vector2D square = (apart * 3) - (first * 2) - last;
        Vector2D cube = first + last - (apart * 2);
        xml.Begin("planView");
        xml.Begin(
            "geometry",
            ("s", "0"),
            ("x", OpenDriveXml.Text(curve.Start.X)),
            ("y", OpenDriveXml.Text(curve.Start.Y)),
            ("hdg", OpenDriveXml.Text(heading)),
            ("length", OpenDriveXml.Text(length))
        );
        xml.Element(
            "paramPoly3",
            ("aU", "0"),
            ("bU", OpenDriveXml.Text(first.X)),
            ("cU", OpenDriveXml.Text(square.X)),
            ("dU", OpenDriveXml.Text(cube.X)),
            ("aV", "0"),
            ("bV", "0"),
            ("cV", OpenDriveXml.Text(square.Y)),
            ("dV", OpenDriveXml.Text(cube.Y)),
            ("pRange", "normalized")
        );
        xml.End();
        xml.End();
        WriteElevation(xml, curve, length);
    }

    /// <summary>
    /// The height is linear in the curve's parameter, and OpenDRIVE's in the arc length: linear between the ends of pieces of the curve,
    /// or in one piece where that is as exact.
    /// </summary>
    private static void WriteElevation(OpenDriveXml xml, HermiteCurve curve, double length)
    {
        xml.Begin("elevationProfile");
        double rise = curve.End.Z - curve.Start.Z;
        double[] stations = new double[ElevationPieces + 1];
        for (int piece = 1; piece <= ElevationPieces; piece++)
        {
            stations[piece] = stations[piece - 1] + curve.Between((piece - 1.0) / ElevationPieces, (double)piece / ElevationPieces).Length;
        }

        bool isEven = Enumerable
            .Range(0, stations.Length)
            .All(i => Math.Abs(rise * ((stations[i] / length) - ((double)i / ElevationPieces))) < ElevationTolerance);
        if (isEven)
        {
            xml.Polynomial("elevation", 0, curve.Start.Z, rise / length);
        }
        else
        {
            double risePerPiece = rise / ElevationPieces;
            for (int piece = 0; piece < ElevationPieces; piece++)
            {
                double slope = risePerPiece / (stations[piece + 1] - stations[piece]);
                xml.Polynomial("elevation", stations[piece], curve.Start.Z + (piece * risePerPiece), slope);
            }
        }

        xml.End();
    }

    private static Vector2D In(Vector2D along, Vector2D vector) => new(along.Dot(vector), along.Cross(vector));
}
