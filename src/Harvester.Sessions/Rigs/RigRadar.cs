using Harvester.Geometry;

namespace Harvester.Sessions.Rigs;

/// <summary>A radar of a rig, which sees a sector ahead of it.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Mount">Its pose relative to the rig's origin, in the vehicle's axes: x right, y forward, z up; metres.</param>
/// <param name="AzimuthDegrees">Width of the sector, degrees, 1 to 180.</param>
/// <param name="ElevationDegrees">Height of the sector, degrees, 1 to 60.</param>
/// <param name="RangeMetres">Distance up to which it detects what reflects like 10 m², metres.</param>
public sealed record RigRadar(string Name, Pose Mount, double AzimuthDegrees, double ElevationDegrees, double RangeMetres)
{
    /// <summary>Cells across the sector: those of the angular resolution.</summary>
    public int Columns => (int)Math.Ceiling(AzimuthDegrees / AzimuthStepDegrees);

    /// <summary>Rays of one moment: in each cell, columns of them over the height of the sector.</summary>
    public int Rays => Columns * RaysPerCell * Rows;

    /// <summary>Columns of rays in a cell.</summary>
    internal const int RaysPerCell = 2;

    /// <summary>Rays over the height of the sector.</summary>
    internal const int Rows = 7;

    /// <summary>Angular resolution, degrees: what is in the same cell of angle and range is one detection.</summary>
    public double AzimuthStepDegrees { get; init; } = 1.6;

    /// <summary>Resolution of the range, metres.</summary>
    public double RangeStepMetres { get; init; } = 0.4;

    /// <summary>Standard deviation of the range, metres; 0 for exact ranges.</summary>
    public double RangeNoiseMetres { get; init; }

    /// <summary>Standard deviation of the azimuth, degrees; 0 for exact azimuths.</summary>
    public double AzimuthNoiseDegrees { get; init; }

    /// <summary>Standard deviation of the radial velocity, m/s; 0 for exact velocities.</summary>
    public double VelocityNoise { get; init; }

    /// <summary>Fraction of the detections of objects that also appear as a ghost, 0 to 1.</summary>
    public double GhostFraction { get; init; }

    /// <summary>Mean number of false detections of a moment, 0 to 1000.</summary>
    public double Clutter { get; init; }

    /// <summary>The most detections of a moment, 1 to 1000; the strongest are kept.</summary>
    public int MaxDetections { get; init; } = 125;
}
