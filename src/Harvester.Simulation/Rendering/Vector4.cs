namespace Harvester.Simulation.Rendering;

/// <summary>Homogeneous coordinates, or a row of a matrix.</summary>
internal readonly record struct Vector4(double X, double Y, double Z, double W)
{
    public static Vector4 operator +(Vector4 a, Vector4 b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z, a.W + b.W);

    public static Vector4 operator -(Vector4 a, Vector4 b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z, a.W - b.W);

    public static Vector4 operator *(Vector4 a, double factor) => new(a.X * factor, a.Y * factor, a.Z * factor, a.W * factor);
}
