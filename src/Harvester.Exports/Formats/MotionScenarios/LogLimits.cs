using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>How much a log may have, and what its numbers may be: several times what published logs have.</summary>
internal static class LogLimits
{
    /// <summary>Largest JSON file, bytes.</summary>
    public const int JsonBytes = 32 << 20;

    /// <summary>Greatest number of steps: 20 minutes.</summary>
    public const int Steps = 12_000;

    /// <summary>Greatest number of tracks.</summary>
    public const int Tracks = 5000;

    /// <summary>Greatest number of states of all tracks.</summary>
    public const int States = 2_000_000;

    /// <summary>Greatest number of parts of the map.</summary>
    public const int Features = 50_000;

    /// <summary>Greatest number of points of the map.</summary>
    public const int Points = 1_000_000;

    /// <summary>Greatest coordinate, metres: farther away, logs are in another frame, such as that of the globe.</summary>
    public const double Coordinate = 1e6;

    /// <summary>Greatest side of a box, metres.</summary>
    public const double Side = 100;

    /// <summary>Greatest speed, metres per second.</summary>
    public const double Speed = 200;

    /// <summary>Rejects what is beyond a limit.</summary>
    /// <param name="isWithin">Whether it is within.</param>
    /// <param name="problem">The problem, a sentence about the file, which is "it".</param>
    /// <exception cref="DatasetFormatException">It is not.</exception>
    public static void Require(bool isWithin, string problem)
    {
        if (!isWithin)
        {
            throw new DatasetFormatException(problem);
        }
    }

    /// <summary>A number of a log, if it is finite and within a limit.</summary>
    /// <exception cref="DatasetFormatException">It is not.</exception>
    public static double Within(double value, double limit, string name) =>
        Math.Abs(value) <= limit
            ? value
            : throw new DatasetFormatException(FormattableString.Invariant($"{name} is {value}, which is not from {-limit} to {limit}."));
}
