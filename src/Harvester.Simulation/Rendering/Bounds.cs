using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// A box with sides along the axes of its frame. The default value is a point at the origin; start from <see cref="Empty"/> to accumulate.
/// </summary>
internal readonly record struct Bounds(Vector3D Min, Vector3D Max)
{
    public static Bounds Empty { get; } =
        new(
            new(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity),
            new(double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity)
        );

    public Vector3D Centre => (Min + Max) * 0.5;

    /// <summary>Half of the surface area: proportional to the probability that a ray hits the box.</summary>
    public double HalfArea
    {
        get
        {
            Vector3D size = Max - Min;
            return size.X < 0 ? 0 : (size.X * size.Y) + (size.Y * size.Z) + (size.Z * size.X);
        }
    }

    public static Bounds Of(in MeshTriangle triangle) => Empty.With(triangle.A).With(triangle.B).With(triangle.C);

    public Bounds With(Vector3D point) =>
        new(
            new(Math.Min(Min.X, point.X), Math.Min(Min.Y, point.Y), Math.Min(Min.Z, point.Z)),
            new(Math.Max(Max.X, point.X), Math.Max(Max.Y, point.Y), Math.Max(Max.Z, point.Z))
        );

    public Bounds With(Bounds other) => With(other.Min).With(other.Max);

    /// <summary>Distance of a point from the box; 0 inside it.</summary>
    public double DistanceTo(Vector3D point)
    {
        Vector3D outside = new(
            Math.Max(Math.Max(Min.X - point.X, point.X - Max.X), 0),
            Math.Max(Math.Max(Min.Y - point.Y, point.Y - Max.Y), 0),
            Math.Max(Math.Max(Min.Z - point.Z, point.Z - Max.Z), 0)
        );
        return outside.Length;
    }

    /// <summary>The box around this one after it has been turned and moved.</summary>
    public Bounds MovedBy(Pose pose)
    {
        Vector3D half = (Max - Min) * 0.5;
        Vector3D centre = pose.ToWorld(Centre);
        Axes axes = pose.Axes;
        var reach = new Vector3D(
            (Math.Abs(axes.Right.X) * half.X) + (Math.Abs(axes.Forward.X) * half.Y) + (Math.Abs(axes.Up.X) * half.Z),
            (Math.Abs(axes.Right.Y) * half.X) + (Math.Abs(axes.Forward.Y) * half.Y) + (Math.Abs(axes.Up.Y) * half.Z),
            (Math.Abs(axes.Right.Z) * half.X) + (Math.Abs(axes.Forward.Z) * half.Y) + (Math.Abs(axes.Up.Z) * half.Z)
        );
        return new Bounds(centre - reach, centre + reach);
    }
}
