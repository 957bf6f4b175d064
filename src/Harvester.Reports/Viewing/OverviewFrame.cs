using System.Globalization;
using Harvester.Geometry.Lanes;
using Harvester.Reports.Sessions;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Reports.Viewing;

/// <summary>What the viewer keeps of every frame: the numbers of its plots and filters.</summary>
/// <param name="Frame">Number of the frame.</param>
/// <param name="Moment">Number of the moment; that of the frame without a rig.</param>
/// <param name="View">Number of the camera in the rig, from 1; 0 without one.</param>
/// <param name="Values">
/// Time, speed, position x and y, heading, yaw rate, acceleration, steering, throttle, brake, then the indicators in the order of their
/// table; NaN for what is not known.
/// </param>
/// <param name="Objects">The objects.</param>
internal sealed record OverviewFrame(int Frame, int Moment, int View, float[] Values, OverviewObject[] Objects)
{
    private const int EgoValues = 10;
    private const int Numbers = 4;

    /// <summary>Length of <see cref="Values"/>.</summary>
    public static int ValueCount { get; } = EgoValues + IndicatorTable.Count;

    /// <summary>The size of the frame in its block, bytes.</summary>
    public int Bytes => sizeof(float) * (Values.Length + Numbers) + OverviewObject.Bytes * Objects.Length;

    /// <summary>Takes the numbers from a label.</summary>
    /// <param name="label">The label.</param>
    /// <param name="views">Names of the rig's cameras.</param>
    public static OverviewFrame Of(FrameLabel label, IReadOnlyList<string> views)
    {
        EgoMotion? motion = label.Ego.Motion;
        LaneIndicators? indicators = label.Lanes?.Indicators;
        return new OverviewFrame(
            label.Frame,
            label.Moment ?? label.Frame,
            label.View is { } view ? views.ToList().IndexOf(view) + 1 : 0,
            [
                (float)label.TimeSeconds,
                Single(label.Ego.Velocity.Length),
                (float)label.Ego.Position.X,
                (float)label.Ego.Position.Y,
                (float)label.Ego.HeadingDegrees,
                Single(motion?.YawRate),
                Single(motion?.Acceleration),
                Single(motion?.Steering),
                Single(motion?.Throttle),
                Single(motion?.Brake),
                .. IndicatorTable.All.Select(indicator => indicators is { } known ? Single(indicator.Of(known)) : float.NaN),
            ],
            [.. label.Objects.Select(OverviewObject.Of)]
        );
    }

    /// <summary>A value with the decimals of a report, whose page shows the same.</summary>
    private static float Single(double? value) =>
        value is { } known
            ? float.Parse(InvariantNumber.Format(known, ReportFrame.PlottedDecimals), CultureInfo.InvariantCulture)
            : float.NaN;

    private static float Single(Indicator value) => Single(value.IsValid ? value.Value : null);
}
