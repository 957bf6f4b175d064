using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Validation;

/// <summary>
/// Checks the action of a frame: it lies after the frame, its ticks ascend, its controls are in their ranges, and only an answer has a
/// delay.
/// </summary>
internal static class DriveCheck
{
    public static IEnumerable<string> Problems(FrameLabel label)
    {
        if (label.Drive is not { } drive)
        {
            yield break;
        }

        if (IsOutOfRange(drive.Controls) || IsOutOfRange(drive.Applied))
        {
            yield return "drive has a control outside its range.";
        }

        if (drive.Controls is null != drive.AnswerSeconds is null)
        {
            yield return "drive must have controls and answerSeconds, or neither.";
        }

        if (drive.AnswerSeconds < 0)
        {
            yield return FormattableString.Invariant($"drive.answerSeconds is {drive.AnswerSeconds}; it must be 0 or more.");
        }

        if (drive.Route is null != drive.RouteMetres is null)
        {
            yield return "drive must have route and routeMetres, or neither.";
        }

        double before = label.TimeSeconds;
        for (int i = 0; i < drive.Ticks.Count; i++)
        {
            if (drive.Ticks[i].TimeSeconds <= before)
            {
                yield return FormattableString.Invariant($"drive.ticks[{i}] is not after what precedes it.");
            }

            if (IsOutOfRange(drive.Ticks[i].Applied))
            {
                yield return FormattableString.Invariant($"drive.ticks[{i}] has a control outside its range.");
            }

            before = drive.Ticks[i].TimeSeconds;
        }

        if (drive.Ticks.Count > 0 && drive.Driver != drive.Ticks[0].Driver)
        {
            yield return "drive.driver is not the driver of the first tick.";
        }
    }

    private static bool IsOutOfRange(DriveControls? controls) =>
        controls is { Steering: < -1 or > 1 } or { Throttle: < 0 or > 1 } or { Brake: < 0 or > 1 };
}
