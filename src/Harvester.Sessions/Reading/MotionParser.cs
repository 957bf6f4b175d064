using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Reading;

/// <summary>Reads the motion between frames from a label.</summary>
internal static class MotionParser
{
    private const string Field = "motion";

    /// <summary>Numbers of a row: time, position, right, forward, velocity.</summary>
    private const int PoseNumbers = 13;

    /// <summary>Numbers of a row that also has yaw rate and acceleration.</summary>
    private const int RateNumbers = PoseNumbers + 2;

    /// <summary>Numbers of a row that also has steering, throttle and brake.</summary>
    private const int ControlNumbers = RateNumbers + 3;

    /// <summary>The samples; null if the label has no motion.</summary>
    /// <exception cref="DatasetFormatException">A row is invalid.</exception>
    public static IReadOnlyList<MotionSample>? Parse(JsonFields frame) => frame.Has(Field) ? [.. frame.Rows(Field).Select(SampleOf)] : null;

    private static MotionSample SampleOf(double[] row, int index)
    {
        if (row.Length is not (PoseNumbers or RateNumbers or ControlNumbers))
        {
            throw new DatasetFormatException(
                FormattableString.Invariant(
                    $"{Field}[{index}] has {row.Length} numbers instead of {PoseNumbers}, {RateNumbers} or {ControlNumbers}."
                )
            );
        }

        var sample = new MotionSample(row[0], VectorAt(row, 1), VectorAt(row, 4), VectorAt(row, 7), VectorAt(row, 10), MotionOf(row));
        try
        {
            _ = sample.Pose;
            return sample;
        }
        catch (ArgumentException e)
        {
            throw new DatasetFormatException(
                FormattableString.Invariant($"{Field}[{index}] has no unit vectors at right angles for right and forward."),
                e
            );
        }
    }

    private static EgoMotion? MotionOf(double[] row) =>
        row.Length == PoseNumbers ? null
        : row.Length == RateNumbers ? new EgoMotion(row[13], row[14])
        : new EgoMotion(row[13], row[14])
        {
            Steering = row[15],
            Throttle = row[16],
            Brake = row[17],
        };

    private static Vector3D VectorAt(double[] row, int index) => new(row[index], row[index + 1], row[index + 2]);
}
