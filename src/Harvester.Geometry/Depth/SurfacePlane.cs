namespace Harvester.Geometry.Depth;

/// <summary>
/// A plane in the frame of an eye: the points p with <see cref="Normal"/> · p = 1. The depth at which a line of sight through the eye, of
/// any direction d, meets it is therefore 1 / (Normal · d). The default is the plane at infinity.
/// </summary>
/// <param name="Normal">Normal of the plane divided by its distance from the eye, 1/m.</param>
public readonly record struct SurfacePlane(Vector3D Normal)
{
    /// <summary>Cosine of the angle of incidence below which a plane is seen too much from its edge to be extended.</summary>
    private const double MinCosine = 0.01;

    /// <summary>
    /// The plane of a surface that was hit. Without a usable normal it is the plane at right angles to the line from the eye.
    /// </summary>
    /// <param name="point">The hit in the eye's frame, metres; not the eye itself.</param>
    /// <param name="normal">Unit normal of the surface in the same frame, to either side; zero if unknown.</param>
    public static SurfacePlane Of(Vector3D point, Vector3D normal)
    {
        // n · p = n · point for all p of the surface; dividing by n · point gives Normal · p = 1. The plane across the line of sight has n
        // = point / |point|, and so Normal = point / |point|².
        double along = normal.Dot(point);
        return Math.Abs(along) > MinCosine * point.Length
            ? new SurfacePlane(normal / along)
            : new SurfacePlane(point / point.LengthSquared);
    }

    /// <summary>The inverse of the depth at which a line of sight meets the plane; 0 or less if it does not.</summary>
    public double InverseAt(SightLine line)
    {
        // Normal · (origin + t·direction) = 1 gives 1 / t = Normal · direction / (1 - Normal · origin). With 1 - Normal · origin ≤ 0 the
        // origin lies on or behind the plane.
        double ahead = 1 - Normal.Dot(line.Origin);
        return ahead > 0 ? Normal.Dot(line.Direction) / ahead : 0;
    }
}
