using System.Xml.Linq;
using Harvester.Geometry;

namespace Harvester.Exports.Tests.Maps;

/// <summary>The line of a road of an OpenDRIVE file, and places beside it, by the format's own definitions.</summary>
internal static class OpenDriveLine
{
    private const int LengthPieces = 400;

    /// <summary>The place of an object or signal, which names its road by where it stands.</summary>
    public static Vector3D PlaceOf(XElement item, double t)
    {
        XElement road = item.Parent!.Parent!;
        (double x, double y, double heading, double z) = Under(item, road);
        return new Vector3D(x - (Math.Sin(heading) * t), y + (Math.Cos(heading) * t), z + OpenDriveLane.Number(item, "zOffset"));
    }

    /// <summary>A corner of an object, given in the object's own axes.</summary>
    public static Vector3D CornerOf(XElement item, XElement corner)
    {
        Vector3D origin = PlaceOf(item, OpenDriveLane.Number(item, "t"));
        double heading = Under(item, item.Parent!.Parent!).Heading + OpenDriveLane.Number(item, "hdg");
        (double u, double v) = (OpenDriveLane.Number(corner, "u"), OpenDriveLane.Number(corner, "v"));
        return origin
            + new Vector3D(
                (Math.Cos(heading) * u) - (Math.Sin(heading) * v),
                (Math.Sin(heading) * u) + (Math.Cos(heading) * v),
                OpenDriveLane.Number(corner, "z")
            );
    }

    private static (double X, double Y, double Heading, double Z) Under(XElement item, XElement road)
    {
        double s = OpenDriveLane.Number(item, "s");
        (double x, double y, double heading) = At(road, s / OpenDriveLane.Number(road, "length"));
        return (x, y, heading, OpenDriveLane.Polynomial(road.Element("elevationProfile")!.Elements("elevation"), s));
    }

    public static (double X, double Y, double Heading) At(XElement road, double fraction)
    {
        XElement geometry = road.Element("planView")!.Elements("geometry").Single();
        XElement curve = geometry.Element("paramPoly3")!;
        Assert.Equal("normalized", curve.Attribute("pRange")!.Value);

        // The parameter at a length, by a table of the length so far.
        double[] lengths = new double[LengthPieces + 1];
        for (int i = 1; i <= LengthPieces; i++)
        {
            (double du, double dv) = Derivative(curve, (i - 0.5) / LengthPieces);
            lengths[i] = lengths[i - 1] + (Math.Sqrt((du * du) + (dv * dv)) / LengthPieces);
        }

        double wanted = fraction * lengths[^1];
        int piece = Math.Clamp(Array.FindIndex(lengths, length => length >= wanted), 1, LengthPieces);
        double p = (piece - 1 + ((wanted - lengths[piece - 1]) / (lengths[piece] - lengths[piece - 1]))) / LengthPieces;
        (double u, double v) = (Value(curve, "U", p), Value(curve, "V", p));
        (double uSlope, double vSlope) = Derivative(curve, p);
        double start = OpenDriveLane.Number(geometry, "hdg");
        return (
            OpenDriveLane.Number(geometry, "x") + (Math.Cos(start) * u) - (Math.Sin(start) * v),
            OpenDriveLane.Number(geometry, "y") + (Math.Sin(start) * u) + (Math.Cos(start) * v),
            start + Math.Atan2(vSlope, uSlope)
        );
    }

    private static double Value(XElement curve, string axis, double p) =>
        OpenDriveLane.Number(curve, "a" + axis)
        + (
            p
            * (
                OpenDriveLane.Number(curve, "b" + axis)
                + (p * (OpenDriveLane.Number(curve, "c" + axis) + (p * OpenDriveLane.Number(curve, "d" + axis))))
            )
        );

    private static (double U, double V) Derivative(XElement curve, double p)
    {
        double Slope(string axis) =>
            OpenDriveLane.Number(curve, "b" + axis)
            + (p * ((2 * OpenDriveLane.Number(curve, "c" + axis)) + (3 * p * OpenDriveLane.Number(curve, "d" + axis))));
        return (Slope("U"), Slope("V"));
    }
}
