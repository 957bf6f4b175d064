using Harvester.Geometry;

namespace Harvester.Sessions.Rigs;

/// <summary>A LiDAR of a rig: beams in a column that turns once about the sensor's up axis, clockwise seen from above.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Mount">Its pose relative to the rig's origin, in the vehicle's axes: x right, y forward, z up; metres.</param>
/// <param name="BeamsDegrees">Elevation of each beam, degrees, between -90 and 90; positive is up.</param>
/// <param name="Columns">Number of firings in one turn.</param>
/// <param name="RateHz">Turns per second.</param>
/// <param name="MinRangeMetres">Nearest distance that gives a point, metres.</param>
/// <param name="RangeMetres">Farthest distance that gives a point, metres.</param>
public sealed record RigLidar(
    string Name,
    Pose Mount,
    IReadOnlyList<double> BeamsDegrees,
    int Columns,
    double RateHz,
    double MinRangeMetres,
    double RangeMetres
)
{
    /// <summary>The predefined model that it is; null for explicit beams.</summary>
    public string? Model { get; init; }

    /// <summary>Standard deviation of the measured distance, metres; 0 for exact distances.</summary>
    public double RangeNoiseMetres { get; init; }

    /// <summary>Fraction of the points that get lost, 0 to 1.</summary>
    public double DropOutFraction { get; init; }

    /// <summary>Fraction of the rays of a turn that are cast, 0.01 to 1; the other points are interpolated.</summary>
    public double RayFraction { get; init; } = 1;

    /// <summary>
    /// Whether each firing is made from where the moving sensor was at its time; otherwise all are made at the end of the turn.
    /// </summary>
    public bool MotionDistortion { get; init; }

    /// <summary>Rays of one turn.</summary>
    public int Rays => Columns * BeamsDegrees.Count;
}
