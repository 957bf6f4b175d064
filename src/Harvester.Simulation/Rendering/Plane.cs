namespace Harvester.Simulation.Rendering;

/// <summary>A side of a view frustum: points with X·x + Y·y + Z·z + W ≥ 0 are inside.</summary>
internal readonly record struct Plane(double X, double Y, double Z, double W)
{
    public bool IsOutside(in Bounds box) =>
        At(X >= 0 ? box.Max.X : box.Min.X, Y >= 0 ? box.Max.Y : box.Min.Y, Z >= 0 ? box.Max.Z : box.Min.Z) < 0;

    public bool IsInside(in Bounds box) =>
        At(X >= 0 ? box.Min.X : box.Max.X, Y >= 0 ? box.Min.Y : box.Max.Y, Z >= 0 ? box.Min.Z : box.Max.Z) >= 0;

    private double At(double x, double y, double z) => (X * x) + (Y * y) + (Z * z) + W;
}
