using Harvester.Geometry;

namespace Harvester.Simulation.Models;

/// <summary>A model's box, in which points are given by fractions: 0 is rear, left, bottom and 1 is front, right, top.</summary>
internal readonly record struct ModelFrame(Vector3D Min, Vector3D Max)
{
    public double Width => Max.X - Min.X;

    public double Length => Max.Y - Min.Y;

    public double Height => Max.Z - Min.Z;

    public Vector3D At(double right, double forward, double up) => new(X(right), Y(forward), Z(up));

    // A weighted sum of both ends, so that 0 and 1 give the ends exactly.
    public double X(double fraction) => (Min.X * (1 - fraction)) + (Max.X * fraction);

    public double Y(double fraction) => (Min.Y * (1 - fraction)) + (Max.Y * fraction);

    public double Z(double fraction) => (Min.Z * (1 - fraction)) + (Max.Z * fraction);
}
